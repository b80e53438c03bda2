"""Tables of `core/tables/device_tables.hpp`, written by `python -m tests.core.tables` from the header."""

from typing import NamedTuple

from bondem._types import Bytes, Floats, Int32s, Ints, Uint32s


class DeviceSpan(NamedTuple):
    """The clock of a run on a device, and how many elements and bonds there are."""

    clock: Ints  #: words of `Clock`: time, dt and coefficients of the scheme (5), step, first, goes_on, record, (9,)
    postponed: Bytes  #: not 0 for elements that do not open the next step with the others, (*,)
    halted: Ints  #: 1 where a list of contacts has to be made anew before the step goes on, (1,)
    n: int  #: number of elements
    m: int  #: number of bonds


class Tick(NamedTuple):
    """Change of the clock of a device."""

    ahead: int  #: number of steps ahead
    goes_on: int  #: 1 if elements open the next step
    still: int  #: 1 for a step of duration 0
    first: int  #: 1 at the start of a call of the loop, before its first step


class LoadsOfBonds(NamedTuple):
    """Loads of each bond on its two ends."""

    load: Floats  #: force on j, torque on i, torque on j [N, N·m], (9, *)


class BondMarks(NamedTuple):
    """Bonds whose load reaches their bound, and those of them that fail."""

    mark: Bytes  #: 1 for bonds near to failure, 2 for those that fail, (bonds,)
    failing: Uint32s  #: bonds that fail in a step, in any order, (bonds,)
    mode: Bytes  #: `failure_mode` of the bonds in `failing`, (bonds,)


class BondsOfElements(NamedTuple):
    """Bonds of each element, both lists ascending."""

    in_start: Int32s  #: bonds in_start[p] … in_start[p + 1] - 1 have j = p, (n + 1,)
    out_start: Int32s  #: start of the bonds with i = p in `out_bond`, (n + 1,)
    out_bond: Uint32s  #: bonds by their elements i, (*,)


class EarlierPairs(NamedTuple):
    """Contact pairs of each element as the earlier one of the pair, ascending."""

    start: Int32s  #: start of the pairs of each element, (n + 1,)
    pair: Uint32s  #: numbers of the pairs, element by element, (pairs,)


class RowOrder(NamedTuple):
    """Loads, walls or contacts that act on each row, cell or wall, in their order."""

    start: Ints  #: start of the entries of each row, cell or wall in `load`, (*,)
    load: Ints  #: numbers of the loads, walls or contacts, (*,)


class FallenCracks(NamedTuple):
    """Cracks that break in a step."""

    fallen: Ints  #: facets, in any order until they are logged, (*,)
    number: Ints  #: number of facets in `fallen`, (1,)


class FacetArms(NamedTuple):
    """Levers of the cells of each facet in space, and the square of T_b."""

    arm: Floats  #: [m], and T_b² [Pa²], (7, *)


class GaugeParts(NamedTuple):
    """Sums of gauges, and largest values of their parts."""

    each: int  #: parts of each gauge
    sums: Ints  #: exact sums of the components of gauges, zero between records, (*, 68)
    largest: Floats  #: largest absolute values of each part, (*, 3)
