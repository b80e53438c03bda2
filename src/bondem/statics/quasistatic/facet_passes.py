"""Facets of any integrity in small motions, and the search for those that fail next, by the core.

`core/tables/quasistatic_tables.hpp` declares types and shapes.
"""

from typing import NamedTuple

import numpy as np

from bondem._core import Pass
from bondem._types import Floats, Ints


class WeakenedFacets(NamedTuple):
    """Constants and states of m facets; see `bondem.interactions.cells.cell_constants`."""

    i: Ints  #: (m,)
    j: Ints
    k: Floats  #: [N/m]
    area: Floats  #: [m²]
    part: Floats  #: part of cell i in the compliance [-]
    lever_i: Floats  #: [m], (m, 3)
    lever_j: Floats
    share_i: Floats  #: A w m [m²], (m, 3)
    share_j: Floats
    normal: Floats  #: [-], (m, 3)
    H: Floats  #: [N·m], (m, 3, 3)
    integrity: Floats  #: [-]
    closed: np.ndarray  #: 1 for halves that press, uint8, (m, 2)


class SmallMotions(NamedTuple):
    """Small motions of n cells, and their gaps and dilatations."""

    displacement: Floats  #: [m], (n, 3)
    rotation: Floats  #: [rad], (n, 3)
    gap: Floats  #: of the facets [m], (m, 3)
    swelling: Floats  #: V θ of the cells [m³], to which facets add, (n,)


class FacetLoading(NamedTuple):
    """Loads of facets and cells at given stresses."""

    stress: Floats  #: λ θ of the cells [Pa], (n,)
    traction: Floats  #: [Pa], (m, 3)
    bending: Floats  #: T_b of each facet, as if it were whole [Pa], (m,)
    opening: Floats  #: traction of facets that have lost integrity, as if they were whole [Pa], (m, 3)
    opened: Floats  #: |F⁺| / A of these [Pa], (m,)
    turned: np.ndarray  #: 1 for halves of these that close or open, uint8, (m, 2)
    moment: Floats  #: V σ of the cells, to which facets add, xx, yy, zz, xy, xz, yz [J], (n, 6)


class LoadedFacets(NamedTuple):
    """Facets and cells under a load factor of 1."""

    i: Ints  #: (m,)
    j: Ints
    normal: Floats  #: [-], (m, 3)
    traction: Floats  #: [Pa], (m, 3)
    bending: Floats  #: T_b [Pa], (m,)
    tensor: Floats  #: σ of each cell [Pa], (n, 6)
    strength: Floats  #: f_t [Pa], (m,)


class OnsetSearch(NamedTuple):
    """Whole facets, and the load factors at which they begin to crack."""

    whole: Ints  #: (c,)
    below: float  #: largest factor of interest
    spread: float  #: largest factor over the least of all
    factor: Floats  #: inf of facets that are passed over, (c,)


_open = Pass("open_weakened_facets", WeakenedFacets, SmallMotions)
_load = Pass("load_weakened_facets", WeakenedFacets, SmallMotions, FacetLoading)
_find = Pass("find_stress_factors", LoadedFacets, OnsetSearch)


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
        self._open = _open.bound(facets, self.motions)
        self._load = _load.bound(facets, self.motions, self.loading)

    def swelling(self, displacement: Floats, rotation: Floats, given: Floats) -> Floats:
        """Return V θ of the cells under motions (n, 3), with what is given [m³], (n,)."""
        self.motions.displacement[:], self.motions.rotation[:] = displacement, rotation
        self.motions.swelling[:] = given
        self._open()
        return self.motions.swelling.copy()

    def load(self, stress: Floats, moment: Floats) -> FacetLoading:
        """Return a copy of the loads at the stresses of cells; facets add to their moments, (n, 6)."""
        self.loading.stress[:], self.loading.moment[:] = stress, moment
        self._load()
        return FacetLoading(*(part.copy() for part in self.loading))


def factors_by_stress(loaded: LoadedFacets, whole: Ints, below: float, spread: float) -> Floats:
    """Return the load factors at which whole facets begin to crack, inf for those that are passed over, (c,).

    Args:
        loaded: loads of facets and cells at a factor of 1.
        whole: whole facets, (c,).
        below: largest factor of interest.
        spread: largest factor over the least of all.
    """
    search = OnsetSearch(np.ascontiguousarray(whole, dtype=np.int64), below, spread, np.empty(len(whole)))
    _find(loaded, search)
    return search.factor
