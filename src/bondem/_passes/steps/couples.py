"""Passes that steps are composed of, of `core/passes/boundary/couples.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.step_tables import CoupleTable, Moving, Rows, Timeline


def follow_couples(timeline: Timeline, couple_table: CoupleTable, moving: Moving, rows: Rows) -> StepEntry:
    """Adds moments on regions as forces and torques of their elements.

    Over rows of a table, in the order of the table. Reads `pose` at both ends; adds `force` to elements.
    """
    return StepEntry("follow_couples", (timeline, couple_table, moving, rows))
