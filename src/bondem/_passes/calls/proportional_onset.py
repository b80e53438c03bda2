"""Passes that Python calls, of `core/passes/damage/proportional_onset.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.crack_tables import FacetStrengths
from bondem._tables.damage_tables import StressCandidates
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
