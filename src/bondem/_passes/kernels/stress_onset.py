"""Passes over an index, for devices, of `core/gpu/stress_onset.hpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Kernel
from bondem._tables.cell_tables import ElasticFacets, FacetForces
from bondem._tables.crack_tables import CrackOnset, StressesOfCells
from bondem._tables.damage_tables import StressCandidates, StressFunction
from bondem._tables.device_tables import DeviceSpan
from bondem._tables.step_tables import Moving
from bondem._tables.stress_onset_tables import CandidateFacets


def clear_candidates(candidate_facets: CandidateFacets) -> Kernel:
    """Launched for `find_stress_candidates`: writes the stresses of facets in tension, as candidates of a portion;
    marks facets of cells without cohesion.

    Over one index.
    """
    return Kernel("clear_candidates", (candidate_facets,))


def find_strength_along(candidate_facets: CandidateFacets) -> Kernel:
    """Stores the strengths of facets that begin to crack.

    Over one index.
    """
    return Kernel("find_strength_along", (candidate_facets,))


def find_stress_candidate(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, facet_forces: FacetForces,
    stresses_of_cells: StressesOfCells, crack_onset: CrackOnset, candidate_facets: CandidateFacets
) -> Kernel:
    """Launched for `find_stress_candidates`: writes the stresses of facets in tension, as candidates of a portion;
    marks facets of cells without cohesion.

    Over one index.
    """
    return Kernel("find_stress_candidate", (
        device_span, moving, elastic_facets, facet_forces, stresses_of_cells, crack_onset, candidate_facets
    ))


def index_candidate_by_cone(stress_candidates: StressCandidates, stress_function: StressFunction) -> Kernel:
    """Pass of one index, defined in `core/gpu/stress_onset.hpp`."""
    return Kernel("index_candidate_by_cone", (stress_candidates, stress_function))


def index_candidate_by_mean_stress(stress_candidates: StressCandidates, stress_function: StressFunction) -> Kernel:
    """Pass of one index, defined in `core/gpu/stress_onset.hpp`."""
    return Kernel("index_candidate_by_mean_stress", (stress_candidates, stress_function))


def judge_cell_by_cone(
    device_span: DeviceSpan, stresses_of_cells: StressesOfCells, stress_function: StressFunction,
    candidate_facets: CandidateFacets, crack_onset: CrackOnset
) -> Kernel:
    """Pass of one index, defined in `core/gpu/stress_onset.hpp`."""
    return Kernel("judge_cell_by_cone", (
        device_span, stresses_of_cells, stress_function, candidate_facets, crack_onset
    ))


def judge_cell_by_mean_stress(
    device_span: DeviceSpan, stresses_of_cells: StressesOfCells, stress_function: StressFunction,
    candidate_facets: CandidateFacets, crack_onset: CrackOnset
) -> Kernel:
    """Pass of one index, defined in `core/gpu/stress_onset.hpp`."""
    return Kernel("judge_cell_by_mean_stress", (
        device_span, stresses_of_cells, stress_function, candidate_facets, crack_onset
    ))


def judge_cell_by_size(
    device_span: DeviceSpan, stresses_of_cells: StressesOfCells, candidate_facets: CandidateFacets, crack_onset:
    CrackOnset
) -> Kernel:
    """Finds the cells whose facets are evaluated: those whose stress is large enough for the criterion of a user.

    Over one index.
    """
    return Kernel("judge_cell_by_size", (device_span, stresses_of_cells, candidate_facets, crack_onset))


def mark_failing_facet(
    moving: Moving, elastic_facets: ElasticFacets, facet_forces: FacetForces, stresses_of_cells: StressesOfCells,
    crack_onset: CrackOnset, candidate_facets: CandidateFacets
) -> Kernel:
    """Marks candidates that fail, and replaces their stresses by those whose index gives their strength.

    Over one index.
    """
    return Kernel("mark_failing_facet", (
        moving, elastic_facets, facet_forces, stresses_of_cells, crack_onset, candidate_facets
    ))
