"""Passes that steps are composed of, of `core/passes/contacts/travel.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.contact_tables import NearPairs, Travel, Walls
from bondem._tables.step_tables import Ledger, Moving


def check_travel(travel: Travel, walls: Walls, ledger: Ledger) -> StepEntry:
    """Marks the list of contacts as out of date if it may miss a contact, or if a centre is not finite.

    Over single numbers, such as those of a record.
    """
    return StepEntry("check_travel", (travel, walls, ledger))


def keep_measures(near_pairs: NearPairs, travel: Travel) -> StepEntry:
    """Stores the largest motion since the list was made, in a step that measures distances.

    Over single numbers, such as those of a record.
    """
    return StepEntry("keep_measures", (near_pairs, travel))


def measure_travel(moving: Moving, travel: Travel) -> StepEntry:
    """Finds the largest motion of the elements of a portion since distances were measured.

    Over elements, in portions.
    """
    return StepEntry("measure_travel", (moving, travel))
