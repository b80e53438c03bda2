"""Tables of `core/tables/stress_onset_tables.hpp`, written by `python -m tests.core.tables` from the header."""

from typing import NamedTuple

from bondem._types import Floats, Ints


class CandidateFacets(NamedTuple):
    """Facets that begin to crack by a function of the stress."""

    scale: Floats  #: f_t without scatter over f_t of each facet, 0 of material planes [-], (m,)
    area: Floats  #: [m²], (m,)
    tension: float  #: f_t without scatter [Pa]
    least: float  #: size √(σ:σ) below which no stress reaches the criterion [Pa]
    hot: float  #: f_t below which the facets of a cell are not evaluated [Pa]
    along: Floats  #: largest principal stress at which a facet began to crack, else its f_t [Pa], (m,)
    bond: Ints  #: arrays of `StressCandidates`, (candidates,)
    stress: Floats  #: (candidates, 3, 3)
    found: Floats  #: (candidates,)
    number: Ints  #: (bond_portions,)
    total: Ints  #: (1,)
