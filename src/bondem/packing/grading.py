"""Cell sizes that vary in space, and the number of such cells in a shape.

The size h of a cell is the cube root of its volume. A shape has room for ∫ dV / h³ cells. The shape is divided into
nearly cubic boxes by halving, until they are smaller than the cells there. The boxes are also the possible initial
places of centres.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.spatial import KDTree

from bondem._checks import array, number, possible, shown
from bondem._types import ArrayLike, Floats, Ints, PerElement, PerElement3
from bondem.errors import InputError
from bondem.geometry.morton import morton_order
from bondem.geometry.shape import Shape

__all__ = ["MOST_CELLS", "STEEPEST", "Graded", "Sites", "SizeField", "SizesAt", "cells_of", "sites", "sizes_by"]

#: Largest number of cells of given sizes.
MOST_CELLS = 2_000_000
#: Largest change of the size over the distance [-], at which a cell is twice as large as its neighbour.
STEEPEST = 1.0
_WANTED = "a positive size in metres, the cube root of the volume of a cell"
# Growth of sizes over the distance by which the cells in coarse cubes are estimated, and the factor above the largest
# number of cells from which such an estimate raises an error.
_USUAL, _SURELY = 0.3, 4.0
# Initial number of cubes along the longest edge of a shape.
_FIRST = 4


@dataclass(frozen=True)
class Graded:
    """Graded cell sizes: fine at a place, and growing with the distance from it.

    The size of a cell at x, the cube root of its volume, is h(x) = min(coarse, fine + growth · distance(x)).

    Attributes:
        fine: size of cells in and at `about` [m].
        coarse: largest size of cells [m], at least `fine`.
        about: a shape (distance 0 inside of it), or points [m], (3,) or (k, 3). A line or a plane is a thin box.
        growth: growth of the cell size per distance [-], above 0 up to 1; neighbours differ by about this share.

    Raises:
        InputError: A size or `growth` is out of range, `fine` is above `coarse`, or `about` is of another kind.
    """

    fine: float
    coarse: float
    about: Shape | ArrayLike
    growth: float = 0.3

    def __post_init__(self) -> None:
        for name in ("fine", "coarse"):
            value = number("Graded", name, getattr(self, name), unit="m", above=0.0, advice=_WANTED)
            object.__setattr__(self, name, value)
        if self.fine > self.coarse:
            raise InputError(f"Graded: fine = {self.fine:g} m is above coarse = {self.coarse:g} m; exchange them")
        growth = number("Graded", "growth", self.growth, above=0.0)
        if growth > STEEPEST:
            raise InputError(f"Graded: growth = {growth:g}; give a number above 0 up to {STEEPEST:g}, such as 0.3")
        object.__setattr__(self, "growth", growth)
        if not isinstance(self.about, Shape):
            object.__setattr__(self, "about", _points(self.about))
        elif self.about.period is not None:
            raise InputError("Graded: about= is a periodic cell, which fills all space; give a bd.Box of its size")

    @cached_property
    def _tree(self) -> KDTree:
        return KDTree(np.array(self.about))

    def __call__(self, points: PerElement3) -> PerElement:
        """Return the sizes of cells [m], (k,), at points [m], (k, 3)."""
        if isinstance(self.about, Shape):
            distance = np.maximum(-self.about.depth(points), 0.0)
        else:
            distance = self._tree.query(points)[0]
        return np.minimum(self.coarse, self.fine + self.growth * distance)


#: Definition of cell sizes: one size [m], `Graded`, or a function of points (k, 3) that gives sizes (k,) [m].
SizeField = float | Graded | Callable[[PerElement3], PerElement]
SizesAt = Callable[[PerElement3], PerElement]


def _points(about: object) -> tuple[tuple[float, ...], ...]:
    wanted = "a shape, or points as an array of shape (3,) or (k, 3) [m]"
    found = np.atleast_2d(array("Graded", "about", about, wanted=wanted))
    if found.ndim != 2 or found.shape[1] != 3 or not len(found) or not possible(found):
        raise InputError(f"Graded: about = {shown(about)}; give {wanted}")
    return tuple(map(tuple, found.tolist()))


@dataclass(frozen=True, eq=False)
class Sites:
    """Boxes that make up a shape, as possible initial places of centres, with the number of cells in each.

    Attributes:
        count: total number of cells.
        centre: centres of the boxes, in Morton order [m], (k, 3).
        edge: edge lengths of the boxes [m], (k, 3).
        cells: number of cells in each box, (k,); their sum is `count`.
    """

    count: int
    centre: PerElement3
    edge: Floats
    cells: Floats


def cells_of(size: object, volume: float) -> int:
    """Return the number of cells of one size [m] that fill a volume [m³], at least one.

    Raises:
        InputError: The size is not a positive number, or the cells exceed `MOST_CELLS`.
    """
    wanted = f"{_WANTED}, bd.Graded, or a function of points (k, 3)"
    h = number("pack", "size", size, unit="m", above=0.0, advice=wanted)
    count = volume / h / h / h
    if not count <= MOST_CELLS:
        raise InputError(f"pack: size = {h:g} m requires {count:.3g} cells; give a larger size, or bd.Graded")
    return max(1, round(count))


def sizes_by(size: Callable[[PerElement3], PerElement]) -> SizesAt:
    """Return a user's function of points (k, 3) [m] for cell sizes (k,) [m], with InputError for bad sizes."""

    def sizes(points: PerElement3) -> PerElement:
        try:
            found = np.asarray(size(points))
        except (TypeError, ValueError, IndexError, ArithmeticError) as error:
            raise InputError(f"pack: size= failed for points (k, 3): {shown(str(error))}") from error
        if found.shape != (len(points),) or found.dtype.kind not in "fiu":
            raise InputError(
                f"pack: size= returned {shown(found)} for {len(points)} points; give a function of points (k, 3) that"
                " returns sizes (k,) [m]"
            )
        bad = np.flatnonzero(~(np.isfinite(found) & (found > 0.0)))
        if bad.size:
            raise InputError(f"pack: size= is {found[bad[0]]} m at {points[bad[0]]}; give positive sizes in metres")
        return found.astype(float)

    return sizes


