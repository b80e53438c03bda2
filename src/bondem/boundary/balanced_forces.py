"""Nodal forces with a given resultant."""

import numpy as np

from bondem._types import PerElement, PerElement3, Vector


def balanced_forces(
    arms: PerElement3, force: Vector, moment: Vector, weight: PerElement | None = None
) -> PerElement3:
    """Return the forces [N], (k, 3), of least Σ F² / weight with a given resultant and, if possible, a given moment.

    Forces act at `arms` (k, 3) [m] from the point of `moment` [N·m]. Weights (k,), such as areas, are 1 by default.
    """
    share = np.full(len(arms), 1.0 / len(arms)) if weight is None else weight / weight.sum()
    centre = share @ arms
    spread = arms - centre
    scale = np.sqrt(share @ (spread**2).sum(axis=1))
    if scale <= 1e-12 * (1.0 + np.abs(centre).max()):
        return share[:, None] * force
    # about the centroid the two problems decouple: an equal share each, and b × r for the moment
    wanted = moment - np.cross(centre, force)
    weighted = share[:, None] * spread
    inertia = (weighted * spread).sum() * np.eye(3) - spread.T @ weighted
    turn = np.linalg.pinv(inertia, rcond=1e-9, hermitian=True) @ wanted
    return np.asarray(share[:, None] * (force + np.cross(turn, spread)), dtype=float)
