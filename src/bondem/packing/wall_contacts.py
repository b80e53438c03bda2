"""Rigid walls of a shape as tables of the packing passes.

Planes normal to an axis are exact, wherever they are, and so are cylinders and balls about the origin. All other
walls are given by their depth on a grid, which rounds the edges between them: spheres at two such walls lie too deep.
Where a gap between a plane and another wall is narrower than a sphere, exact walls would leave the sphere no place.
In this case the grid contains all walls.
"""

import math
from collections.abc import Callable
from itertools import product
from typing import NamedTuple

import numpy as np
from scipy.ndimage import map_coordinates, minimum_filter

from bondem._checks import shown
from bondem._tables.packing_tables import PackingWalls
from bondem._types import Floats, PerElement, PerElement3
from bondem.errors import InputError
from bondem.geometry.elementary_shapes import Ball, Box, Cell, Cylinder, Shape
from bondem.geometry.planes import Planes, box_planes, placed
from bondem.geometry.shape import Cut, Overlap, Placed
from bondem.geometry.shape_boundary import BOX_FACES
from bondem.geometry.surface import Surface

# Spacing of the grid of depths over the mean radius. It rounds edges of a shape by about as much. Walls as curved as
# a sphere have an error of 1/8 of its square: 2 % of the radius.
_SPACING = 0.4
_MOST_NODES = 250_000_000  # 2 GB; about 100 per sphere in a box, more in a shape that fills its bounds less

# Spacing of points on planes at which narrow gaps are detected, over the mean radius, and most points along an edge.
_GAP_SPACING, _MOST_ACROSS = 0.25, 400
# Number of spacings along the edges of a coarse cell; only near walls is the depth at its fine nodes evaluated.
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
    parts = _parts(shape)
    lower, upper = _box(parts.planes)
    if parts.depth is None:
        return _plain(lower, upper, flat, np.inf)
    if _has_narrow_gap(shape, lower, upper, parts.depth, radius):
        return PackingWalls(none, everywhere, flat, np.inf, *_depth_grid(shape, shape.depth, radius))
    return PackingWalls(lower, upper, flat, np.inf, *_depth_grid(shape, parts.depth, radius))


class _Parts(NamedTuple):
    """Walls of a shape: planes normal to an axis, which are exact, and the depth below all other walls, or None."""

    planes: list[Planes]
    depth: Callable[[PerElement3], PerElement] | None


def _parts(shape: Shape) -> _Parts:
    """Return the planes normal to axes between which the whole shape lies, and the depth below its other walls."""
    match shape:
        case Box():
            return _Parts([shape.planes], None)
        case Cylinder():
            return _Parts([shape.planes], lambda x: shape.face_depth("side", x))
        case Cut():
            return _joint(_parts(shape.first), _Parts([], shape.beside))
        case Overlap():
            return _joint(_parts(shape.first), _parts(shape.second))
        case Placed() if np.isin(np.abs(shape.turn), (0.0, 1.0)).all():  # rotated by right angles only
            turn, by = np.array(shape.turn), np.array(shape.by)
            inner = _parts(shape.shape)
            depth, planes = inner.depth, [placed(some, turn, by) for some in inner.planes]
            return _Parts(planes, None if depth is None else lambda x: depth((x - by) @ turn))
        case Surface():
            flat = [face for face in BOX_FACES if face in shape.faces]
            planes = [box_planes(shape.bounds, flat)]
            if "side" not in shape.faces:  # a box
                return _Parts(planes, None)
            return _Parts(planes, lambda x: _beside_planes(shape, flat, x))
    return _Parts([], shape.depth)


def _joint(one: _Parts, other: _Parts) -> _Parts:
    """Return the walls of the intersection of two shapes."""
    a, b = one.depth, other.depth
    if a is None or b is None:
        return _Parts(one.planes + other.planes, b if a is None else a)
    return _Parts(one.planes + other.planes, lambda x: np.minimum(a(x), b(x)))


