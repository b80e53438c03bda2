"""Passes that steps are composed of, of `core/passes/cracks/stress_onset.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.cell_tables import ElasticFacets, FacetForces
from bondem._tables.crack_tables import CrackOnset, StressesOfCells
from bondem._tables.damage_tables import StressFunction
from bondem._tables.step_tables import Moving
from bondem._tables.stress_onset_tables import CandidateFacets


def find_strengths_along(candidate_facets: CandidateFacets) -> StepEntry:
    """Stores the strengths of facets that begin to crack.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("find_strengths_along", (candidate_facets,))


def find_stress_candidates(
    moving: Moving, elastic_facets: ElasticFacets, facet_forces: FacetForces, stresses_of_cells: StressesOfCells,
    crack_onset: CrackOnset, candidate_facets: CandidateFacets
) -> StepEntry:
    """Writes the stresses of facets in tension, as candidates of a portion; marks facets of cells without
    cohesion.

    Over bonds, in portions. Reads `judged`, `pose`, `tensor` at both ends.
    """
    return StepEntry("find_stress_candidates", (
        moving, elastic_facets, facet_forces, stresses_of_cells, crack_onset, candidate_facets
    ))


def judge_cells_by_cone(
    stresses_of_cells: StressesOfCells, stress_function: StressFunction, candidate_facets: CandidateFacets,
    crack_onset: CrackOnset
) -> StepEntry:
    """Finds the cells whose facets are evaluated: those whose stress may reach the criterion.

    Over elements, in portions. Reads `cracked`, `tensor` of an element; writes `judged` of an element.
    """
    return StepEntry("judge_cells_by_cone", (stresses_of_cells, stress_function, candidate_facets, crack_onset))


def judge_cells_by_mean_stress(
    stresses_of_cells: StressesOfCells, stress_function: StressFunction, candidate_facets: CandidateFacets,
    crack_onset: CrackOnset
) -> StepEntry:
    """Finds the cells whose facets are evaluated: those whose stress may reach the criterion.

    Over elements, in portions. Reads `cracked`, `tensor` of an element; writes `judged` of an element.
    """
    return StepEntry("judge_cells_by_mean_stress", (
        stresses_of_cells, stress_function, candidate_facets, crack_onset
    ))


def judge_cells_by_size(
    stresses_of_cells: StressesOfCells, candidate_facets: CandidateFacets, crack_onset: CrackOnset
) -> StepEntry:
    """Finds the cells whose facets are evaluated: those whose stress is large enough for the criterion of a user.

    Over elements, in portions. Reads `cracked`, `tensor` of an element; writes `judged` of an element.
    """
    return StepEntry("judge_cells_by_size", (stresses_of_cells, candidate_facets, crack_onset))


def mark_failing_facets(
    moving: Moving, elastic_facets: ElasticFacets, facet_forces: FacetForces, stresses_of_cells: StressesOfCells,
    crack_onset: CrackOnset, candidate_facets: CandidateFacets
) -> StepEntry:
    """Marks candidates that fail, and replaces their stresses by those whose index gives their strength.

    Over events of the step, such as failures, in their order. Reads `pose`, `tensor` at both ends.
    """
    return StepEntry("mark_failing_facets", (
        moving, elastic_facets, facet_forces, stresses_of_cells, crack_onset, candidate_facets
    ))
