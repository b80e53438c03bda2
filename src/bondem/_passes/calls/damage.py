"""Passes that Python calls, of `core/passes/damage`; written by `python -m tests.core.passes`."""

from bondem._passes import Call
from bondem._tables.crack_tables import FacetStrengths
from bondem._tables.damage_tables import FailureIndices, Strengths, StressCandidates, StressFunction
from bondem._tables.step_tables import Beams, Poses
from bondem._tables.stress_onset_tables import LoadedFacets, OnsetSearch, SofteningSearch, SofteningTeeth


def cut_teeth(softening_teeth: SofteningTeeth) -> Call:
    """Cuts a softening curve into steps."""
    return Call("cut_teeth", (softening_teeth,))


def find_agreed_stresses(loaded_facets: LoadedFacets, stress_candidates: StressCandidates) -> Call:
    """Finds σ* of facets, with the opening traction of bending added to their traction."""
    return Call("find_agreed_stresses", (loaded_facets, stress_candidates))


def find_onset_factors(
    loaded_facets: LoadedFacets, facet_strengths: FacetStrengths, onset_search: OnsetSearch
) -> Call:
    """Finds the load factors at which whole facets begin to crack and to soften."""
    return Call("find_onset_factors", (loaded_facets, facet_strengths, onset_search))


def find_softening_factors(
    loaded_facets: LoadedFacets, facet_strengths: FacetStrengths, softening_search: SofteningSearch
) -> Call:
    """Finds the load factors at which facets lose integrity along each direction."""
    return Call("find_softening_factors", (loaded_facets, facet_strengths, softening_search))


def index_beams_by_elliptic(
    poses: Poses, beams: Beams, strengths: Strengths, failure_indices: FailureIndices
) -> Call:
    """Finds the index of every beam by a criterion, in any poses, as many at once as there are lanes."""
    return Call("index_beams_by_elliptic", (poses, beams, strengths, failure_indices))


def index_beams_by_linear_sum(
    poses: Poses, beams: Beams, strengths: Strengths, failure_indices: FailureIndices
) -> Call:
    """Finds the index of every beam by a criterion, in any poses, as many at once as there are lanes."""
    return Call("index_beams_by_linear_sum", (poses, beams, strengths, failure_indices))


def index_beams_by_mohr_coulomb(
    poses: Poses, beams: Beams, strengths: Strengths, failure_indices: FailureIndices
) -> Call:
    """Finds the index of every beam by a criterion, in any poses, as many at once as there are lanes."""
    return Call("index_beams_by_mohr_coulomb", (poses, beams, strengths, failure_indices))


def index_beams_by_peripheral_stress(
    poses: Poses, beams: Beams, strengths: Strengths, failure_indices: FailureIndices
) -> Call:
    """Finds the index of every beam by a criterion, in any poses, as many at once as there are lanes."""
    return Call("index_beams_by_peripheral_stress", (poses, beams, strengths, failure_indices))


def index_stresses_by_cone(stress_candidates: StressCandidates, stress_function: StressFunction) -> Call:
    """Finds the index of each given stress; the counts of portions are not read."""
    return Call("index_stresses_by_cone", (stress_candidates, stress_function))


def index_stresses_by_function(stress_candidates: StressCandidates, stress_function: StressFunction) -> Call:
    """Finds the index of each given stress; the counts of portions are not read."""
    return Call("index_stresses_by_function", (stress_candidates, stress_function))


def index_stresses_by_mean_stress(stress_candidates: StressCandidates, stress_function: StressFunction) -> Call:
    """Finds the index of each given stress; the counts of portions are not read."""
    return Call("index_stresses_by_mean_stress", (stress_candidates, stress_function))


#: Passes `index_beams_by_…` by the name of their criterion.
INDEX_BEAMS_BY = {
    "elliptic": index_beams_by_elliptic,
    "linear_sum": index_beams_by_linear_sum,
    "mohr_coulomb": index_beams_by_mohr_coulomb,
    "peripheral_stress": index_beams_by_peripheral_stress,
}
#: Passes `index_stresses_by_…` by the name of their criterion.
INDEX_STRESSES_BY = {
    "cone": index_stresses_by_cone,
    "function": index_stresses_by_function,
    "mean_stress": index_stresses_by_mean_stress,
}
