"""Nodal forces with a given resultant."""

import numpy as np

from bondem._types import PerElement3, Vector


def balanced_forces(arms: PerElement3, force: Vector, moment: Vector) -> PerElement3:
    """The smallest forces (k, 3) at `arms` (k, 3) with a given resultant, and its moment where they can."""
    count = len(arms)
    centre = arms.mean(axis=0)
    spread = arms - centre
    scale = np.sqrt((spread**2).sum() / count)
    if scale <= 1e-12 * (1.0 + np.abs(centre).max()):
        return np.tile(force / count, (count, 1))
    # about the centroid the two problems decouple: an equal share each, and b × r for the moment
    wanted = moment - np.cross(centre, force)
    inertia = (spread**2).sum() * np.eye(3) - spread.T @ spread
    turn = np.linalg.pinv(inertia, rcond=1e-9, hermitian=True) @ wanted
    return force / count + np.cross(turn, spread)
