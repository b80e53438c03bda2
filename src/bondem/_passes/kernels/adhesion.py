"""Passes over an index, for devices, of `core/gpu/adhesion.hpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Kernel
from bondem._tables.contact_tables import (
    AdheringPairs,
    ContactConstants,
    ContactPairs,
    ContactSums,
    WallContacts,
    Walls,
)
from bondem._tables.device_tables import DeviceSpan, EarlierPairs
from bondem._tables.step_tables import Ledger, Moving


def add_adhesion_of_element(
    contact_pairs: ContactPairs, earlier_pairs: EarlierPairs, adhering_pairs: AdheringPairs, contact_sums:
    ContactSums
) -> Kernel:
    """Adds adhesion to the elements of a range.

    Over one index.
    """
    return Kernel("add_adhesion_of_element", (contact_pairs, earlier_pairs, adhering_pairs, contact_sums))


def adhere_element_at_walls(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts,
    walls: Walls, contact_sums: ContactSums
) -> Kernel:
    """Adds the adhesion of a portion of elements at walls to their sums, and to the loads of the walls.

    Over one index.
    """
    return Kernel("adhere_element_at_walls", (
        device_span, moving, contact_constants, wall_contacts, walls, contact_sums
    ))


def adhere_one_pair(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, adhering_pairs:
    AdheringPairs
) -> Kernel:
    """Finds the adhesion of the near pairs of a portion of elements.

    Over one index.
    """
    return Kernel("adhere_one_pair", (moving, contact_constants, contact_pairs, adhering_pairs))


def sum_portion_of_adhesion(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs,
    ledger: Ledger
) -> Kernel:
    """Adds the energy of adhesion of the pairs of a portion, below 0 [J].

    Over one index.
    """
    return Kernel("sum_portion_of_adhesion", (device_span, moving, contact_constants, contact_pairs, ledger))


def sum_portion_of_adhesion_at_walls(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts,
    walls: Walls, ledger: Ledger
) -> Kernel:
    """Adds the energy of adhesion at walls of a portion of elements, below 0 [J].

    Over one index.
    """
    return Kernel("sum_portion_of_adhesion_at_walls", (
        device_span, moving, contact_constants, wall_contacts, walls, ledger
    ))
