"""Passes that steps are composed of, of `core/passes/boundary/strains.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.step_tables import Beams, Moving, Rows, Strain, Timeline


def follow_strains(timeline: Timeline, strain: Strain, moving: Moving, beams: Beams, rows: Rows) -> StepEntry:
    """Adapts strained beams to their lengths L (1 + ε*), and adds the work of the strains.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("follow_strains", (timeline, strain, moving, beams, rows))
