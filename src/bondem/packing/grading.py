"""Sizes of cells that differ from place to place, and how many cells of such sizes a shape holds.

The size h of a cell is the cube root of its volume. A shape holds ∫ dV / h³ of them: it is halved into cubes until
these are smaller than the cells there, and what is counted is also where centres may begin.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.spatial import KDTree

from bondem._checks import array, number, possible, shown
from bondem._types import ArrayLike, Floats, Ints, PerElement, PerElement3
from bondem.errors import InputError
from bondem.specimen.morton import morton_code
from bondem.specimen.shape import Shape

__all__ = ["MOST_CELLS", "STEEPEST", "Graded", "Sites", "SizeField", "SizesAt", "cells_of", "sites", "sizes_by"]

#: Most cells of given sizes.
MOST_CELLS = 2_000_000
#: Fastest that sizes may change over the distance [-]: then a cell is twice as large as its neighbour.
STEEPEST = 1.0
_WANTED = "a positive size in metres, the cube root of the volume of a cell"
# Cubes yet to be halved hold about so many cells where sizes grow by the first over the distance; that many times too
# many are surely too many.
_USUAL, _SURELY = 0.3, 4.0
# Cubes along the longest edge of a shape to begin with.
_FIRST = 4


@dataclass(frozen=True)
class Graded:
    """Sizes of cells: fine about a place, from there on growing with the distance.

    h(x) = min(coarse, fine + growth · distance(x)), the cube root of the volume of a cell at x.

    Attributes:
        fine: size of cells in and at `about` [m].
        coarse: largest size of cells [m], at least `fine`.
        about: a shape (distance 0 inside of it), or points [m], (3,) or (k, 3). A line or a plane is a thin box.
        growth: by how much cells grow over the distance [-], above 0 up to 1; neighbours differ by about this share.

    Raises:
        InputError: sizes that are not positive, `fine` above `coarse`, or what is no place.
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
            raise InputError("Graded: about= is a periodic cell, which is everywhere; give a bd.Box of its size")

    @cached_property
    def _tree(self) -> KDTree:
        return KDTree(np.array(self.about))

    def __call__(self, points: PerElement3) -> PerElement:
        """Sizes at points (k, 3) [m], (k,)."""
        if isinstance(self.about, Shape):
            distance = np.maximum(-self.about.depth(points), 0.0)
        else:
            distance = self._tree.query(points)[0]
        return np.minimum(self.coarse, self.fine + self.growth * distance)


#: What says how large cells are: one size [m], `Graded`, or a function of points (k, 3) that gives sizes (k,) [m].
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
    """Where the cells of a shape may begin.

    Attributes:
        count: how many cells there are to be.
        centre: of the cubes that the shape was halved into, near ones near in order [m], (k, 3).
        edge: of these [m], (k, 3).
        cells: how many cells each takes; together `count`, (k,).
    """

    count: int
    centre: PerElement3
    edge: Floats
    cells: Floats


def cells_of(size: object, volume: float) -> int:
    """How many cells of one size [m] fill a volume [m³]: at least one.

    Raises:
        InputError: no size, or more than `MOST_CELLS`.
    """
    wanted = f"{_WANTED}, bd.Graded, or a function of points (k, 3)"
    h = number("pack", "size", size, unit="m", above=0.0, advice=wanted)
    count = volume / h / h / h
    if not count <= MOST_CELLS:
        raise InputError(f"pack: size = {h:g} m asks for {count:.3g} cells; give a larger size, or bd.Graded")
    return max(1, round(count))


def sizes_by(size: Callable[[PerElement3], PerElement]) -> SizesAt:
    """Sizes at points (k, 3) [m], checked."""

    def sizes(points: PerElement3) -> PerElement:
        try:
            found = np.asarray(size(points))
        except (TypeError, ValueError, IndexError, ArithmeticError) as error:
            raise InputError(f"pack: size= failed for points (k, 3): {shown(str(error))}") from error
        if found.shape != (len(points),) or found.dtype.kind not in "fiu":
            raise InputError(
                f"pack: size= gave {shown(found)} for {len(points)} points; give a function of points (k, 3) that"
                " gives sizes (k,) [m]"
            )
        bad = np.flatnonzero(~(np.isfinite(found) & (found > 0.0)))
        if bad.size:
            raise InputError(f"pack: size= is {found[bad[0]]} m at {points[bad[0]]}; give positive sizes in metres")
        return found.astype(float)

    return sizes


def sites(shape: Shape, size: SizesAt) -> Sites:
    """Halve a shape into cubes no larger than the cells there.

    Args:
        shape: what is to be filled.
        size: of cells at points (k, 3) [m], (k,); it changes by no more than the distance.

    Raises:
        InputError: more than `MOST_CELLS` cells.
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
                f"pack: size= asks for more than {MOST_CELLS} cells; give larger sizes, or fine ones in a smaller"
                " part of the shape"
            )
        index, edge = _halved(index[~small]), 0.5 * edge
    centre, edges, volume, cells = (np.concatenate(column) for column in zip(*made, strict=True))
    count = max(1, round(float(cells.sum() / volume.sum() * shape.volume)))
    order = np.argsort(morton_code(centre), kind="stable")
    return Sites(count, centre[order], edges[order], cells[order] * (count / cells.sum()))


def _halved(index: Ints) -> Ints:
    corner = np.indices((2, 2, 2)).reshape(3, -1).T
    return (2 * index[:, None, :] + corner).reshape(-1, 3)
