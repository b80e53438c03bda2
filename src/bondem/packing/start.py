"""Where a packing begins: radii by a size law and centres at random."""

import numpy as np

from bondem._types import Floats
from bondem.errors import InputError
from bondem.specimen.geometry import Shape


def uniform_radii(count: int, spread: float, random: np.random.Generator) -> Floats:
    """Radii uniform in 1 ± spread/2 (André et al. 2012, eq 10), relative to their mean, shape (count,)."""
    return 1.0 + spread * (random.random(count) - 0.5)


def random_centres(shape: Shape, radius: Floats, random: np.random.Generator) -> Floats:
    """Centres [m], uniform over the part of `shape` in which a sphere of its radius [m] fits, (n, 3).

    Raises:
        InputError: the largest sphere does not fit.
    """
    lower, upper = shape.bounds
    centre = np.empty((len(radius), 3))
    missing = np.arange(len(radius))
    for _ in range(1000):
        centre[missing] = lower + (upper - lower) * random.random((len(missing), 3))
        missing = missing[shape.depth(centre[missing]) < radius[missing]]
        if not missing.size:
            return centre
    raise InputError(
        f"spheres of radius {radius.max():.3g} m do not fit into {shape}; ask for more spheres or a larger shape"
    )


def morton_order(centre: Floats, lower: Floats, upper: Floats) -> np.ndarray:
    """Order of points (n, 3) along a Z curve with 2^20 steps over the longest edge: near in space, near in memory."""
    step = (upper - lower).max() / 2.0**20
    grid = np.minimum((centre - lower) / step, 2.0**20 - 1.0).astype(np.uint64)
    key = np.zeros(len(centre), np.uint64)
    for bit in range(20):
        for axis in range(3):
            key |= ((grid[:, axis] >> np.uint64(bit)) & np.uint64(1)) << np.uint64(3 * bit + axis)
    return np.argsort(key, kind="stable")
