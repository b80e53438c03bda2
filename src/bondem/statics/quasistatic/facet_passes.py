"""Facets of any integrity in small motions, and the search for those that fail next, by the core.

`core/tables/quasistatic_tables.hpp` declares types and shapes.
"""

import numpy as np

from bondem._core import bound_pass, run_pass
from bondem._passes import calls
from bondem._tables.quasistatic_tables import FacetLoading, LoadedFacets, OnsetSearch, SmallMotions, WeakenedFacets
from bondem._types import Floats, Ints


class OpenedFacets:
    """Facets of any integrity in small motions of their cells: gaps, dilatations and loads.

    The tables are made once. The integrity of the facets and their closed halves are read at each call.

    Attributes:
        motions: motions to evaluate, gaps and dilatations.
        loading: loads, overwritten at each call.
    """

    def __init__(self, facets: WeakenedFacets, n: int) -> None:
        """Make the tables of facets between n cells."""
        m = len(facets.k)
        self.motions = SmallMotions(np.zeros((n, 3)), np.zeros((n, 3)), np.zeros((m, 3)), np.zeros(n))
        self.loading = FacetLoading(
            np.zeros(n), np.zeros((m, 3)), np.zeros(m), np.zeros((m, 3)), np.zeros(m),
            np.zeros((m, 2), dtype=np.uint8), np.zeros((n, 6)),
        )  # fmt: skip
        self._open = bound_pass(calls.open_weakened_facets(facets, self.motions))
        self._load = bound_pass(calls.load_weakened_facets(facets, self.motions, self.loading))

    def swelling(self, displacement: Floats, rotation: Floats, given: Floats) -> Floats:
        """Return V θ of the cells under motions (n, 3), added to given values [m³], (n,)."""
        self.motions.displacement[:], self.motions.rotation[:] = displacement, rotation
        self.motions.swelling[:] = given
        self._open()
        return self.motions.swelling.copy()

    def load(self, stress: Floats, moment: Floats) -> FacetLoading:
        """Return a copy of the loads at the stresses of cells; facets add to their moments, (n, 6)."""
        self.loading.stress[:], self.loading.moment[:] = stress, moment
        self._load()
        return FacetLoading._make(part.copy() for part in self.loading)


def factors_by_stress(loaded: LoadedFacets, whole: Ints, below: float, spread: float) -> Floats:
    """Return the load factors at which whole facets begin to crack, inf for those that are passed over, (c,).

    Args:
        loaded: loads of facets and cells at a factor of 1.
        whole: whole facets, (c,).
        below: largest factor of interest.
        spread: largest factor over the least of all.
    """
    search = OnsetSearch(np.ascontiguousarray(whole, dtype=np.int64), below, spread, np.empty(len(whole)))
    run_pass(calls.find_stress_factors(loaded, search))
    return search.factor
