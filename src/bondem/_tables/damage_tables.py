"""Tables of `core/tables/damage_tables.hpp`, written by `python -m tests.core.tables` from the header."""

from typing import NamedTuple

from bondem._types import Bytes, Floats, Ints, Singles, Uint32s


class FailureBounds(NamedTuple):
    """Bounds of the loads of bonds, below which no bond fails."""

    limit: Singles  #: bound of of_force |F|² + of_moment (|M_i|² + |M_j|²), inf for bonds that cannot fail, (m,)
    of_force: float  #: [1/N²]
    of_moment: float  #: [1/(N·m)²]


class Strengths(NamedTuple):
    """Coefficients of the criterion of each bond."""

    coefficient: Floats  #: (bonds, 4)
    station: Floats  #: place where the moment counts, from i over the length; below 0 for the larger end, (bonds,)


class Candidates(NamedTuple):
    """Bonds that are near to failure, and then those of them that fail, in the order of the bonds."""

    begin: Ints  #: first bond of each block, (blocks + 1,)
    marked: Ints  #: numbers of the bonds; those of a block from begin[block] on, (bonds,)
    mode: Ints  #: modes of bonds that fail, (bonds,)
    count: Ints  #: number of bonds in `marked` of each block, (blocks,)
    any: Ints  #: 1 where a bond fails in this step, (1,)


class Postponed(NamedTuple):
    """Postponed elements, which close a step with all bonds and open the next one without failed bonds."""

    flag: Bytes  #: not 0 for elements that are postponed, (n,)
    element: Uint32s  #: lists of postponed elements, (n,)
    row: Uint32s  #: rows of the sums of the elements in the lists, (n,)
    first_row: int  #: first of the rows of `StepBlocks.sums` that keep sums of postponed elements, one per element
    sum: Floats  #: sums of postponed elements until they resume, in the rows from `first_row` on, (n, 8)


class EventLog(NamedTuple):
    """Failures of one call of the core, in the order of time."""

    event: Floats  #: time [s], step, bond, mode, gap [m], energy [J], place [m], steps since onset, (bonds, 10)
    pressed: Floats  #: largest overlap with which a contact may take over from each event [m], (bonds,)
    written: Ints  #: number of events, and of those before the present step, (2,)
    released: Floats  #: energy released since the start of the run [J], (1,)
    crushed: Floats  #: energy released beyond the fracture energy before the run [J], (1,)


class BeamIntegrity(NamedTuple):
    """Integrity of beams, which failure changes."""

    integrity: Floats  #: 1 intact … 0 broken [-], (m,)
    per_length: Floats  #: integrity over rest length of beams that share their constants [1/m], (*,)


class FailureIndices(NamedTuple):
    """Index of the criterion of each bond."""

    index: Floats  #: 1 at failure, 0 of broken bonds [-], (m,)


class LoadedTractions(NamedTuple):
    """Facets with given tractions, for which a criterion is evaluated."""

    normal: Floats  #: [-], (m, 3)
    traction: Floats  #: [Pa], (m, 3)
    area: Floats  #: [m²], (m,)


class StressCandidates(NamedTuple):
    """Bonds or facets whose stress a criterion evaluates in a step, with their stresses."""

    bond: Ints  #: bonds; those of a portion begin at the number of its first bond, (candidates,)
    stress: Floats  #: symmetric [Pa], (candidates, 3, 3)
    found: Floats  #: index of each, at 1 a bond fails [-], (candidates,)
    number: Ints  #: number of candidates of each portion, (bond_portions,)
    total: Ints  #: number of candidates of all portions, once moved together, (1,)


class StressFunction(NamedTuple):
    """A criterion that is a function of a stress."""

    address: int  #: of a C function (`passes/damage/stress_criteria.hpp`), 0 for a criterion of the core
    parameter: Floats  #: (parameters,)