def _beside_planes(shape: Surface, flat: list[str], points: PerElement3) -> PerElement:
    """Return the depth below the face "side" of a surface, continued beyond its box across the faces `flat`."""
    lower, upper = (side.copy() for side in shape.bounds)
    tiny = 1e-6 * float((upper - lower).max())
    for axis, name in enumerate("xyz"):
        lower[axis] = lower[axis] + tiny if f"{name}_min" in flat else -np.inf
        upper[axis] = upper[axis] - tiny if f"{name}_max" in flat else np.inf
    return shape.face_depth("side", np.clip(points, lower, upper))


def _box(planes: list[Planes]) -> tuple[Floats, Floats]:
    """Return lower and upper corner of the box that planes normal to the axes bound [m], infinite without a plane."""
    lower, upper = np.full(3, -np.inf), np.full(3, np.inf)
    for at, out in (plane for some in planes for plane in some.values()):
        axis = int(np.abs(out).argmax())
        if out[axis] > 0.0:
            upper[axis] = min(upper[axis], at[axis])
        else:
            lower[axis] = max(lower[axis], at[axis])
    return lower, upper


def _has_narrow_gap(
    shape: Shape, lower: Floats, upper: Floats, depth: Callable[[PerElement3], PerElement], radius: PerElement
) -> bool:
    """Return True if another wall is nearer to a plane than the largest diameter, without meeting it.

    At such a place the depth below other walls has a minimum above 0 on the plane.
    """
    low, high = shape.bounds
    step = _GAP_SPACING * float(radius.mean())
    for axis, side in product(range(3), (lower, upper)):
        if not np.isfinite(side[axis]):
            continue
        across = [
            np.linspace(low[k], high[k], min(int((high[k] - low[k]) / step) + 2, _MOST_ACROSS)) if k != axis
            else side[axis : axis + 1]
            for k in range(3)
        ]
        points = np.stack(np.meshgrid(*across, indexing="ij"), axis=-1)
        found = np.squeeze(depth(points.reshape(-1, 3)).reshape(points.shape[:3]), axis=axis)
        lowest = minimum_filter(found, size=3, mode="nearest") == found
        if (lowest & (found > 0.0) & (found < 2.0 * radius.max()))[1:-1, 1:-1].any():
            return True
    return False


def _plain(lower: Floats, upper: Floats, weight: Floats, radius: float) -> PackingWalls:
    box = np.array(lower, dtype=float), np.array(upper, dtype=float)
    return PackingWalls(*box, weight, float(radius), np.zeros(3), 0.0, np.empty((0, 0, 0)))


def _depth_grid(
    shape: Shape, depth_at: Callable[[PerElement3], PerElement], radius: PerElement
) -> tuple[Floats, float, Floats]:
    """Return first node [m], spacing [m] and depths [m] of a grid over the shape."""
    h = _SPACING * float(radius.mean())
    lower, upper = shape.bounds
    coarse = [int(n) + 3 for n in np.ceil((upper - lower) / (_COARSE * h))]
    fine = [(n - 1) * _COARSE + 1 for n in coarse]
    if math.prod(fine) > _MOST_NODES:
        raise InputError(
            f"{len(radius)} spheres are too many for the walls of {shown(shape)}; ask for fewer, or bd.carve a packed"
            " Box"
        )
    corner = 0.5 * (lower + upper) - 0.5 * h * (np.array(fine) - 1)
    rough = depth_at(corner + _COARSE * h * np.indices(coarse).reshape(3, -1).T).reshape(coarse)
    depth = np.empty(fine)
    # A depth changes no faster than the distance, which to the next coarse node is at most half a diagonal.
    farthest = 0.5 * np.sqrt(3.0) * _COARSE * h
    for i in range(fine[0]):  # by layers, for the memory
        at = np.stack(np.broadcast_arrays(i, *np.indices(fine[1:]))).reshape(3, -1)
        layer = map_coordinates(rough, at / _COARSE, order=1)
        near = (layer > -farthest - 3.0 * h) & (layer < radius.max() * 1.2 + farthest + 3.0 * h)
        layer[near] = depth_at(corner + h * at[:, near].T)
        depth[i] = layer.reshape(fine[1:])
    return corner, h, depth
