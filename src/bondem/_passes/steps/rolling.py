"""Passes that steps are composed of, of `core/passes/contacts/rolling.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.contact_tables import (
    ContactConstants,
    ContactPairs,
    ContactSums,
    NearPairs,
    RolledPairs,
    RolledWalls,
    WallContacts,
    Walls,
)
from bondem._tables.step_tables import Ledger, Moving


def add_rolling_loads(
    contact_pairs: ContactPairs, near_pairs: NearPairs, rolled_pairs: RolledPairs, contact_sums: ContactSums
) -> StepEntry:
    """Adds moments of resistance to rolling to the elements of a range.

    Over elements, one range per thread. Adds `sums` to elements.
    """
    return StepEntry("add_rolling_loads", (contact_pairs, near_pairs, rolled_pairs, contact_sums))


def roll_at_walls(
    moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts, walls: Walls, rolled_walls:
    RolledWalls, contact_sums: ContactSums
) -> StepEntry:
    """Finds moments of resistance to rolling of a portion of elements at walls.

    Over elements, in portions. Reads `motion` of an element; changes `sums` of an element.
    """
    return StepEntry("roll_at_walls", (moving, contact_constants, wall_contacts, walls, rolled_walls, contact_sums))


def roll_pairs(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, near_pairs: NearPairs,
    rolled_pairs: RolledPairs
) -> StepEntry:
    """Finds moments and memory of the springs of rolling of close pairs in a portion of elements.

    Over elements, in portions. Reads `motion`, `pose` at both ends.
    """
    return StepEntry("roll_pairs", (moving, contact_constants, contact_pairs, near_pairs, rolled_pairs))


def sum_rolling_at_walls(
    contact_constants: ContactConstants, wall_contacts: WallContacts, rolled_walls: RolledWalls, ledger: Ledger
) -> StepEntry:
    """Adds the energy that springs of rolling store at walls, of a portion of elements [J].

    Over elements, in portions.
    """
    return StepEntry("sum_rolling_at_walls", (contact_constants, wall_contacts, rolled_walls, ledger))


def sum_rolling_energies(
    contact_constants: ContactConstants, contact_pairs: ContactPairs, rolled_pairs: RolledPairs, ledger: Ledger
) -> StepEntry:
    """Adds the energy that springs of rolling store in the pairs of a portion [J].

    Over elements, in portions.
    """
    return StepEntry("sum_rolling_energies", (contact_constants, contact_pairs, rolled_pairs, ledger))
