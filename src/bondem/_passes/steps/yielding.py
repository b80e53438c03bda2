"""Passes that steps are composed of, of `core/passes/cracks/yielding.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.cell_tables import CellStrains, ElasticFacets, FacetsOfCells, FacetTractions, WallConstraints
from bondem._tables.crack_tables import CohesiveCracks, CrackOnset, FacetStrengths, StressesOfCells, YieldingCells
from bondem._tables.step_tables import Moving, Rows


def add_yielding_work(
    facet_tractions: FacetTractions, stresses_of_cells: StressesOfCells, yielding_cells: YieldingCells, rows: Rows
) -> StepEntry:
    """Adds the work of loads on free facets that move as their cells yield to the rows of these cells.

    Over elements of a block, then shared ones. Reads `plastic`, `tensor` of an element.
    """
    return StepEntry("add_yielding_work", (facet_tractions, stresses_of_cells, yielding_cells, rows))


def stretch_all_cells(
    elastic_facets: ElasticFacets, facets_of_cells: FacetsOfCells, yielding_cells: YieldingCells
) -> StepEntry:
    """Stretches levers of all facets with the plastic deformation of their cells, as a run begins.

    Over elements, in portions. Reads `plastic` at both ends; changes `slipped` of an element.
    """
    return StepEntry("stretch_all_cells", (elastic_facets, facets_of_cells, yielding_cells))


def stretch_anew(
    cell_strains: CellStrains, elastic_facets: ElasticFacets, facets_of_cells: FacetsOfCells, wall_constraints:
    WallConstraints, yielding_cells: YieldingCells
) -> StepEntry:
    """Stretches levers with the plastic deformation of their cells, where stress-free strains have changed them.

    Over rows of a table, in the order of the table. Reads `plastic` at both ends; changes `arm`, `slipped` of
    an element; writes `base_wall` of an element.
    """
    return StepEntry("stretch_anew", (
        cell_strains, elastic_facets, facets_of_cells, wall_constraints, yielding_cells
    ))


def stretch_cells(
    elastic_facets: ElasticFacets, facets_of_cells: FacetsOfCells, yielding_cells: YieldingCells
) -> StepEntry:
    """Stretches levers of facets with the plastic deformation of their cells, where it has grown.

    Over elements, in portions. Reads `plastic` at both ends; changes `slipped` of an element.
    """
    return StepEntry("stretch_cells", (elastic_facets, facets_of_cells, yielding_cells))


def stretch_walls_and_cracks(
    elastic_facets: ElasticFacets, wall_constraints: WallConstraints, yielding_cells: YieldingCells,
    cohesive_cracks: CohesiveCracks
) -> StepEntry:
    """Stretches levers of walls and cracks with the plastic deformation of their cells, where it has grown.

    Over cracks or their cells, of which threads may share portions. Reads `base_wall` of an element; reads
    `plastic` at both ends; adds `arm` to elements.
    """
    return StepEntry("stretch_walls_and_cracks", (elastic_facets, wall_constraints, yielding_cells, cohesive_cracks))


def yield_cells(
    moving: Moving, facet_strengths: FacetStrengths, stresses_of_cells: StressesOfCells, yielding_cells:
    YieldingCells, crack_onset: CrackOnset
) -> StepEntry:
    """Applies plastic flow to the cells of a portion whose stress reaches their yield surface.

    Over elements, in portions. Reads `pose`, `tensor` of an element; reads `slipped` at both ends; adds
    `carry`, `plastic` to elements; changes `judged` of an element.
    """
    return StepEntry("yield_cells", (moving, facet_strengths, stresses_of_cells, yielding_cells, crack_onset))
