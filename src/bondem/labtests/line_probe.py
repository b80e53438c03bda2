"""Intersections of a straight line with the walls of a shape, by which notches and borings are found."""

import numpy as np

from bondem._types import Floats
from bondem.geometry.shape import Shape

# Points in which a line is first looked at, and how often the stretch between two is then halved.
_POINTS, _HALVINGS = 2000, 40


def walls_along(shape: Shape, start: Floats, end: Floats) -> tuple[bool, Floats]:
    """Find the intersections of a line with the walls of a shape.

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
