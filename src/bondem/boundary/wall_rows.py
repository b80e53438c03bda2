"""Rows of the tables of walls, with the names that the core declares (`core/tables/wall_rows.hpp`)."""

import numpy as np

from bondem._core import row_type
from bondem._types import Floats


def wall_rows(walls: Floats) -> np.ndarray:
    """View `State.walls`, (w, 27), as a structured array of shape (w,), which shares its memory.

    Fields: `displacement` of the point about which the wall turns (3) and `growth` of its radius [m]; `velocity` (3)
    and `growth_rate` [m/s]; `force` of the elements (3), on the radius (`growth_force`) and along the normals
    (`normal_force`) [N]; `work` on the elements [J]; `orientation` (4); `spin` (3) [rad/s]; `torque` of the elements
    about that point (3) [N·m]; `momentum`, the angular momentum of a free wall (3) [kg·m²/s].
    """
    return named_rows("WallRow", walls)


def named_rows(name: str, numbers: Floats) -> np.ndarray:
    """View numbers (w, k) as a structured array (w,) of a row type of the core, which shares their memory."""
    return numbers.view(row_type(name))[:, 0]


def no_rows(name: str, count: int) -> Floats:
    """Return zeros (count, k) for rows of a row type of the core."""
    return np.zeros((count, row_type(name).itemsize // 8))


def walls_at_rest(count: int) -> Floats:
    """Return the rows of `count` walls at rest in the reference, shape (count, 27)."""
    rows = no_rows("WallRow", count)
    wall_rows(rows)["orientation"][:, 0] = 1.0
    return rows
