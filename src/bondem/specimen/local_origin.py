"""Origin of positions in the core, near the specimen, so that digits are kept far from the origin, as in UTM."""

import numpy as np

from bondem._types import Floats
from bondem.specimen.lattice import Lattice

# Distance from the origin of coordinates over the extent of the elements, up to which they are where they are given.
_FAR = 100.0


def local_origin(lattice: Lattice) -> Floats:
    """Return the origin of positions in a state [m], (3,): zero, or near a specimen that is far from there.

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
