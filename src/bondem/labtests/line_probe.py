"""Intersections of a straight line with the walls of a shape, by which notches and borings are found."""

import numpy as np

from bondem._types import Floats
from bondem.errors import InputError
from bondem.geometry.shape import Shape

# Number of sample points on a line, and of bisections between two of them.
_POINTS, _HALVINGS = 2000, 40


def walls_along(shape: Shape, start: Floats, end: Floats) -> tuple[bool, Floats]:
    """Find where a line intersects the walls of a shape; two walls within 1/2000 of its length may be missed.

    Args:
        shape: shape with walls.
        start, end: end points of the line [m], (3,).

    Returns:
        True if the start is inside the shape, and the distances of the walls from it [m], ascending, (k,).
    """

    def inside(share: Floats) -> np.ndarray:
        return shape.contains(start + share[:, None] * (end - start))

    share = np.linspace(0.0, 1.0, _POINTS)
    found = inside(share)
    passed = np.flatnonzero(found[1:] != found[:-1])
    low, high, first = share[passed], share[passed + 1], found[passed]
    if len(passed):
        for _ in range(_HALVINGS):
            middle = 0.5 * (low + high)
            same = inside(middle) == first
            low, high = np.where(same, middle, low), np.where(same, high, middle)
    return bool(found[0]), 0.5 * (low + high) * float(np.linalg.norm(end - start))


def ligament_of(shape: Shape) -> float:
    """Measure the height of the uncut section of a beam at mid-span, above a notch from below [m].

    Raises:
        InputError: the section has holes, or a slot in a side.
    """
    lower, upper = shape.bounds
    start = 0.5 * (lower + upper)

    def cut(axis: int, first: float, last: float) -> Floats:
        line = np.stack([start, start])
        line[:, axis] = first, last
        inside, walls = walls_along(shape, *line)
        if inside and len(walls) <= 2 - axis:
            return walls
        raise InputError("labtests.three_point_bending: holes or slots at mid-span; cut a single notch from below")

    tiny = 1e-9 * float(upper[1] - lower[1])
    walls = cut(1, upper[1] - tiny, lower[1] + tiny)
    found = float(walls[0]) if len(walls) else float(upper[1] - lower[1])
    start[1] = upper[1] - 0.5 * found
    cut(2, lower[2] + tiny, upper[2] - tiny)
    return found
