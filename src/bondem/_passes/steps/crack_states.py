"""Passes that steps are composed of, of `core/passes/cracks/crack_states.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.cell_tables import CellDilatation, ElasticFacets
from bondem._tables.crack_tables import CellSlack, CohesiveCracks, CrackLists, FacetStrengths, StressesOfCells
from bondem._tables.step_tables import Moving


def leave_cracks(
    moving: Moving, elastic_facets: ElasticFacets, cell_dilatation: CellDilatation, cell_slack: CellSlack,
    cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Ends the active status of cracks that `soften_cracks` has found to rest, or `measure_cracks` to part.

    Over cracks or their cells, of which threads may share portions. Reads `pose` at both ends; reads
    `CellDilatation.weight`, `half`, `pose.stress` at both ends, for the energy of an event; adds
    `CellDilatation.weight`, `base`, `half`, `outdated` to elements.
    """
    return StepEntry("leave_cracks", (
        moving, elastic_facets, cell_dilatation, cell_slack, cohesive_cracks, crack_lists
    ))


def slide_cracks(
    moving: Moving, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Applies the slip of both cells to the faces of cracks.

    Over cracks or their cells, of which threads may share portions. Reads `pose`, `slip` at both ends.
    """
    return StepEntry("slide_cracks", (moving, elastic_facets, cohesive_cracks, crack_lists))


def soften_cracks(
    moving: Moving, elastic_facets: ElasticFacets, facet_strengths: FacetStrengths, stresses_of_cells:
    StressesOfCells, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Lowers the integrities of cracks, and finds cracks that become resting.

    Over cracks or their cells, of which threads may share portions. Reads `pose`, `pose.stress`, `tensor` at
    both ends; adds `half` to elements.
    """
    return StepEntry("soften_cracks", (
        moving, elastic_facets, facet_strengths, stresses_of_cells, cohesive_cracks, crack_lists
    ))


def sum_cracks(
    stresses_of_cells: StressesOfCells, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Sums the forces of the cracks of each cell, and finds the slip of their faces under these forces.

    Over cracks or their cells, of which threads may share portions. Reads `half` of an element; adds `carried`,
    `slip`, `sum` to elements.
    """
    return StepEntry("sum_cracks", (stresses_of_cells, cohesive_cracks, crack_lists))


def wake_cracks(
    moving: Moving, elastic_facets: ElasticFacets, cell_dilatation: CellDilatation, cell_slack: CellSlack,
    cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Makes resting cracks active if they are about to soften or close; parts those whose faces have turned away.

    Over cracks or their cells, of which threads may share portions. Reads `pose` at both ends; adds
    `CellDilatation.weight`, `base`, `half`, `outdated` to elements.
    """
    return StepEntry("wake_cracks", (
        moving, elastic_facets, cell_dilatation, cell_slack, cohesive_cracks, crack_lists
    ))


def watch_resting_cracks(
    moving: Moving, elastic_facets: ElasticFacets, facet_strengths: FacetStrengths, cohesive_cracks:
    CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Finds the resting cracks that are about to soften or close.

    Over cracks or their cells, of which threads may share portions. Reads `pose`, `pose.stress` at both ends.
    """
    return StepEntry("watch_resting_cracks", (moving, elastic_facets, facet_strengths, cohesive_cracks, crack_lists))