def sites(shape: Shape, size: SizesAt) -> Sites:
    """Divide a shape by halving into boxes whose longest edge is no larger than the cells there.

    The boxes are nearly cubic, except in a shape that is much thinner in one direction than in another.

    Args:
        shape: shape to be filled.
        size: function that returns sizes of cells [m], (k,), at points [m], (k, 3); sizes at two points differ by
            no more than their distance.

    Raises:
        InputError: The shape has room for more than `MOST_CELLS` cells.
    """
    lower, upper = shape.bounds
    along = np.maximum(1, np.rint(_FIRST * (upper - lower) / (upper - lower).max())).astype(int)
    edge = (upper - lower) / along
    index = np.indices(tuple(map(int, along))).reshape(3, -1).T
    made: list[tuple[Floats, Floats, Floats, Floats]] = []
    counted = 0.0
    while len(index):
        centre = lower + (index + 0.5) * edge
        depth = shape.depth(centre)
        near = depth > -0.5 * float(np.linalg.norm(edge))
        index, centre, depth = index[near], centre[near], depth[near]
        h = size(centre)
        small = edge.max() <= h
        inside = np.clip(0.5 + depth / np.cbrt(edge.prod()), 0.0, 1.0)
        done = small & (inside > 0.0)
        volume = inside[done] * edge.prod()
        made.append((centre[done], np.tile(edge, (len(volume), 1)), volume, volume / h[done] ** 3))
        counted += float(made[-1][3].sum())
        coarse = inside[~small] * edge.prod() / (h[~small] + _USUAL * 0.5 * np.linalg.norm(edge)) ** 3
        if counted > MOST_CELLS or coarse.sum() > _SURELY * MOST_CELLS:
            raise InputError(
                f"pack: size= requires more than {MOST_CELLS} cells; give larger sizes, or fine ones in a smaller"
                " part of the shape"
            )
        index, edge = _halved(index[~small]), 0.5 * edge
    centre, edges, volume, cells = (np.concatenate(column) for column in zip(*made, strict=True))
    count = max(1, round(float(cells.sum() / volume.sum() * shape.volume)))
    order = morton_order(centre)
    return Sites(count, centre[order], edges[order], cells[order] * (count / cells.sum()))


def _halved(index: Ints) -> Ints:
    corner = np.indices((2, 2, 2)).reshape(3, -1).T
    return (2 * index[:, None, :] + corner).reshape(-1, 3)
