"""Load factors at which facets begin to crack or soften further, where all loads grow in proportion.

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
    """Return the load factors at which uncracked facets begin to crack, inf for skipped facets, (c,).

    Args:
        loaded: loads of facets and cells at a factor of 1.
        strengths: strengths of the facets.
        whole: numbers of the uncracked facets, (c,).
        below: largest factor of interest [-].
        spread: largest factor of interest, over the smallest of `below` and the factors of all facets [-].
    """
    search = OnsetSearch(np.ascontiguousarray(whole, dtype=np.int64), below, spread, np.empty(len(whole)))
    run_pass(calls.find_onset_factors(loaded, strengths, search))
    return search.factor


def softening_along(
    loaded: LoadedFacets, strengths: FacetStrengths, facets: Ints, traction: Floats, integrity: PerBond,
    across: Floats | None = None,
) -> SofteningSearch:
    """Compute the load factors at which cracked facets soften further, `factor` of the result, along each direction.

    The directions are the principal directions of the stress of both cells; for material planes they have no meaning.

    Args:
        loaded: loads of facets and cells at a factor of 1.
        strengths: strengths of the facets.
        facets: numbers of the cracked facets, (c,).
        traction: traction that these facets would have if they were uncracked [Pa], (c, 3).
        integrity: integrity of these facets [-], (c,).
        across: the one direction in which a facet softens, or zero, (c, 3); None for zero.
    """
    c = len(facets)
    search = SofteningSearch(
        np.ascontiguousarray(facets, dtype=np.int64), np.ascontiguousarray(traction), integrity,
        np.zeros((c, 3)) if across is None else across, np.empty((c, 3)),
        np.empty((c, 3, 3)), np.empty((c, 3, 3)), np.empty(c),
    )  # fmt: skip
    run_pass(calls.find_softening_factors(loaded, strengths, search))
    return search


def agreed_stresses(loaded: LoadedFacets) -> Floats:
    """Return σ* (`bd.Rankine`) of all facets, with the normal traction increased by bending [Pa], (m, 3, 3)."""
    m = len(loaded.i)
    candidates = new_stress_candidates(m)._replace(bond=np.arange(m))
    run_pass(calls.find_agreed_stresses(loaded, candidates))
    return candidates.stress
