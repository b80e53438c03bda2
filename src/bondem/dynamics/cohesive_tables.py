"""Tables of cracked facets and of cells that yield, as `core/tables/crack_tables.hpp` declares them."""

from typing import NamedTuple

import numpy as np

from bondem._cache_lines import lines
from bondem._types import Floats, Ints
from bondem.damage.crack_columns import (
    ACTIVE,
    AXES,
    BEFORE,
    CRACK_COLUMNS,
    FACET,
    FRESH,
    GAMMA,
    KIND,
    LEFT,
    ONSET,
    ONSET_STEP,
    RATE,
    RUB,
    SLIP,
    SPENT,
    STATUS,
    TOP,
)
from bondem.damage.softening_table import SofteningTable
from bondem.interactions.beams.bond_table import with_zeros
from bondem.interactions.cells.cell_constants import CellConstants
from bondem.interactions.cells.cell_tables import ElasticFacets, FacetForces, WallConstraints
from bondem.model.model import Model
from bondem.model.state import State

# Places of a portion of a list, as in the core, and places behind a list that lanes and prefetching read.
_PORTION, _BEHIND = 256, 64
#: Column of the history of a crack that says in which step it began.
BEGAN = 5


class StressesOfCells(NamedTuple):
    """Mean stresses of n cells, and Σ b⊗f of their cracks."""

    volume: Floats  #: [m³], (n,)
    tensor: Floats  #: stress in the last step, xx … yz [Pa], Σ T_b² [Pa²], size [Pa], (n, 8)
    carried: Floats  #: Σ b⊗f of cracks, b in the reference [J], (n, 12)
    pressed: Floats  #: contribution of loads on free facets to V σ at full load [J], (l, n, 6)


class YieldingCells(NamedTuple):
    """Cells that yield."""

    cone: bool  #: whether by Drucker and Prager
    cohesion: Floats  #: c cos φ or k [Pa], inf for cells that do not yield, (n,)
    slope: Floats
    dilation: Floats
    stiffness: Floats  #: [Pa]
    fade: Floats  #: share of the cohesion lost by a mean slip of 1 of the cells near, (n,)
    near_start: Ints  #: cells near cell p are near[near_start[p]] …, (n + 1,)
    near: np.ndarray  #: uint32
    slipped: Floats  #: Σ Δγ before a step, (n,)
    held: Floats  #: that of a state: slip that the next step begins with, (n,)
    plastic: Floats  #: that of a state, (n, 17)
    base_i: np.ndarray  #: levers of facets without plastic strain [pitch], int32, (3, m)
    base_j: np.ndarray
    base_wall: Floats  #: those of walls [m], (g, 3)


class FacetStrengths(NamedTuple):
    """Strengths of m facets."""

    area: Floats  #: [m²]
    strength: Floats  #: f_t [Pa]
    absorbed: Floats  #: G_f A [J], inf of brittle facets
    brittleness: Floats  #: 1 over the traction k u / A of the last opening [1/Pa]
    part: Floats  #: part of cell i in the compliance
    fastest: Floats  #: largest loss of integrity in a step of facets that break at once
    friction: Floats
    plane: Floats  #: 1 for facets of material planes
    cohesion: Floats  #: cohesion of these [Pa]
    slip_brittleness: Floats  #: the same as `brittleness` for slip [1/Pa]
    planes: Ints  #: facets of material planes
    kink: float
    steep: float
    hot: float  #: largest principal stress of a cell from which its facets are judged [Pa]


class CrackOnset(NamedTuple):
    """Facets that begin to crack."""

    cracked: np.ndarray  #: 1 for cells with cracks, uint8, (n,)
    judged: np.ndarray  #: 1 for cells whose facets are judged, 2 for those without cohesion, uint8, (n,)
    marked: np.ndarray  #: 1 or 2 for facets that begin, uint8, (m,)
    listed: np.ndarray  #: that of `CohesiveCracks`
    found: Ints  #: number of marks of each portion of facets, and of planes


