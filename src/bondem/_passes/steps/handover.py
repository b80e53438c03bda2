"""Passes that steps are composed of, of `core/passes/contacts/handover.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.beam_softening_tables import SofteningBounds
from bondem._tables.contact_tables import ContactConstants, ContactPairs, ContactSums, FacePairs, NearPairs
from bondem._tables.crack_tables import CohesiveCracks, CrackLists, PartedReach
from bondem._tables.damage_tables import EventLog, Postponed
from bondem._tables.step_tables import Moving


def begin_contacts(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, near_pairs: NearPairs,
    event_log: EventLog, postponed: Postponed
) -> StepEntry:
    """Begins contact where beams have broken in this step, on the sums that are kept for their ends.

    Over events of the step, such as failures, in their order. Reads `motion` at both ends; reads `pose` at both
    ends, of elements that are postponed; adds `sum` to elements.
    """
    return StepEntry("begin_contacts", (moving, contact_constants, contact_pairs, near_pairs, event_log, postponed))


def begin_face_contacts(
    moving: Moving, contact_pairs: ContactPairs, near_pairs: NearPairs, face_pairs: FacePairs, crack_lists:
    CrackLists, event_log: EventLog
) -> StepEntry:
    """Begins the contact of faces that part in this step.

    Over events of the step, such as failures, in their order.
    """
    return StepEntry("begin_face_contacts", (moving, contact_pairs, near_pairs, face_pairs, crack_lists, event_log))


def begin_softened_contacts(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, near_pairs: NearPairs,
    event_log: EventLog, contact_sums: ContactSums
) -> StepEntry:
    """Begins contact where softening beams have broken at the beginning of this step.

    Over events of the step, such as failures, in their order. Reads `motion`, `pose` at both ends; adds `sums`
    to elements.
    """
    return StepEntry("begin_softened_contacts", (
        moving, contact_constants, contact_pairs, near_pairs, event_log, contact_sums
    ))


def release_pressure(event_log: EventLog, softening_bounds: SofteningBounds) -> StepEntry:
    """Ends the pressure on softening beams that have broken at the beginning of this step.

    Over events of the step, such as failures, in their order.
    """
    return StepEntry("release_pressure", (event_log, softening_bounds))


def touch_parted_faces(
    moving: Moving, contact_pairs: ContactPairs, near_pairs: NearPairs, cohesive_cracks: CohesiveCracks,
    crack_lists: CrackLists, parted_reach: PartedReach
) -> StepEntry:
    """Begins to evaluate the pairs of cells whose cracks have parted in this step.

    Over events of the step, such as failures, in their order. Reads `pose` at both ends.
    """
    return StepEntry("touch_parted_faces", (
        moving, contact_pairs, near_pairs, cohesive_cracks, crack_lists, parted_reach
    ))
