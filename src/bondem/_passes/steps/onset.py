"""Passes that steps are composed of, of `core/passes/cracks/onset.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.cell_tables import ElasticFacets, FacetForces
from bondem._tables.crack_tables import CohesiveCracks, CrackOnset, FacetStrengths, StressesOfCells
from bondem._tables.step_tables import Moving


def begin_cracks(
    elastic_facets: ElasticFacets, facet_forces: FacetForces, facet_strengths: FacetStrengths, crack_onset:
    CrackOnset, cohesive_cracks: CohesiveCracks
) -> StepEntry:
    """Begins the cracks of facets that are marked.

    Over events of the step, such as failures, in their order. Adds `cracked` to elements.
    """
    return StepEntry("begin_cracks", (elastic_facets, facet_forces, facet_strengths, crack_onset, cohesive_cracks))


def mark_cracking_facets(
    moving: Moving, elastic_facets: ElasticFacets, facet_forces: FacetForces, facet_strengths: FacetStrengths,
    stresses_of_cells: StressesOfCells, crack_onset: CrackOnset
) -> StepEntry:
    """Marks facets of the material that begin to crack, and all whole facets of cells without cohesion.

    Over bonds, in portions. Reads `judged`, `pose`, `tensor` at both ends.
    """
    return StepEntry("mark_cracking_facets", (
        moving, elastic_facets, facet_forces, facet_strengths, stresses_of_cells, crack_onset
    ))


def mark_cracking_planes(
    moving: Moving, elastic_facets: ElasticFacets, facet_forces: FacetForces, facet_strengths: FacetStrengths,
    crack_onset: CrackOnset
) -> StepEntry:
    """Marks facets of planes, such as joints, that begin to crack.

    Over rows of a table, in the order of the table. Reads `pose` at both ends.
    """
    return StepEntry("mark_cracking_planes", (moving, elastic_facets, facet_forces, facet_strengths, crack_onset))