class CohesiveCracks(NamedTuple):
    """Cracked facets, by the number of their facet; rows as in `core/passes/cracks/crack_rows.hpp`."""

    shape: Floats  #: (m, 8), and so on
    face: Floats
    state: Floats
    frame: Floats
    past: Floats
    softening: Floats
    history: Floats
    pull: Floats  #: force on cell i [N], (m, 4)
    pitch: Floats  #: unit of levers [m], (3,)
    order: Ints  #: cracked facets in the order in which they began
    listed: np.ndarray  #: 0 for whole facets, else 1 and the status of the crack, uint8, (m,)
    integrity: Floats  #: that of a state, (m,)
    size: Ints  #: number of cracks, and 1 where lists are out of date, (2,)
    slide: float  #: largest slip of faces of material planes that face each other, over √A, at most 1 [-]

    @classmethod
    def of(cls, state: State, listed: np.ndarray, slide: float) -> "CohesiveCracks":
        """Return the cracks of a state; memory is taken as facets crack."""
        m, count = len(state.integrity), len(state.cracks)
        cracks = cls(
            lines(m), lines(m), lines(m), lines(m), lines(m), lines(m), lines(m), np.zeros((m, 4)), np.zeros(3),
            np.zeros(m, np.int64), listed, state.integrity, np.array([count, 1], dtype=np.int64), slide,
        )  # fmt: skip
        facet = state.cracks[:, FACET].astype(np.int64)
        cracks.order[:count] = facet
        for column, table, of_row in cracks._columns():
            table[facet, of_row] = state.cracks[:, column]
        cracks.pull[facet, :3] = state.facet_force[:, facet].T
        return cracks

    def _columns(self) -> list[tuple[int | slice, Floats, int | slice]]:
        """Return columns of the cracks of a state, with the table and the columns that have them here."""
        def columns(first: int, number: int) -> slice:
            return slice(first, first + number)

        return [
            (ONSET, self.softening, 7), (columns(AXES, 4), self.frame, columns(0, 4)),
            (columns(LEFT, 4), self.frame, columns(4, 4)), (columns(RATE, 4), self.past, columns(4, 4)),
            (columns(BEFORE, 4), self.past, columns(0, 4)), (columns(SLIP, 3), self.state, columns(0, 3)),
            (columns(RUB, 3), self.state, columns(3, 3)), (STATUS, self.history, 0), (SPENT, self.history, 1),
            (TOP, self.shape, 7), (FRESH, self.state, 6), (KIND, self.state, 7), (ONSET_STEP, self.history, 6),
        ]  # fmt: skip

    def keep(self, kept: FacetForces, state: State) -> None:
        """Write the cracks and the forces of facets into a state."""
        facet = self.order[: self.size[0]]
        state.cracks = np.empty((len(facet), CRACK_COLUMNS))
        state.cracks[:, FACET] = facet
        for column, table, of_row in self._columns():
            state.cracks[:, column] = table[facet, of_row]
        state.facet_force[:] = kept.force[:, : state.facet_force.shape[1]]
        state.facet_force[:, facet[self.integrity[facet] == 0.0]] = 0.0
        active = facet[state.cracks[:, STATUS] == ACTIVE]
        state.facet_force[:, active] = self.pull[active, :3].T


class CellSlack(NamedTuple):
    """Facets of each cell, and their slack."""

    in_start: Ints
    out_start: Ints
    out_bond: np.ndarray  #: uint32
    slack_i: Floats  #: increase of 1 / weight of a cell if the facet parts [m³/Pa], (m,)
    slack_j: Floats
    weight: Floats  #: λ / V of each cell with all its facets [Pa/m³], (n,)


