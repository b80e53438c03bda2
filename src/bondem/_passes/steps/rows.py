"""Passes that steps are composed of, of `core/passes/boundary/rows.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.step_tables import Drives, Moving, RowLoads, Rows, Timeline


def clear_row_forces(rows: Rows) -> StepEntry:
    """Sets the forces of all rows to zero, before loads are added.

    Over rows of a table, in the order of the table. Writes `force` of an element.
    """
    return StepEntry("clear_row_forces", (rows,))


def follow_drives(timeline: Timeline, drives: Drives, rows: Rows) -> StepEntry:
    """Sets prescribed velocities at the time of the clock, and over the step that begins there.

    Over rows of a table, in the order of the table. Changes `full`, `half` of an element.
    """
    return StepEntry("follow_drives", (timeline, drives, rows))


def follow_loads(timeline: Timeline, row_loads: RowLoads, moving: Moving, rows: Rows) -> StepEntry:
    """Adds forces and torques of loads to their rows, turned with the element if they follow it.

    Over rows of a table, in the order of the table. Changes `force` of an element.
    """
    return StepEntry("follow_loads", (timeline, row_loads, moving, rows))
