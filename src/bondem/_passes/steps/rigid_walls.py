"""Passes that steps are composed of, of `core/passes/contacts/rigid_walls.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.contact_tables import (
    ContactConstants,
    ContactSums,
    NearPairs,
    Travel,
    WallContacts,
    WallMotions,
    Walls,
)
from bondem._tables.step_tables import Gauges, HistoryRows, Ledger, Moving


def count_wall_work(walls: Walls, ledger: Ledger) -> StepEntry:
    """Adds the absolute works of walls to the energy balance, for its guard.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("count_wall_work", (walls, ledger))


def load_walls(wall_contacts: WallContacts, wall_motions: WallMotions, walls: Walls) -> StepEntry:
    """Sums the forces of elements on walls, adds their work, and closes the step of free walls.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("load_walls", (wall_contacts, wall_motions, walls))


def measure_wall_overlaps(
    moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts, walls: Walls, near_pairs:
    NearPairs, travel: Travel
) -> StepEntry:
    """Keeps the deepest overlap over radius of the elements of a portion with a wall, in a step that measures
    distances.

    Over elements, in portions.
    """
    return StepEntry("measure_wall_overlaps", (moving, contact_constants, wall_contacts, walls, near_pairs, travel))


def move_walls(wall_motions: WallMotions, walls: Walls) -> StepEntry:
    """Moves walls to the end of the step that begins at the time of the clock.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("move_walls", (wall_motions, walls))


def press_walls(
    moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts, walls: Walls, contact_sums:
    ContactSums
) -> StepEntry:
    """Adds forces of walls to the elements of a portion, and stores the memory of these contacts.

    Over elements, in portions. Reads `motion`, `pose` of an element; changes `sums` of an element.
    """
    return StepEntry("press_walls", (moving, contact_constants, wall_contacts, walls, contact_sums))


def sum_wall_energies(
    moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts, walls: Walls, ledger: Ledger
) -> StepEntry:
    """Adds the elastic energy of contacts of a portion with walls [J].

    Over elements, in portions.
    """
    return StepEntry("sum_wall_energies", (moving, contact_constants, wall_contacts, walls, ledger))


def write_walls(walls: Walls, gauges: Gauges, ledger: Ledger, history_rows: HistoryRows) -> StepEntry:
    """Adds the works of walls to the energy balance, and writes gauges of walls.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("write_walls", (walls, gauges, ledger, history_rows))