class CrackLists(NamedTuple):
    """Lists of a step, and data of the cracks on them; see the header."""

    size: Ints
    treated: Ints
    resting: Ints
    treated_i: np.ndarray
    treated_j: np.ndarray
    resting_i: np.ndarray
    resting_j: np.ndarray
    parted: Ints
    cell: np.ndarray
    head: np.ndarray
    number: np.ndarray
    side: np.ndarray
    node: np.ndarray
    flag: np.ndarray
    waking: np.ndarray
    flagged: Ints
    woken: Ints
    stale: np.ndarray
    base: Floats
    half: Floats
    sum: Floats
    slip: Floats
    lost: Floats

    @classmethod
    def of(cls, n: int, m: int) -> "CrackLists":
        """Room for lists of m facets of n cells; memory is taken as facets crack."""
        places = m + _BEHIND
        portions, halves = places // _PORTION + 1, 2 * places + 2
        numbers, shorts = np.zeros(places, np.int64), np.zeros(places, np.uint32)
        flags = np.zeros(places, np.uint8)
        return cls(
            np.zeros(4, np.int64), numbers, numbers.copy(), shorts, shorts.copy(), shorts.copy(), shorts.copy(),
            numbers.copy(),
            np.zeros(n + _BEHIND, np.uint32), np.zeros(n, np.int32),
            np.zeros((places, 2), np.int32), np.zeros(halves, np.int32), np.zeros((halves, 4), np.int32), flags,
            flags.copy(), np.zeros(portions, np.int64), np.zeros(portions, np.int64), np.zeros(n, np.uint8),
            np.zeros(n), lines(2 * halves).reshape(halves, 16), lines(n),
            np.zeros((n, 4)), np.zeros((portions, 2)),
        )  # fmt: skip


class PartedReach(NamedTuple):
    """Distances at which elements touch that facets do not join any more."""

    apart: Floats  #: by facet [m]


class CrackEnergies(NamedTuple):
    """Energies of cells with cracks."""

    dilatation: Floats  #: of portions of cells [J]
    heat: Floats  #: dissipated by yielding, of portions of cells [J]
    cracked: Floats  #: across and along cracks, and of bending [J], (3,)


def facet_strengths(table: SofteningTable, fastest: Floats) -> FacetStrengths:
    """Return the strengths of facets; `fastest` is the largest loss of integrity in a step of brittle ones."""
    with np.errstate(divide="ignore"):
        brittleness, slip = 1.0 / table.last, 1.0 / table.last_slip
    columns = (
        table.area, table.strength, table.absorbed, brittleness, table.part, fastest, table.friction,
        table.plane.astype(float), table.cohesion, slip,
    )  # fmt: skip
    names = FacetStrengths._fields[: len(columns)]
    filled = dict(zip(names, map(np.ascontiguousarray, map(with_zeros, columns)), strict=True))
    planes = np.flatnonzero(table.plane).astype(np.int64)
    return FacetStrengths(**filled, planes=planes, kink=table.kink, steep=table.steep, hot=table.hot)


def facet_forces(state: State, facets: ElasticFacets, area: Floats, rows: int) -> FacetForces:
    """Return the forces of facets that a run keeps, initially those of a state without its active cracks."""
    force = with_zeros(state.facet_force).copy()
    active = state.cracks[:, STATUS] == ACTIVE
    force[:, state.cracks[active, FACET].astype(np.int64)] = 0.0
    bends = with_zeros(4.0 * facets.k[: len(area)] / area**2)
    return FacetForces(bends, force, np.zeros((len(state.pose), 7)), lines(rows))


def yielding_of(
    model: Model, state: State, table: SofteningTable, facets: ElasticFacets, walls: WallConstraints,
    constants: CellConstants,
) -> YieldingCells | None:  # fmt: skip
    """Return the cells that yield, or None if none can."""
    slip = table.slip
    if slip is None:
        return None
    G, lame = constants.G, constants.lame
    # by which F falls per slip while the total strain stays
    stiffness = G + ((9.0 * lame + 6.0 * G) if slip.cone else (lame + G)) * slip.slope * slip.dilation
    return YieldingCells(
        slip.cone, slip.strength, slip.slope, slip.dilation, stiffness, slip.fade, slip.near_start,
        slip.near.astype(np.uint32), state.plastic[:, GAMMA].copy(), state.held_slip, state.plastic,
        facets.lever_i.copy(), facets.lever_j.copy(), walls.arm.copy(),
    )  # fmt: skip
