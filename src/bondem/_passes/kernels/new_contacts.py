"""Passes over an index, for devices, of `core/gpu/new_contacts.hpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Kernel
from bondem._tables.contact_tables import ContactConstants, ContactPairs, FacePairs, NearPairs
from bondem._tables.crack_tables import CohesiveCracks, CrackLists, PartedReach
from bondem._tables.damage_tables import EventLog, Postponed
from bondem._tables.device_tables import BondMarks, BondsOfElements
from bondem._tables.step_tables import Moving


def add_new_contacts_of_element(
    bonds_of_elements: BondsOfElements, bond_marks: BondMarks, contact_constants: ContactConstants, contact_pairs:
    ContactPairs, near_pairs: NearPairs, event_log: EventLog, postponed: Postponed
) -> Kernel:
    """Launched for `begin_contacts`: begins contact where beams have broken in this step, on the sums that are
    kept for their ends.

    Over one index.
    """
    return Kernel("add_new_contacts_of_element", (
        bonds_of_elements, bond_marks, contact_constants, contact_pairs, near_pairs, event_log, postponed
    ))


def begin_contact_of_event(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, near_pairs: NearPairs,
    event_log: EventLog
) -> Kernel:
    """Begins the contact of event number e of this step."""
    return Kernel("begin_contact_of_event", (moving, contact_constants, contact_pairs, near_pairs, event_log))


def begin_faces_of_pair(moving: Moving, contact_pairs: ContactPairs, face_pairs: FacePairs) -> Kernel:
    """Begins the contact of the faces of pair k that part in this step."""
    return Kernel("begin_faces_of_pair", (moving, contact_pairs, face_pairs))


def open_face(contact_pairs: ContactPairs, face_pairs: FacePairs, crack_lists: CrackLists) -> Kernel:
    """Marks the faces of facet k that part in this step, and their cells."""
    return Kernel("open_face", (contact_pairs, face_pairs, crack_lists))


def settle_face(face_pairs: FacePairs) -> Kernel:
    """Launched for `begin_face_contacts`: begins the contact of faces that part in this step.

    Over one index.
    """
    return Kernel("settle_face", (face_pairs,))


def settle_faces_of_cell(face_pairs: FacePairs) -> Kernel:
    """Launched for `begin_face_contacts`: begins the contact of faces that part in this step.

    Over one index.
    """
    return Kernel("settle_faces_of_cell", (face_pairs,))


def take_over_energies(contact_pairs: ContactPairs, near_pairs: NearPairs, event_log: EventLog) -> Kernel:
    """Subtracts the energies that contacts store from the energy released in the run."""
    return Kernel("take_over_energies", (contact_pairs, near_pairs, event_log))


def take_over_from_cracks(face_pairs: FacePairs, event_log: EventLog) -> Kernel:
    """Subtracts the energy that faces store as they begin to touch from the released energy."""
    return Kernel("take_over_from_cracks", (face_pairs, event_log))


def touch_parted_face(
    moving: Moving, contact_pairs: ContactPairs, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists,
    parted_reach: PartedReach
) -> Kernel:
    """Begins to evaluate the pair of cells of facet k if its crack has parted in this step."""
    return Kernel("touch_parted_face", (moving, contact_pairs, cohesive_cracks, crack_lists, parted_reach))
