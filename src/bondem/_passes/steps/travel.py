"""Passes that steps are composed of, of `core/passes/contacts/travel.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.contact_tables import NearPairs, Travel, Walls
from bondem._tables.step_tables import Ledger, Moving


def check_travel(travel: Travel, walls: Walls, ledger: Ledger) -> StepEntry:
    """Finds whether the list may miss a contact by now, also where a centre is not a number.

    Over numbers that a body has once, such as those of a record.
    """
    return StepEntry("check_travel", (travel, walls, ledger))


def keep_measures(near_pairs: NearPairs, travel: Travel) -> StepEntry:
    """Stores distances that were measured in a step.

    Over numbers that a body has once, such as those of a record.
    """
    return StepEntry("keep_measures", (near_pairs, travel))


def measure_travel(moving: Moving, travel: Travel) -> StepEntry:
    """Finds the distances of the elements of a portion from their places at the last measurement.

    Over elements, in portions.
    """
    return StepEntry("measure_travel", (moving, travel))
