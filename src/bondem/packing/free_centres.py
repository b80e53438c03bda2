"""Centres of cells that fill a shape beside layers of centres along surfaces."""

from collections.abc import Callable

import numpy as np
from scipy.spatial import KDTree

from bondem._types import Ints, Mask, PerElement, PerElement3
from bondem.errors import InputError
from bondem.geometry.elementary_shapes import Shape
from bondem.packing.even import moved_inside, points_of
from bondem.packing.graded import nearest_others, pushed
from bondem.specimen.tessellation.cutting import cell_centroids

#: Distance of centres from walls, over the size of a cell.
MARGIN = 0.33
# Rounds in which centres push each other apart, pushes per round, neighbours of a centre, and Lloyd's steps.
_ROUNDS, _SAME, _NEAR, _LLOYD = 10, 5, 16, 8
# Largest number of random draws of centres.
_TRIES = 1000

#: Distance of points from the nearest surface [m], (n,).
Nearest = Callable[[PerElement3], PerElement]


def thrown_free(
    shape: Shape, count: int, nearest: Nearest, clear: float, h: float, random: np.random.Generator
) -> PerElement3:
    """Draw random centres in a shape, outside the layers along surfaces [m], (count, 3).

    Args:
        shape: shape to fill.
        count: number of centres.
        nearest: function that returns the distance of points from the surfaces.
        clear: least distance of centres from surfaces [m].
        h: size of a cell [m].
        random: random generator.

    Raises:
        InputError: The layers along the surfaces leave no room.
    """
    lower, upper = shape.bounds
    found = np.empty((0, 3))
    for _ in range(_TRIES):
        x = lower + (upper - lower) * random.random((2 * count, 3))
        x = x[shape.depth(x) > MARGIN * h]
        found = np.concatenate([found, x[nearest(x) > clear]])
        if len(found) >= count:
            return found[:count]
    raise InputError("pack: the layers along surfaces leave no room for other cells; ask for more and smaller cells")


def without_twins(x: PerElement3, least: float, retained: Mask, owner: Ints | None = None) -> Mask:
    """Return the mask `retained` (n,) of points (n, 3), without points nearer than `least` [m] to an earlier point.

    Only points in the mask, and of different owners (n,), are compared; without `owner` all owners are different.
    """
    retained = retained.copy()
    pairs = KDTree(x).query_pairs(least, output_type="ndarray") if len(x) > 1 else np.empty((0, 2), dtype=int)
    for a, b in pairs[np.lexsort(pairs.T[::-1])]:
        if retained[a] and retained[b] and (owner is None or owner[a] != owner[b]):
            retained[b] = False
    return retained


def settled_free(
    shape: Shape, pins: PerElement3, free: PerElement3, h: float, report: Callable[[float], None], *,
    nearest: Nearest | None = None, clear: float = 0.0,
) -> PerElement3:  # fmt: skip
    """Push free centres apart, and move them to the centroids of their cells; return all centres [m], (n, 3).

    Args:
        shape: shape to fill.
        pins: centres that stay, (k, 3) [m].
        free: centres that move, (n - k, 3) [m].
        h: size of a cell [m].
        report: function called with the completed share.
        nearest: function that returns the distance of points from the surfaces; None to ignore these.
        clear: least distance from the surfaces [m].
    """
    x = np.concatenate([pins, free])
    count = len(x)
    still, margin, size = np.arange(count) < len(pins), np.full(count, MARGIN * h), np.full(count, h)

    def moved(to: PerElement3) -> PerElement3:
        to = moved_inside(shape, np.where(still[:, None], x, to), x, margin)
        stay = still if nearest is None else still | (nearest(to) < clear)
        return np.where(stay[:, None], x, to)

    for _ in range(_ROUNDS):
        other = nearest_others(x, min(_NEAR, count))[1]
        for _ in range(_SAME):
            x = moved(pushed(x, size, other))
    for step in range(_LLOYD):
        report((step + 1) / (_LLOYD + 2))
        x = moved(cell_centroids(points_of(shape, x, h)))
    return x
