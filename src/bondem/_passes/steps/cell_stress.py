"""Passes that steps are composed of, of `core/passes/cells/cell_stress.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.cell_tables import ElasticFacets, FacetForces, FacetsOfCells
from bondem._tables.step_tables import Moving, StepBlocks


def collect_facet_moments(step_blocks: StepBlocks, facet_forces: FacetForces) -> StepEntry:
    """Adds moments of facets of other domains to the sums of shared cells, and sets their rows to zero.

    Over elements that domains share. Changes `FacetForces.sums` of an element.
    """
    return StepEntry("collect_facet_moments", (step_blocks, facet_forces))


def sum_moments(
    moving: Moving, elastic_facets: ElasticFacets, facets_of_cells: FacetsOfCells, facet_forces: FacetForces
) -> StepEntry:
    """Finds V σ of cells from stored forces at the start of a run, with the bits of the sums of a step.

    Over elements, in portions. Reads `pose` at both ends; adds `moment` to elements.
    """
    return StepEntry("sum_moments", (moving, elastic_facets, facets_of_cells, facet_forces))


def take_moments(facet_forces: FacetForces) -> StepEntry:
    """Sets V σ and Σ `bending_square` of cells from their complete sums, which are set to zero.

    Over elements of a block, then shared ones. Changes `sums` of an element; writes `moment` of an element.
    """
    return StepEntry("take_moments", (facet_forces,))
