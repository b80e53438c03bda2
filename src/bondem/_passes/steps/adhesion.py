"""Passes that steps are composed of, of `core/passes/contacts/adhesion.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.contact_tables import (
    AdheringPairs,
    ContactConstants,
    ContactPairs,
    ContactSums,
    NearPairs,
    WallContacts,
    Walls,
)
from bondem._tables.step_tables import Ledger, Moving


def add_adhesion_loads(
    contact_pairs: ContactPairs, near_pairs: NearPairs, adhering_pairs: AdheringPairs, contact_sums: ContactSums
) -> StepEntry:
    """Adds adhesion to the elements of a range.

    Over elements, one range per thread. Adds `sums` to elements.
    """
    return StepEntry("add_adhesion_loads", (contact_pairs, near_pairs, adhering_pairs, contact_sums))


def adhere_at_walls(
    moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts, walls: Walls, contact_sums:
    ContactSums
) -> StepEntry:
    """Adds the adhesion of a portion of elements at walls to their sums, and to the loads of the walls.

    Over elements, in portions. Reads `pose` of an element; changes `sums` of an element.
    """
    return StepEntry("adhere_at_walls", (moving, contact_constants, wall_contacts, walls, contact_sums))


def adhere_pairs(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, near_pairs: NearPairs,
    adhering_pairs: AdheringPairs
) -> StepEntry:
    """Finds the adhesion of the near pairs of a portion of elements.

    Over elements, in portions. Reads `pose` at both ends.
    """
    return StepEntry("adhere_pairs", (moving, contact_constants, contact_pairs, near_pairs, adhering_pairs))


def sum_adhesion_at_walls(
    moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts, walls: Walls, ledger: Ledger
) -> StepEntry:
    """Adds the energy of adhesion at walls of a portion of elements, below 0 [J].

    Over elements, in portions.
    """
    return StepEntry("sum_adhesion_at_walls", (moving, contact_constants, wall_contacts, walls, ledger))


def sum_adhesion_energies(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, ledger: Ledger
) -> StepEntry:
    """Adds the energy of adhesion of the pairs of a portion, below 0 [J].

    Over elements, in portions.
    """
    return StepEntry("sum_adhesion_energies", (moving, contact_constants, contact_pairs, ledger))
