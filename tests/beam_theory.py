"""Closed forms of beams that several tests compare with."""

import numpy as np


def beam_stiffness(length: float, EA: float, EI: float, GJ: float, phi: float = 0.0) -> np.ndarray:
    """12 x 12 stiffness of a beam along x (Przemieniecki 1968), (u, θ) at each end.

    Args:
        length: length [m].
        EA: axial stiffness [N].
        EI: bending stiffness [N·m²].
        GJ: torsional stiffness [N·m²].
        phi: shear flexibility Φ [-], 0 for Euler-Bernoulli beams.
    """
    K = np.zeros((12, 12))
    for u, k in ((0, EA / length), (3, GJ / length)):
        K[np.ix_([u, u + 6], [u, u + 6])] = k * np.array([[1, -1], [-1, 1]])
    for u, turn, sign in ((1, 5, 1.0), (2, 4, -1.0)):  # about y a positive rotation moves the axis to -z
        L = sign * length
        block = np.array(
            [
                [12, 6 * L, -12, 6 * L],
                [6 * L, (4 + phi) * L**2, -6 * L, (2 - phi) * L**2],
                [-12, -6 * L, 12, -6 * L],
                [6 * L, (2 - phi) * L**2, -6 * L, (4 + phi) * L**2],
            ]
        )
        ends = [u, turn, u + 6, turn + 6]
        K[np.ix_(ends, ends)] = EI / (length**3 * (1.0 + phi)) * block
    return K
