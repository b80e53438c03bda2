"""Local origin of positions near the specimen, so that a specimen far from the global origin loses no digits."""

import numpy as np

from bondem._types import Floats
from bondem.specimen.lattice import Lattice

# Largest distance from the global origin, over the extent of the elements, without a local origin.
_FAR = 100.0


def local_origin(lattice: Lattice) -> Floats:
    """Return the origin of positions in a state [m], (3,): zero, or near a specimen that is far from zero.

    Its coordinates are multiples of a power of two about as large as the specimen, so that differences of positions
    are exact.
    """
    lower, upper = lattice.centre.min(axis=0), lattice.centre.max(axis=0)
    extent = float((upper - lower).max()) + lattice.particles.mean_radius
    middle = 0.5 * (lower + upper)
    if np.abs(middle).max() <= _FAR * extent:
        return np.zeros(3)
    pitch = 2.0 ** np.ceil(np.log2(extent))
    return np.round(middle / pitch) * pitch


def local_rest(lattice: Lattice) -> Floats:
    """Return centres in the reference relative to the local origin [m], user's order, (n, 3)."""
    return lattice.centre - local_origin(lattice)
