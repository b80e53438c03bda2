"""Passes that steps are composed of, of `core/passes/boundary`; written by `python -m tests.core.passes`."""

from bondem._passes import StepEntry
from bondem._tables.step_tables import Beams, CoupleTable, Drives, Moving, RowLoads, Rows, Strain, Timeline


def clear_row_forces(rows: Rows) -> StepEntry:
    """Sets the forces of all rows to zero, before loads are added.

    Over rows of a table, in the order of the table. Writes `force` of an element.
    """
    return StepEntry("clear_row_forces", (rows,))


def follow_couples(timeline: Timeline, couple_table: CoupleTable, moving: Moving, rows: Rows) -> StepEntry:
    """Adds moments on regions as forces and torques of their elements.

    Over rows of a table, in the order of the table. Reads `pose` at both ends; adds `force` to elements.
    """
    return StepEntry("follow_couples", (timeline, couple_table, moving, rows))


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


def follow_strains(timeline: Timeline, strain: Strain, moving: Moving, beams: Beams, rows: Rows) -> StepEntry:
    """Sets rest lengths L (1 + ε*), and adds the work of the strains.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("follow_strains", (timeline, strain, moving, beams, rows))
