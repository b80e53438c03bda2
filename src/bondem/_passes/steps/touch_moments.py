"""Passes that steps are composed of, of `core/passes/non_local/touch_moments.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.contact_tables import ContactConstants, ContactPairs, NearPairs, WallContacts, Walls
from bondem._tables.damage_tables import EventLog
from bondem._tables.step_tables import LaggedStresses, Moving


def add_new_contacts(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, lagged_stresses:
    LaggedStresses, event_log: EventLog
) -> StepEntry:
    """Adds new contacts to the stresses of the ends of bonds that have failed in this step, after these contacts
    have begun.

    Over events of the step, such as failures, in their order. Reads `motion` at both ends; reads `pose` at both
    ends, of elements that are postponed; adds `stress` to elements.
    """
    return StepEntry("add_new_contacts", (moving, contact_constants, contact_pairs, lagged_stresses, event_log))


def add_pair_moments(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, near_pairs: NearPairs,
    lagged_stresses: LaggedStresses
) -> StepEntry:
    """Adds contacts of pairs to the stresses of the elements of a range, in the order of the pairs.

    Over elements, one range per thread. Reads `pose` at both ends; adds `moment` to elements.
    """
    return StepEntry("add_pair_moments", (moving, contact_constants, contact_pairs, near_pairs, lagged_stresses))


def add_wall_moments(
    moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts, walls: Walls,
    lagged_stresses: LaggedStresses
) -> StepEntry:
    """Adds contacts with walls to the stresses of the elements of a portion.

    Over elements, in portions. Reads `pose` of an element; changes `moment` of an element.
    """
    return StepEntry("add_wall_moments", (moving, contact_constants, wall_contacts, walls, lagged_stresses))
