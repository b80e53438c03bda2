"""Walls of a state at the start of a new run: their identity, velocities and contacts."""

from collections.abc import Sequence

import numpy as np

from bondem._types import Floats, Ints
from bondem.boundary.wall_motions import Free, Servo
from bondem.boundary.wall_rows import wall_rows, walls_at_rest
from bondem.boundary.walls import Wall, pivot
from bondem.geometry.rotations import turned_vectors


def set_off(rows: Floats, before: Sequence[Wall | None], walls: Sequence[Wall]) -> None:
    """Set the velocities of walls at the start of a run, without moving the walls.

    Walls that remain servo-controlled or free continue to move. Walls that become free get their `velocity` and
    `spin`; all others start at rest. Displacements become those of the points about which walls now turn.

    Args:
        rows: rows of the walls of a state, changed in place, shape (w, 27).
        before: previous wall of each wall, or None.
        walls: the walls of the run that begins.
    """
    row = wall_rows(rows)
    for k, wall in enumerate(walls):
        was = before[k] if k < len(before) else None
        if was is not None:  # the displacement becomes that of the new point about which the wall turns
            arm = np.subtract(pivot(wall), pivot(was))[None]
            row["displacement"][k] += (turned_vectors(row["orientation"][k : k + 1], arm) - arm)[0]
        goes_on = was is not None and type(wall.motion) is type(was.motion)
        if not (goes_on and isinstance(wall.motion, Free | Servo)):
            row["velocity"][k] = wall.motion.velocity if isinstance(wall.motion, Free) else 0.0
            row["spin"][k], row["growth_rate"][k], row["momentum"][k] = 0.0, 0.0, 0.0
        if isinstance(wall.motion, Free):
            _set_momentum(row[k], was.motion if goes_on else None, wall.motion)


def _set_momentum(row: np.void, was: object, motion: Free) -> None:
    """Set spin and angular momentum of a free wall, unless it continues to turn as before."""
    known = was.inertia if isinstance(was, Free) else None
    if known is None:
        row["spin"] = motion.spin
    if known != motion.inertia:
        q = row["orientation"][None]
        local = turned_vectors(q * [1.0, -1.0, -1.0, -1.0], row["spin"][None])
        row["momentum"] = turned_vectors(q, local @ motion.matrix)[0]


def known_walls(before: Sequence[Wall], walls: Sequence[Wall]) -> list[int]:
    """Return the number of each wall in the previous run, identified by kind, place and size, or -1."""
    rows = [wall.row.tolist() for wall in before]
    previous: list[int] = []
    for wall in walls:
        row = wall.row.tolist()
        previous.append(rows.index(row) if row in rows else -1)
        if previous[-1] >= 0:
            rows[previous[-1]] = []  # equal walls are matched one to one
    return previous


def rows_of_walls(
    previous: Sequence[int], rows: Floats, touching: Ints, stretch: Floats
) -> tuple[Floats, Ints, Floats]:
    """Return rows and contacts of the walls of a new run, taken from those of the previous run.

    Args:
        previous: number of each wall in the previous run, or -1.
        rows: rows of the previous walls, shape (w, 27).
        touching: element and wall of each contact, shape (b, 2).
        stretch: memory of these contacts, one row each, shape (b, q).

    Returns:
        Rows, contacts and memory of the new walls, without contacts with walls that no longer exist.
    """
    number, found = np.full(len(rows), -1), walls_at_rest(len(previous))
    for new, before in enumerate(previous):
        if before >= 0:
            found[new], number[before] = rows[before], new
    retained = number[touching[:, 1]] >= 0
    element, wall = touching[retained, 0], number[touching[retained, 1]]
    order = np.lexsort((wall, element))
    return found, np.column_stack([element, wall])[order], stretch[retained][order]
