"""Passes that steps are composed of, of `core/passes/cells/facet_traction.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.cell_tables import CellDilatation, FacetTractions
from bondem._tables.step_tables import Moving, Rows, Timeline


def add_traction_work(moving: Moving, facet_tractions: FacetTractions, rows: Rows) -> StepEntry:
    """Adds half the work of tractions that change, by the present stresses, to the rows of their cells.

    Over elements of a block, then shared ones. Reads `pose.stress` of an element.
    """
    return StepEntry("add_traction_work", (moving, facet_tractions, rows))


def follow_tractions(
    timeline: Timeline, facet_tractions: FacetTractions, cell_dilatation: CellDilatation
) -> StepEntry:
    """Sets the factors of tractions at the time of the clock, and their contributions to V θ of cells.

    Over rows of a table, in the order of the table. Writes `given` of an element.
    """
    return StepEntry("follow_tractions", (timeline, facet_tractions, cell_dilatation))
