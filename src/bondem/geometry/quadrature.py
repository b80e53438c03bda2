"""Volume and surface of a region given by a depth function, by refinement of the cells that contain the surface.

The gradient of a depth is at most 1. A cell whose centre is deeper than half its diagonal therefore lies inside, and
only cells at the surface are halved further. The work grows with the surface, not with the volume.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from bondem._types import PerElement, PerElement3, Vector

_CELLS = 8  # first cells along the longest edge, more in thin boxes, where cubes need them
_THIN = 256  # most first cells along the longest edge
_HALVINGS = {1: 7, 2: 7, 3: 4}  # by dimension: 128 cells along the longest edge, 1024 of a flat region


@dataclass(frozen=True)
class Content:
    """Volume and surface area of a region.

    Attributes:
        volume: volume [m³]; for a flat region its area [m²].
        area: area of the surface [m²]; for a flat region the length of its outline [m].
    """

    volume: float
    area: float


def content(depth: Callable[[PerElement3], PerElement], lower: Vector, upper: Vector) -> Content:
    """Measure the region where `depth` is positive, within a box.

    Args:
        depth: distance of points (n, 3) to the surface, positive inside [m]; a lower bound is sufficient.
        lower: lower corner of the box [m], (3,).
        upper: upper corner [m], (3,); the region is flat along an axis on which both corners agree.

    Returns:
        Volume and area, with relative errors of about 1e-3 and 1e-2 for simple shapes.
    """
    axes = int(np.count_nonzero(upper > lower))
    inside = area = 0.0
    for cells in cell_levels(depth, lower, upper):
        inside += cells.size * float(cells.share.sum())
        if cells.last:
            width = cells.size ** (1.0 / axes)
            area += cells.size / width * float(np.maximum(0.0, 1.0 - np.abs(cells.depth) / width).sum())
    return Content(inside, area)


@dataclass(frozen=True, eq=False)
class GridCells:
    """Cells of one size that need no further division.

    Attributes:
        centre: centres of the cells [m], (k, 3).
        edge: edge lengths of a cell [m], (3,).
        size: volume of a cell [m³]; for a flat region its area [m²].
        depth: depths of the centres [m], (k,).
        share: share of each cell that lies in the region, 0 … 1, (k,).
        last: True for the smallest cells, which contain the surface.
    """

    centre: PerElement3
    edge: Vector
    size: float
    depth: PerElement
    share: PerElement
    last: bool


def cell_levels(depth: Callable[[PerElement3], PerElement], lower: Vector, upper: Vector) -> Iterator[GridCells]:
    """Yield the cells that make up a box, from the largest to the smallest; the arguments are those of `content`."""
    axes = np.flatnonzero(upper > lower)
    count = np.ones(3, dtype=int)
    # Cells are nearly cubes: of flat cells at a wall of the box, a part would count as outside. They fill the box
    # exactly, so that its walls are exact.
    extent = (upper - lower)[axes]
    along = np.clip(extent.max() / extent.min(), _CELLS, _THIN)
    count[axes] = np.maximum(1, np.ceil(along * extent / extent.max() * (1.0 - 1e-12))).astype(int)
    edge = (upper - lower) / count
    index = np.indices(tuple(map(int, count))).reshape(3, -1).T
    halvings = max(1, _HALVINGS[len(axes)] - round(np.log2(along / _CELLS)))
    finest = edge.max() / 2**halvings
    for level in range(halvings + 1):
        centre = lower + (index + 0.5) * edge
        d = depth(centre)
        size, half = float(np.prod(edge[axes])), 0.5 * float(np.linalg.norm(edge))
        if level == halvings:
            width = size ** (1.0 / len(axes))
            yield GridCells(centre, edge, size, d, np.clip(0.5 + d / width, 0.0, 1.0), True)
            return
        cut = np.abs(d) < half + finest
        yield GridCells(centre[~cut], edge, size, d[~cut], (d[~cut] > 0.0).astype(float), False)
        index, edge = _halved(index[cut], axes), 0.5 * edge


def _halved(index: np.ndarray, axes: np.ndarray) -> np.ndarray:
    for axis in axes:
        step = np.zeros(3, dtype=int)
        step[axis] = 1
        index = index * np.where(step, 2, 1)
        index = np.concatenate([index, index + step])
    return index
