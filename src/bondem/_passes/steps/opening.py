"""Passes that steps are composed of, of `core/passes/cracks/opening.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.cell_tables import CellDilatation, ElasticFacets
from bondem._tables.crack_tables import CellSlack, CohesiveCracks, CrackLists, StressesOfCells
from bondem._tables.step_tables import Moving


def begin_bases(moving: Moving, cell_dilatation: CellDilatation, crack_lists: CrackLists) -> StepEntry:
    """Stores V θ of cells without their active cracks, from their stresses and weights.

    Over elements, in portions. Reads `pose.stress`, `weight` of an element; writes `base` of an element.
    """
    return StepEntry("begin_bases", (moving, cell_dilatation, crack_lists))


def measure_cracks(
    moving: Moving, elastic_facets: ElasticFacets, cell_slack: CellSlack, stresses_of_cells: StressesOfCells,
    cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Finds faces and halves of the active cracks, axes of cracks before any loss of integrity, and cracks that
    part.

    Over cracks or their cells, of which threads may share portions. Reads `leader`, `pose`, `tensor` at both
    ends and at their neighbours; adds `half` to elements.
    """
    return StepEntry("measure_cracks", (
        moving, elastic_facets, cell_slack, stresses_of_cells, cohesive_cracks, crack_lists
    ))


def relax_cracked_cells(moving: Moving, cell_dilatation: CellDilatation, crack_lists: CrackLists) -> StepEntry:
    """Finds the stresses of all cells with active cracks.

    Over cracks or their cells, of which threads may share portions. Reads `base`, `half`, `weight` of an
    element; adds `pose.stress` to elements.
    """
    return StepEntry("relax_cracked_cells", (moving, cell_dilatation, crack_lists))


def relax_outdated_cells(
    moving: Moving, cell_dilatation: CellDilatation, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Finds the stresses of cells with active cracks again where they are out of date, and their leading cracks.

    Over cracks or their cells, of which threads may share portions. Reads `base`, `half`, `weight` of an
    element; adds `leader`, `pose.stress`, `outdated` to elements.
    """
    return StepEntry("relax_outdated_cells", (moving, cell_dilatation, cohesive_cracks, crack_lists))
