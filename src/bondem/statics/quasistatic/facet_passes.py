"""Passes of the core over facets of any integrity, in small motions.

`core/tables/quasistatic_tables.hpp` declares types and shapes.
"""

import numpy as np

from bondem._core import bound_pass
from bondem._passes import calls
from bondem._tables.quasistatic_tables import FacetLoading, SmallMotions, WeakenedFacets
from bondem._types import Floats


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
        """Return the volume changes of cells by motions [m, rad], (n, 3) each, plus those `given` [m³], (n,)."""
        self.motions.displacement[:], self.motions.rotation[:] = displacement, rotation
        self.motions.swelling[:] = given
        self._open()
        return self.motions.swelling.copy()

    def load(self, stress: Floats, moment: Floats) -> FacetLoading:
        """Return loads of facets at dilatation stresses of cells [Pa], (n,), and the sums V σ + `moment`, (n, 6)."""
        self.loading.stress[:], self.loading.moment[:] = stress, moment
        self._load()
        return FacetLoading._make(part.copy() for part in self.loading)
