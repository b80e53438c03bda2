"""Passes over an index, for devices, of `core/gpu/rolling.hpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Kernel
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
from bondem._tables.device_tables import DeviceSpan, EarlierPairs
from bondem._tables.step_tables import Ledger, Moving


def add_rolling_of_element(
    contact_pairs: ContactPairs, earlier_pairs: EarlierPairs, rolled_pairs: RolledPairs, contact_sums: ContactSums
) -> Kernel:
    """Adds moments of resistance to rolling to the elements of a range.

    Over one index.
    """
    return Kernel("add_rolling_of_element", (contact_pairs, earlier_pairs, rolled_pairs, contact_sums))


def roll_element_at_walls(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts,
    walls: Walls, rolled_walls: RolledWalls, contact_sums: ContactSums
) -> Kernel:
    """Finds moments of resistance to rolling of a portion of elements at walls.

    Over one index.
    """
    return Kernel("roll_element_at_walls", (
        device_span, moving, contact_constants, wall_contacts, walls, rolled_walls, contact_sums
    ))


def roll_one_pair(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs,
    near_pairs: NearPairs, rolled_pairs: RolledPairs
) -> Kernel:
    """Finds moments and memory of the springs of rolling of close pairs in a portion of elements.

    Over one index.
    """
    return Kernel("roll_one_pair", (device_span, moving, contact_constants, contact_pairs, near_pairs, rolled_pairs))


def sum_portion_of_rolling(
    device_span: DeviceSpan, contact_constants: ContactConstants, contact_pairs: ContactPairs, rolled_pairs:
    RolledPairs, ledger: Ledger
) -> Kernel:
    """Adds the energy that springs of rolling store in the pairs of a portion [J].

    Over one index.
    """
    return Kernel("sum_portion_of_rolling", (device_span, contact_constants, contact_pairs, rolled_pairs, ledger))


def sum_portion_of_rolling_at_walls(
    device_span: DeviceSpan, contact_constants: ContactConstants, wall_contacts: WallContacts, rolled_walls:
    RolledWalls, ledger: Ledger
) -> Kernel:
    """Adds the energy that springs of rolling store at walls, of a portion of elements [J].

    Over one index.
    """
    return Kernel("sum_portion_of_rolling_at_walls", (
        device_span, contact_constants, wall_contacts, rolled_walls, ledger
    ))
