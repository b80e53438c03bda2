"""Walls of a state when a new run begins: which of them go on, and how they move off."""

from collections.abc import Sequence

import numpy as np

from bondem._types import Floats, Ints
from bondem.kernels.walls import COLUMNS, RATE
from bondem.model.walls import Free, Servo, Wall


def set_off(rows: Floats, before: Sequence[Wall | None], walls: Sequence[Wall]) -> None:
    """Set the velocities of walls that stand still now, or are free now and were not before.

    Args:
        rows: of the walls of a state, changed in place, shape (w, 14).
        before: the wall that each was in the run before, or None.
        walls: the walls of the run that begins.
    """
    for k, wall in enumerate(walls):
        was = before[k] if k < len(before) else None
        goes_on = was is not None and type(wall.motion) is type(was.motion)
        if isinstance(wall.motion, Free) and not goes_on:
            rows[k, RATE : RATE + 4] = [*wall.motion.velocity, 0.0]
        elif not (goes_on and isinstance(wall.motion, Free | Servo)):
            rows[k, RATE : RATE + 4] = 0.0


def known_walls(before: Sequence[Wall], walls: Sequence[Wall]) -> list[int]:
    """Number that each wall had in the run before, found by where it is defined, or -1 for a new one."""
    rows = [wall.row.tolist() for wall in before]
    came: list[int] = []
    for wall in walls:
        row = wall.row.tolist()
        came.append(rows.index(row) if row in rows else -1)
        if came[-1] >= 0:
            rows[came[-1]] = []  # of two walls in one place each goes on by itself
    return came


def rows_of_walls(came: Sequence[int], rows: Floats, touching: Ints, stretch: Floats) -> tuple[Floats, Ints, Floats]:
    """Rows and contacts of the walls of a new run.

    Args:
        came: number that each wall had before, or -1.
        rows: of the walls before, shape (w, 14).
        touching: element and wall of each contact, shape (b, 2).
        stretch: of these contacts, shape (b, 6).

    Returns:
        The same three of the new walls; contacts with walls that are gone are left out.
    """
    number, found = np.full(len(rows), -1), np.zeros((len(came), COLUMNS))
    for new, before in enumerate(came):
        if before >= 0:
            found[new], number[before] = rows[before], new
    kept = number[touching[:, 1]] >= 0
    element, wall = touching[kept, 0], number[touching[kept, 1]]
    order = np.lexsort((wall, element))
    return found, np.column_stack([element, wall])[order], stretch[kept][order]
