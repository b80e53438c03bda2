"""Rigid walls of a shape, in the form that the packing kernel requires."""

import math

import numpy as np
from scipy.ndimage import map_coordinates

from bondem._types import Floats, PerElement
from bondem.errors import InputError
from bondem.kernels.packing_tables import PackingWalls
from bondem.specimen.geometry import Ball, Box, Cell, Cylinder, Shape

# Spacing of the grid of depths over the mean radius. Where the shape has an edge the wall is rounded by about
# this much, and walls as curved as a sphere are off by 1/8 of its square: 2 % of the radius.
_SPACING = 0.4
_MOST_NODES = 250_000_000  # 2 GB; about 100 a sphere in a box, more in a shape that fills its bounds less

# Each coarse cell has this many spacings along its edges; only near walls are its nodes asked one by one.
_COARSE = 4


def walls(shape: Shape, radius: PerElement) -> PackingWalls:
    """Return the walls of `shape` for spheres of `radius` (n,) [m].

    Raises:
        InputError: There are too many spheres for a grid of depths.
    """
    none, everywhere, flat = np.full(3, -np.inf), np.full(3, np.inf), np.zeros(3)
    lower, upper = shape.bounds
    match shape:
        case Box():
            return _plain(lower, upper, flat, np.inf)
        case Cylinder():
            ends = np.array([lower[0], -np.inf, -np.inf]), np.array([upper[0], np.inf, np.inf])
            return _plain(*ends, np.array([0.0, 1.0, 1.0]), shape.radius)
        case Ball():
            return _plain(none, everywhere, np.ones(3), shape.radius)
        case Cell():
            return _plain(none, everywhere, flat, np.inf)
    return PackingWalls(none, everywhere, flat, np.inf, *_depth_grid(shape, radius))


def _plain(lower: Floats, upper: Floats, weight: Floats, radius: float) -> PackingWalls:
    return PackingWalls(lower.copy(), upper.copy(), weight, float(radius), np.zeros(3), 0.0, np.empty((0, 0, 0)))


def _depth_grid(shape: Shape, radius: PerElement) -> tuple[Floats, float, Floats]:
    """Return first node [m], spacing [m] and depths [m] of a grid over the shape."""
    h = _SPACING * float(radius.mean())
    lower, upper = shape.bounds
    coarse = [int(n) + 3 for n in np.ceil((upper - lower) / (_COARSE * h))]
    fine = [(n - 1) * _COARSE + 1 for n in coarse]
    if math.prod(fine) > _MOST_NODES:
        raise InputError(
            f"{len(radius)} spheres are too many for the walls of {shape}; ask for fewer, or bd.carve a packed Box"
        )
    corner = 0.5 * (lower + upper) - 0.5 * h * (np.array(fine) - 1)
    rough = shape.depth(corner + _COARSE * h * np.indices(coarse).reshape(3, -1).T).reshape(coarse)
    depth = np.empty(fine)
    # Depths change no faster than distance, and between coarse nodes half a diagonal is the farthest from one.
    farthest = 0.5 * np.sqrt(3.0) * _COARSE * h
    for i in range(fine[0]):  # by layers, for the memory
        at = np.stack(np.broadcast_arrays(i, *np.indices(fine[1:]))).reshape(3, -1)
        layer = map_coordinates(rough, at / _COARSE, order=1)
        near = (layer > -farthest - 3.0 * h) & (layer < radius.max() * 1.2 + farthest + 3.0 * h)
        layer[near] = shape.depth(corner + h * at[:, near].T)
        depth[i] = layer.reshape(fine[1:])
    return corner, h, depth
