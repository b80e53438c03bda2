"""Onset and softening of facets where all loads are proportional to a factor, by the core.

`core/tables/stress_onset_tables.hpp` declares types and shapes.
"""

import math

import numpy as np

from bondem._core import run_pass
from bondem._passes import calls
from bondem._tables.crack_tables import FacetStrengths
from bondem._tables.stress_onset_tables import LoadedFacets, OnsetSearch, SofteningSearch
from bondem._types import Floats, Ints, PerBond
from bondem.damage.stress_passes import new_stress_candidates


def onset_factors(
    loaded: LoadedFacets, strengths: FacetStrengths, whole: Ints, below: float = math.inf, spread: float = math.inf
) -> PerBond:
    """Return the load factors at which whole facets begin to crack, inf for those that are not evaluated, (c,).

    Args:
        loaded: loads of facets and cells at a factor of 1.
        strengths: strengths of the facets.
        whole: facets, (c,).
        below: largest factor of interest.
        spread: largest factor over the least of all.
    """
    search = OnsetSearch(np.ascontiguousarray(whole, dtype=np.int64), below, spread, np.empty(len(whole)))
    run_pass(calls.find_onset_factors(loaded, strengths, search))
    return search.factor


def softening_along(
    loaded: LoadedFacets, strengths: FacetStrengths, facets: Ints, traction: Floats, integrity: PerBond
) -> SofteningSearch:
    """Find the load factors at which facets that have begun to crack soften further, along each direction.

    Directions are the principal ones of the stress of both cells; a material plane has its own.

    Args:
        loaded: loads of facets and cells at a factor of 1.
        strengths: strengths of the facets.
        facets: facets, (c,).
        traction: traction of these, as if they were whole [Pa], (c, 3).
        integrity: integrity of these [-], (c,).
    """
    c = len(facets)
    search = SofteningSearch(
        np.ascontiguousarray(facets, dtype=np.int64), np.ascontiguousarray(traction), integrity, np.empty((c, 3)),
        np.empty((c, 3, 3)), np.empty((c, 3, 3)), np.empty(c),
    )  # fmt: skip
    run_pass(calls.find_softening_factors(loaded, strengths, search))
    return search


def agreed_stresses(loaded: LoadedFacets) -> Floats:
    """Return σ* of all facets, with the opening traction of bending added to the normal traction [Pa], (m, 3, 3)."""
    m = len(loaded.i)
    candidates = new_stress_candidates(m)._replace(bond=np.arange(m))
    run_pass(calls.find_agreed_stresses(loaded, candidates))
    return candidates.stress
