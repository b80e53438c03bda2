"""Tables of a device beside those of a step, as `core/tables/device_tables.hpp` declares them."""

from typing import NamedTuple

import numpy as np

from bondem._types import Floats, Ints


class DeviceSpan(NamedTuple):
    """The clock of a run on a device, and how many elements and bonds there are."""

    clock: Ints  #: word by word: times and coefficients of the scheme (5), step, first, goes on, record; (9,)
    postponed: np.ndarray  #: not 0 for elements that do not open the next step with the others, uint8, (n,), or (0,)
    halted: Ints  #: 1 where a list of contacts has to be made anew before the step goes on, (1,)
    n: int
    m: int


class Tick(NamedTuple):
    """Change of the clock."""

    ahead: int  #: by how many steps
    goes_on: bool  #: whether elements open the next step
    still: bool  #: whether the step has no time
    first: bool  #: whether the time was not reached by a step


class LoadsOfBonds(NamedTuple):
    """Loads of each bond on its two ends."""

    load: Floats  #: force on j, torque on i, torque on j [N, N·m], (9, m)


class BondMarks(NamedTuple):
    """Bonds whose load reaches their bound, and those of them that fail."""

    mark: np.ndarray  #: 1 for bonds near to failure, 2 for those that fail, uint8, (m,)
    failing: np.ndarray  #: bonds that fail in a step, in any order, uint32, (m,)
    mode: np.ndarray  #: how, uint8, (m,)


class SofteningLosses(NamedTuple):
    """Energy that beams dissipate in a step."""

    lost: Floats  #: by the place of their rows in the lists of `SofteningBeams` [J], (m,)


class BondsOfElements(NamedTuple):
    """Bonds of each element, both lists ascending."""

    in_start: np.ndarray  #: bonds in_start[p] … in_start[p + 1] have j = p, int32, (n + 1,)
    out_start: np.ndarray  #: where the list of those with i = p begins, int32, (n + 1,)
    out_bond: np.ndarray  #: uint32, (m,)


class EarlierPairs(NamedTuple):
    """Pairs of contact whose earlier element each element is, ascending."""

    start: np.ndarray  #: int32, (n + 1,)
    pair: np.ndarray  #: uint32


class RowOrder(NamedTuple):
    """Loads of each row, or walls, in their order."""

    start: Ints  #: where those of each row begin, (r + 1,)
    load: Ints

    @classmethod
    def of(cls, row: Ints, rows: int) -> "RowOrder":
        """Return the order of loads or walls on some rows."""
        counts = np.bincount(row, minlength=rows)
        start = np.concatenate([[0], np.cumsum(counts)]).astype(np.int64)
        return cls(start, np.argsort(row, kind="stable").astype(np.int64))


class WorkPortions(NamedTuple):
    """Sums over portions of the works."""

    works: Floats  #: work and its absolute value [J], (portions, 2)


class StrainPortions(NamedTuple):
    """Changes of strains in a step, and portions of what their work needs."""

    due: Ints  #: whether any changes, and whether ∂U/∂factor is needed, (2,)
    power: Floats  #: ∂U/∂factor [J], (portions, g)


class WallEnergy(NamedTuple):
    """Energy of portions of walls that hold facets."""

    energy: Floats  #: [J], (portions,)


class LossesOfCracks(NamedTuple):
    """Energies that cracks dissipate in a step, and cracks that break."""

    lost: Floats  #: of each facet [J], (m,)
    portion: Floats  #: sums of it
    group: Floats
    fallen: Ints  #: facets, in any order until they are logged, (m,)
    number: Ints  #: how many, (1,)


class BegunFaces(NamedTuple):
    """Energy that faces which begin to touch take over."""

    gained: Floats  #: of each portion of elements [J]


class FacetArms(NamedTuple):
    """Levers of the cells of each facet in space, and the square of what bending opens."""

    arm: Floats  #: [m], and T_b² [Pa²], (7, m)


class CrackPortions(NamedTuple):
    """Energies of cracks of portions of facets."""

    energy: Floats  #: across and along cracks, and of bending [J], (portions, 3)


class CrushingPortions(NamedTuple):
    """Energies that portions of facets have released beyond their fracture energy."""

    energy: Floats  #: [J], (portions,)


class FoldedPortions(NamedTuple):
    """Sums over groups of portions."""

    sums: Floats  #: columns as in `SUM_COLUMNS`, (groups, 13)


class GaugeParts(NamedTuple):
    """Parts of the sums or largest values of gauges."""

    each: int  #: for each gauge
    parts: Floats  #: (gauges · each, 3)


#: Columns of sums, as in `core/gpu/record.hpp`: energies of elements and of bonds, bonds turned too far and numbers
#: that are not finite, works.
SUM_COLUMNS = (
    "translation", "rotation", "damped", "rubbed", "normal", "shear", "bending", "twisting", "wide", "lost",
    "not_finite", "work", "supplied",
)  # fmt: skip
#: Columns behind them in a record: energies of contacts, of non-local stresses, that bonds released, of plasticity,
#: and of the released energy that of crushing; work of walls.
FURTHER_COLUMNS = ("contact", "non_local", "released", "plastic", "crushing", "walls")
#: Portions of a group, and works or walls of a portion.
GROUP, WORKS = 64, 1024
