"""Laws of softening, cracks and yielding over arrays of samples, each evaluated by the core."""

import math
from typing import NamedTuple

import numpy as np

from bondem._core import Pass


class SofteningSamples(NamedTuple):
    """Facets that may soften."""

    traction: np.ndarray
    normal: np.ndarray
    stress: np.ndarray
    bent: np.ndarray
    integrity: np.ndarray
    strength: np.ndarray
    kink: float
    steep: float
    wide: bool
    left: np.ndarray


class CrackSamples(NamedTuple):
    """Cracks of any integrity."""

    given: np.ndarray
    wide: bool
    found: np.ndarray


class YieldSamples(NamedTuple):
    """Cells that may yield."""

    stress: np.ndarray
    strength: np.ndarray
    cone: bool
    wide: bool
    found: np.ndarray


class StressBoundSamples(NamedTuple):
    """Stresses and their bounds."""

    stress: np.ndarray
    bent: np.ndarray
    wide: bool
    found: np.ndarray


evaluate_softening = Pass("evaluate_softening", SofteningSamples)
evaluate_cracks = Pass("evaluate_cracks", CrackSamples)
evaluate_yielding = Pass("evaluate_yielding", YieldSamples)
evaluate_stress_bounds = Pass("evaluate_stress_bounds", StressBoundSamples)

#: Places of the components xx, yy, zz, xy, xz, yz in a matrix.
ROW, COLUMN = [0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]


def softening(
    s: float, traction, normal, stress, *, strength: float, last: float, bent: float = 0.0, kink: float = 0.0,
    steep: float = 1.0, plane: bool = False, cohesion: float = math.inf, last_slip: float = math.inf,
    friction: float = 0.0,
) -> tuple[float, float]:  # fmt: skip
    """Return the integrity of one facet under a load, at most s, and the traction below which none softens it [Pa].

    Args:
        s: present integrity.
        traction: traction that the facet would have if it were whole [Pa].
        normal: normal of the facet.
        stress: mean stress of its cells [Pa], (3, 3).
        strength: strength in tension [Pa].
        last: traction of the whole facet at its last opening [Pa].
        bent: rms of the tractions of bending [Pa].
        kink, steep: parameters of the softening curve.
        plane: whether the facet belongs to a material plane.
        cohesion, last_slip, friction: cohesion of a plane [Pa], `last` of its slip [Pa], and tan φ.
    """
    column = [strength, 1.0 / last, cohesion, 1.0 / last_slip, friction, float(plane)]
    samples = SofteningSamples(
        *(np.array(of, dtype=float).reshape(3, 1) for of in (traction, normal)),
        np.asarray(stress, dtype=float)[ROW, COLUMN].reshape(6, 1), np.array([bent]), np.array([s]),
        np.array(column).reshape(6, 1), kink, steep, False, np.empty((2, 1)),
    )  # fmt: skip
    evaluate_softening(samples)
    left, least = samples.left[:, 0].tolist()
    return left, least


def left_in_bulk(s: float, traction, normal, stress, **options) -> float:
    """Return the integrity of a facet of the material under a load (`softening`)."""
    return softening(s, traction, normal, stress, **options)[0]


def left_on_plane(s: float, traction, normal, **options) -> float:
    """Return the integrity of a facet of a material plane under a load (`softening`)."""
    return softening(s, traction, normal, np.zeros((3, 3)), plane=True, **options)[0]


def softened(s: float, traction: float, strength: float, last: float, kink: float, steep: float) -> float:
    """Return the integrity that a traction across a facet leaves by the softening curve alone."""
    across = 1.0, 0.0, 0.0
    return left_on_plane(
        s, (traction, 0.0, 0.0), across, strength=strength, last=last, kink=kink, steep=steep
    )  # fmt: skip


def yielding(stress: np.ndarray, strength: np.ndarray, *, cone: bool) -> np.ndarray:
    """Return the bound of F [Pa], Δγ, the plastic strain and the principal stresses [Pa] of cells, (11, m).

    Args:
        stress: stresses xx, yy, zz, xy, xz, yz [Pa], (6, m).
        strength: strength [Pa], slope, dilation and stiffness [Pa] of each cell, (4, m).
        cone: whether by Drucker and Prager.
    """
    found = np.empty((11, stress.shape[1]))
    evaluate_yielding(YieldSamples(np.ascontiguousarray(stress), np.ascontiguousarray(strength), cone, False, found))
    return found


def stress_bounds(stress: np.ndarray, bent: np.ndarray) -> np.ndarray:
    """Return bounds of stresses and of what bending opens [Pa], (5, m).

    Args:
        stress: stresses xx, yy, zz, xy, xz, yz [Pa], (6, m).
        bent: rms of the tractions of bending [Pa], (m,).

    Returns:
        Bounds of the largest and the least principal stress, another bound of the largest, bending less the largest
        pressure, at least 0, and a bound of that.
    """
    found = np.empty((5, len(bent)))
    evaluate_stress_bounds(StressBoundSamples(np.ascontiguousarray(stress), bent, False, found))
    return found
