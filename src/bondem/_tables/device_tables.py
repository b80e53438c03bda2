"""Tables of `core/tables/device_tables.hpp`, written by `python -m tests.core.tables` from the header."""

from typing import NamedTuple

from bondem._types import Bytes, Floats, Int32s, Ints, Uint32s


class DeviceSpan(NamedTuple):
    """The clock of a run on a device, and how many elements and bonds there are."""

    clock: Ints  #: word by word: times and coefficients of the scheme (5), step, first, continues, record;, (9,)
    postponed: Bytes  #: not 0 for elements that do not open the next step with the others, (*,)
    halted: Ints  #: 1 where a list of contacts has to be made anew before the step goes on, (1,)
    n: int
    m: int


class Tick(NamedTuple):
    """Change of the clock."""

    ahead: int  #: by how many steps
    goes_on: int  #: whether elements open the next step
    still: int  #: whether the step has no time
    first: int  #: whether the time was not reached by a step


class LoadsOfBonds(NamedTuple):
    """Loads of each bond on its two ends."""

    load: Floats  #: force on j, torque on i, torque on j [N, N·m], (9, *)


class BondMarks(NamedTuple):
    """Bonds whose load reaches their bound, and those of them that fail."""

    mark: Bytes  #: 1 for bonds near to failure, 2 for those that fail, (bonds,)
    failing: Uint32s  #: bonds that fail in a step, in any order, (bonds,)
    mode: Bytes  #: how, (bonds,)


class SofteningLosses(NamedTuple):
    """Energy that beams dissipate in a step."""

    lost: Floats  #: by the place of their rows in the lists of `SofteningBeams` [J], (bonds,)


class BondsOfElements(NamedTuple):
    """Bonds of each element, both lists ascending."""

    in_start: Int32s  #: bonds in_start[p] … in_start[p + 1] have j = p, (n + 1,)
    out_start: Int32s  #: where the list of those with i = p begins, (n + 1,)
    out_bond: Uint32s  #: (*,)


class EarlierPairs(NamedTuple):
    """Pairs of contact whose earlier element each element is, ascending."""

    start: Int32s  #: (n + 1,)
    pair: Uint32s  #: (pairs,)


class RowOrder(NamedTuple):
    """Loads of each row, or walls, in their order."""

    start: Ints  #: where those of each row begin, (*,)
    load: Ints  #: (*,)


class WorkPortions(NamedTuple):
    """Sums over portions of the works."""

    works: Floats  #: work and its absolute value [J], (work_portions, 2)


class StrainPortions(NamedTuple):
    """Changes of strains in a step, and portions of their power."""

    due: Ints  #: whether any changes, and whether ∂U/∂factor is needed, (2,)
    power: Floats  #: ∂U/∂factor [J], (*, *)


class WallEnergy(NamedTuple):
    """Energy of portions of walls that hold facets."""

    energy: Floats  #: [J], (wall_portions,)


class LossesOfCracks(NamedTuple):
    """Energies that cracks dissipate in a step, and cracks that break."""

    lost: Floats  #: of each facet [J], (*,)
    portion: Floats  #: sums of it, (loss_portions,)
    group: Floats  #: sums of it, (loss_groups,)
    fallen: Ints  #: facets, in any order until they are logged, (*,)
    number: Ints  #: how many, (1,)


class BegunFaces(NamedTuple):
    """Energy that faces store as they begin to touch."""

    gained: Floats  #: of each portion of elements [J], (element_portions,)


class FacetArms(NamedTuple):
    """Levers of the cells of each facet in space, and the square of T_b."""

    arm: Floats  #: [m], and T_b² [Pa²], (7, *)


class CrackPortions(NamedTuple):
    """Energies of cracks of portions of facets."""

    energy: Floats  #: across and along cracks, and of bending [J], (*, 3)


class CrushingPortions(NamedTuple):
    """Energies that portions of facets have released beyond their fracture energy."""

    energy: Floats  #: [J], (*,)


class FoldedPortions(NamedTuple):
    """Sums over groups of portions."""

    sums: Floats  #: first columns of `device_column`, (folds, 13)


class GaugeParts(NamedTuple):
    """Parts of the sums or largest values of gauges."""

    each: int  #: for each gauge
    parts: Floats  #: (*, 3)
