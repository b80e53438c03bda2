"""Centres for cells of sizes that vary in space, each at the centroid of its own cell.

Centres begin at random places. Each part of the shape receives as many centres as cells of the wanted size fit into
it. Near centres push each other apart. Then every centre moves to the centroid of its Laguerre cell, several times
(Lloyd). Radii are in proportion to the sizes, so that the plane between two neighbours divides their distance in the
ratio of their sizes.
"""

from collections.abc import Callable

import numpy as np
from scipy.spatial import KDTree

from bondem._types import Floats, Ints, PerElement, PerElement3
from bondem.errors import InputError
from bondem.geometry.elementary_shapes import Shape
from bondem.packing.even import moved_inside
from bondem.packing.grading import STEEPEST, Sites, SizesAt, sites
from bondem.specimen.particles import Particles, filled, freeze
from bondem.specimen.tessellation.cutting import cell_centroids

# Radius over the size of a cell, so that equal neighbours share a facet half-way between them.
_RADIUS = 0.5
# Distance over mean size below which centres push each other apart, neighbours of a centre, step over the missing
# distance, rounds, pushes per round with the same neighbours, and Lloyd's steps.
_PUSHED, _NEAR, _STEP, _ROUNDS, _SAME, _LLOYD = 1.12, 16, 0.18, 10, 5, 6
# Largest overlap over the smaller radius, largest radius over the depth of a centre, and least depth of centres while
# they move, over their sizes.
_OVERLAP, _INSIDE, _MARGIN = 0.45, 3.0, 0.2
_TRIES = 30


def graded(shape: Shape, size: SizesAt, random: np.random.Generator, report: Callable[[float], None]) -> Particles:
    """Pack spheres of diameters up to the sizes of the cells; overlaps stay below half the smaller radius.

    Args:
        shape: shape to fill.
        size: function that returns sizes of cells [m], (k,), at points [m], (k, 3).
        random: random generator.
        report: function called with the completed share.

    Raises:
        InputError: There are too many cells, sizes change too fast, or a part of the shape received no centre.
    """
    places = sites(shape, size)
    x = _initial_centres(shape, places, size, random)
    for _ in range(_ROUNDS if len(x) > 1 else 0):
        h, other = size(x), nearest_others(x, _NEAR)[1]
        for _ in range(_SAME):
            x = moved_inside(shape, pushed(x, h, other), x, _MARGIN * h)
    _check_slope(x, size(x))
    for step in range(_LLOYD):
        report((step + 1) / (_LLOYD + 2))
        x = _inside(shape, cell_centroids(_spheres(shape, x, _RADIUS * size(x))), x, size)
    h = size(x)
    _check_slope(x, h)
    return _spheres(shape, x, _share(shape, x, h) * h)


def _initial_centres(shape: Shape, places: Sites, size: SizesAt, random: np.random.Generator) -> PerElement3:
    """Draw random centres [m], (n, 3), in Morton order, one in each of n consecutive parts with room for one cell."""
    n = places.count
    end = np.cumsum(places.cells)
    along = (np.arange(n) + random.random(n)) * (end[-1] / n)
    place = np.minimum(np.searchsorted(end, along), len(end) - 1)
    x = places.centre[place]
    out = np.arange(n)
    for _ in range(_TRIES):
        x[out] = places.centre[place[out]] + (random.random((len(out), 3)) - 0.5) * places.edge[place[out]]
        out = out[shape.depth(x[out]) <= 0.0]
        if not out.size:
            break
    return _inside(shape, x, x, size)


def _inside(shape: Shape, x: PerElement3, before: PerElement3, size: SizesAt) -> PerElement3:
    return moved_inside(shape, x, before, _MARGIN * size(before))


def nearest_others(x: PerElement3, most: int) -> tuple[Floats, Ints]:
    """Return distances [m] and indices of the `most` - 1 centres nearest to each, (n, k), or of all if n is less."""
    distance, other = KDTree(x).query(x, k=min(most, len(x)))
    return np.asarray(distance)[:, 1:], np.asarray(other)[:, 1:]


def pushed(x: PerElement3, h: PerElement, other: Ints) -> PerElement3:
    """Push centres apart by a small step where neighbours (n, k) are nearer than their sizes `h` [m] require."""
    way = x[:, None] - x[other]
    distance = np.maximum(np.sqrt(np.einsum("nkc,nkc->nk", way, way)), 1e-12 * h[:, None])
    apart = np.maximum(0.5 * _PUSHED * (h[:, None] + h[other]) - distance, 0.0)
    return x + _STEP * np.einsum("nk,nkc->nc", apart / distance, way)


def _spheres(shape: Shape, x: PerElement3, radius: PerElement) -> Particles:
    """Return particles of given radii [m], (n,), without the check of overlaps."""
    spheres = filled(Particles(x, np.full(len(x), 1e-9 * radius.min())), shape)
    object.__setattr__(spheres, "radius", freeze(radius))
    return spheres


def _check_slope(x: PerElement3, h: PerElement) -> None:
    """Raise InputError if sizes of neighbours differ by more than their distance."""
    if len(x) == 1:
        return
    distance, other = nearest_others(x, 2)
    change = (np.abs(h[:, None] - h[other]) / distance)[:, 0]
    worst = int(np.argmax(change))
    if change[worst] > STEEPEST + 1e-9:
        raise InputError(
            f"pack: size= changes by {change[worst]:.2g} of the distance at {x[worst]}, too fast for cells;"
            f" let it change by at most {STEEPEST:g}, such as bd.Graded(..., growth=0.3)"
        )


def _share(shape: Shape, x: PerElement3, h: PerElement) -> float:
    """Return the common ratio of radius to size, as large as neighbours and walls allow, at most one half."""
    share = min(_RADIUS, float((_INSIDE * shape.depth(x) / h).min()))
    if len(x) == 1:
        return share
    distance, other = nearest_others(x, _NEAR)
    near, far = np.minimum(h[:, None], h[other]), np.maximum(h[:, None], h[other])
    return min(share, float((distance / (far + (1.0 - _OVERLAP) * near)).min()))
