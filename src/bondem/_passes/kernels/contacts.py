"""Passes over an index, for devices, of `core/gpu/contacts.hpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Kernel
from bondem._tables.contact_tables import (
    ContactConstants,
    ContactPairs,
    ContactSums,
    FacePairs,
    NearPairs,
    Travel,
    WallContacts,
    WallMotions,
    Walls,
)
from bondem._tables.device_tables import DeviceSpan, EarlierPairs, RowOrder
from bondem._tables.step_tables import Gauges, HistoryRows, Ledger, Moving, StepBlocks


def add_contact_load(
    device_span: DeviceSpan, moving: Moving, step_blocks: StepBlocks, contact_sums: ContactSums
) -> Kernel:
    """Adds forces and losses of contacts to those of the elements, and sets those of contacts to zero.

    Over one index.
    """
    return Kernel("add_contact_load", (device_span, moving, step_blocks, contact_sums))


def add_faces_of_element(contact_pairs: ContactPairs, face_pairs: FacePairs, contact_sums: ContactSums) -> Kernel:
    """Adds forces of faces on element p: of pairs whose later element it is, then of pairs whose earlier element
    it is.
    """
    return Kernel("add_faces_of_element", (contact_pairs, face_pairs, contact_sums))


def add_pairs_of_element(
    contact_constants: ContactConstants, contact_pairs: ContactPairs, earlier_pairs: EarlierPairs, near_pairs:
    NearPairs, contact_sums: ContactSums
) -> Kernel:
    """Adds forces of pairs on element p in their order: as the later element of a pair, then as the earlier one."""
    return Kernel("add_pairs_of_element", (contact_constants, contact_pairs, earlier_pairs, near_pairs, contact_sums))


def check_travel_of_element(device_span: DeviceSpan, moving: Moving, travel: Travel) -> Kernel:
    """Finds the largest motion of the elements of a portion since distances were measured.

    Over one index.
    """
    return Kernel("check_travel_of_element", (device_span, moving, travel))


def check_travel_of_wall(device_span: DeviceSpan, travel: Travel, walls: Walls) -> Kernel:
    """Marks the list of contacts as out of date if it may miss a contact, or if a centre is not finite.

    Over one index.
    """
    return Kernel("check_travel_of_wall", (device_span, travel, walls))


def count_work_of_walls(device_span: DeviceSpan, walls: Walls, ledger: Ledger) -> Kernel:
    """Adds the absolute works of walls to the energy balance, for its guard.

    Over one index.
    """
    return Kernel("count_work_of_walls", (device_span, walls, ledger))


def kick_free_wall(device_span: DeviceSpan, wall_motions: WallMotions, walls: Walls) -> Kernel:
    """Adds the second half of the velocity change to free wall e, once its forces are known, and sets its spin."""
    return Kernel("kick_free_wall", (device_span, wall_motions, walls))


def load_wall(device_span: DeviceSpan, wall_contacts: WallContacts, row_order: RowOrder, walls: Walls) -> Kernel:
    """Sums the forces of elements on wall w, and adds its work."""
    return Kernel("load_wall", (device_span, wall_contacts, row_order, walls))


def measure_overlaps(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs,
    wall_contacts: WallContacts, walls: Walls, travel: Travel
) -> Kernel:
    """Finds the deepest overlap of pairs and contacts with walls in a portion of elements, over the smaller
    radius.
    """
    return Kernel("measure_overlaps", (
        device_span, moving, contact_constants, contact_pairs, wall_contacts, walls, travel
    ))


def move_all_walls(device_span: DeviceSpan, wall_motions: WallMotions, walls: Walls) -> Kernel:
    """Moves walls to the end of the step that begins at the time of the clock.

    Over one index.
    """
    return Kernel("move_all_walls", (device_span, wall_motions, walls))


def press_pair(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs,
    near_pairs: NearPairs
) -> Kernel:
    """Finds forces and memory of the pairs of a portion of elements; renews the list of near pairs after large
    motions.

    Over one index.
    """
    return Kernel("press_pair", (device_span, moving, contact_constants, contact_pairs, near_pairs))


def press_pair_or_faces(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs,
    near_pairs: NearPairs, face_pairs: FacePairs
) -> Kernel:
    """Computes the contact of pair k of a body of cells with cracks: by faces, or as spheres."""
    return Kernel("press_pair_or_faces", (
        device_span, moving, contact_constants, contact_pairs, near_pairs, face_pairs
    ))


def press_walls_on_element(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts,
    walls: Walls, contact_sums: ContactSums
) -> Kernel:
    """Adds forces of walls to the elements of a portion, and stores the memory of these contacts.

    Over one index.
    """
    return Kernel("press_walls_on_element", (
        device_span, moving, contact_constants, wall_contacts, walls, contact_sums
    ))


def sum_portion_at_walls(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts,
    walls: Walls, ledger: Ledger
) -> Kernel:
    """Adds the elastic energy of contacts of a portion with walls [J].

    Over one index.
    """
    return Kernel("sum_portion_at_walls", (device_span, moving, contact_constants, wall_contacts, walls, ledger))


def sum_portion_of_faces(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs,
    face_pairs: FacePairs, ledger: Ledger
) -> Kernel:
    """Adds the elastic energy of the pairs of a portion that touch by faces [J].

    Over one index.
    """
    return Kernel("sum_portion_of_faces", (device_span, moving, contact_constants, contact_pairs, face_pairs, ledger))


def sum_portion_of_pairs(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs,
    ledger: Ledger
) -> Kernel:
    """Sums the elastic energy of the pairs of a portion [J].

    Over one index.
    """
    return Kernel("sum_portion_of_pairs", (device_span, moving, contact_constants, contact_pairs, ledger))


def write_all_walls(
    device_span: DeviceSpan, walls: Walls, gauges: Gauges, ledger: Ledger, history_rows: HistoryRows
) -> Kernel:
    """Adds the works of walls to the energy balance, and writes gauges of walls.

    Over one index.
    """
    return Kernel("write_all_walls", (device_span, walls, gauges, ledger, history_rows))
