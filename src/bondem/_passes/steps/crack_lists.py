"""Passes that steps are composed of, of `core/passes/cracks/crack_lists.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.cell_tables import CellDilatation, CellStrains, ElasticFacets, FacetForces
from bondem._tables.crack_tables import CellSlack, CohesiveCracks, CrackLists, FacetStrengths, StressesOfCells


def carry_cracks(
    stresses_of_cells: StressesOfCells, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Sums b⊗f of the cracks of each cell from their forces of the last step, and finds its leading crack.

    Over cracks or their cells, of which threads may share portions. Adds `carried`, `leader` to elements.
    """
    return StepEntry("carry_cracks", (stresses_of_cells, cohesive_cracks, crack_lists))


def follow_levers(
    cell_strains: CellStrains, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks
) -> StepEntry:
    """Copies levers of facets that strains of cells have changed.

    Over cracks or their cells, of which threads may share portions.
    """
    return StepEntry("follow_levers", (cell_strains, elastic_facets, cohesive_cracks))


def link_cracks(
    elastic_facets: ElasticFacets, facet_forces: FacetForces, facet_strengths: FacetStrengths, cohesive_cracks:
    CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Prepares the cracks of a state at the start of a run: constants, weights of cells, lists, and forces of
    cracks.

    Over cracks or their cells, of which threads may share portions. Adds `half`, `slip` to elements.
    """
    return StepEntry("link_cracks", (elastic_facets, facet_forces, facet_strengths, cohesive_cracks, crack_lists))


def list_cracks(elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists) -> StepEntry:
    """Rebuilds the lists of cracks if they are out of date.

    Over cracks or their cells, of which threads may share portions.
    """
    return StepEntry("list_cracks", (elastic_facets, cohesive_cracks, crack_lists))


def weigh_cracked_cells(
    elastic_facets: ElasticFacets, cell_dilatation: CellDilatation, cell_slack: CellSlack, cohesive_cracks:
    CohesiveCracks
) -> StepEntry:
    """Computes the weights of the cells of all cracks at the start of a run.

    Over cracks or their cells, of which threads may share portions. Adds `CellDilatation.weight` to elements.
    """
    return StepEntry("weigh_cracked_cells", (elastic_facets, cell_dilatation, cell_slack, cohesive_cracks))
