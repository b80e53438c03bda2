"""Tables of `core/tables/stress_onset_tables.hpp`, written by `python -m tests.core.tables` from the header."""

from typing import NamedTuple

from bondem._types import Floats, Ints


class CandidateFacets(NamedTuple):
    """Facets that begin to crack by a function of the stress."""

    scale: Floats  #: f_t without scatter over f_t of each facet, 0 of material planes [-], (m,)
    area: Floats  #: [m²], (m,)
    tension: float  #: f_t without scatter [Pa]
    least: float  #: size √(σ:σ) below which no stress reaches the criterion [Pa]
    hot: float  #: strength by which cells are evaluated: stresses of a cell count tension / hot times [Pa]
    along: Floats  #: largest principal stress at which a facet began to crack, else its f_t [Pa], (m,)
    bond: Ints  #: arrays of `StressCandidates`, (candidates,)
    stress: Floats  #: (candidates, 3, 3)
    found: Floats  #: (candidates,)
    number: Ints  #: (bond_portions,)
    total: Ints  #: (1,)


class LoadedFacets(NamedTuple):
    """Facets and cells under a load factor of 1."""

    i: Ints  #: (m,)
    j: Ints  #: (m,)
    normal: Floats  #: [-], (m, 3)
    traction: Floats  #: [Pa], (m, 3)
    bending: Floats  #: T_b [Pa], (m,)
    tensor: Floats  #: σ of each cell, xx, yy, zz, xy, xz, yz [Pa], (n, 6)


class OnsetSearch(NamedTuple):
    """Whole facets, and the load factors at which they begin to crack."""

    whole: Ints  #: numbers of the facets, (whole,)
    below: float  #: largest factor of interest
    spread: float  #: largest factor over the least of all
    factor: Floats  #: load factor at onset, inf of facets that are not evaluated or never begin, (whole,)


class SofteningSearch(NamedTuple):
    """Facets that have begun to crack, and the load factors at which they soften further."""

    facet: Ints  #: (listed,)
    traction: Floats  #: as if they were whole [Pa], (listed, 3)
    integrity: Floats  #: [-], (listed,)
    across: Floats  #: direction in which a facet softens alone, zero for all directions [-], (listed, 3)
    #: load factor where the integrity along each of three directions falls below `integrity`, inf for never,
    #: (listed, 3)
    factor: Floats
    #: for each direction [Pa]: traction as of a whole facet, at onset of softening, at zero integrity (0 if
    #: brittle), (listed, 3, 3)
    line: Floats
    direction: Floats  #: these directions, by rows; without meaning for material planes, (listed, 3, 3)
    ended: Floats  #: load factors at which the integrity is zero in all directions, (listed,)


class SofteningTeeth(NamedTuple):
    """Steps of a softening curve within a band around it."""

    onset: float  #: traction from which the facet softens [Pa]
    last: float  #: T at zero integrity [Pa], 0 for a brittle facet
    kink: float  #: κ of the curve [-]
    steep: float  #: m of the curve [-]
    ripple: float  #: half-width of the band, as a share
    now: float  #: T at the beginning, if it exceeds the onset [Pa]
    left: Floats  #: integrity after each event but the last, after which it is zero, (teeth,)
    limit: Floats  #: T of the event that follows `left` [Pa], (teeth,)
    beyond: Floats  #: `limit` over the T at which the curve itself softens the facet further [-], (teeth,)
    number: Ints  #: number of steps; only as many are written as there is room, (1,)
