"""Where kernels count positions from: far from the origin of coordinates, such as in UTM, digits would be lost."""

import numpy as np

from bondem._types import Floats
from bondem.specimen.lattice import Lattice

# Distance from the origin of coordinates over the extent of the elements, up to which they are where they are given.
_FAR = 100.0


def local_origin(lattice: Lattice) -> Floats:
    """The point that positions in a state count from [m], (3,): zero, or near a specimen that is far from there.

    Its coordinates are multiples of a power of two about as large as the specimen, so that what is left of positions
    is exact.
    """
    lower, upper = lattice.centre.min(axis=0), lattice.centre.max(axis=0)
    extent = float((upper - lower).max()) + lattice.particles.mean_radius
    middle = 0.5 * (lower + upper)
    if np.abs(middle).max() <= _FAR * extent:
        return np.zeros(3)
    pitch = 2.0 ** np.ceil(np.log2(extent))
    return np.round(middle / pitch) * pitch


def local_rest(lattice: Lattice) -> Floats:
    """Centres in the reference from there [m], user's order, (n, 3)."""
    return lattice.centre - local_origin(lattice)
