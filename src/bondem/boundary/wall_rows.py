"""Rows of the tables of walls, with the names that the core declares (`core/tables/wall_rows.hpp`)."""

import numpy as np

from bondem._core import row_type
from bondem._types import Floats


def wall_rows(walls: Floats) -> np.ndarray:
    """Return the rows of `State.walls`, (w, 27), by their names; they share its numbers.

    A row is where a wall is, how it moves, and its loads: `displacement` of the point about which it turns (3) and
    `growth` of its radius [m]; `velocity` (3) and `growth_rate` [m/s]; `force` of the elements (3), on its radius
    (`growth_force`) and along its normals (`normal_force`) [N]; `work` on the elements [J]; `orientation` (4); `spin`
    (3) [rad/s]; `torque` of the elements about that point (3) [N·m]; `momentum`, the angular momentum of a free wall
    (3) [kg·m²/s].
    """
    return named_rows("WallRow", walls)


def named_rows(name: str, numbers: Floats) -> np.ndarray:
    """Return rows of a type of the core by the names of their numbers, which they share, (w,)."""
    return numbers.view(row_type(name))[:, 0]


def no_rows(name: str, count: int) -> Floats:
    """Return the numbers of rows of a type of the core, all zero."""
    return np.zeros((count, row_type(name).itemsize // 8))


def walls_at_rest(count: int) -> Floats:
    """Return rows of walls at their places in the reference, shape (w, 27)."""
    rows = no_rows("WallRow", count)
    wall_rows(rows)["orientation"][:, 0] = 1.0
    return rows
