"""Tables of cracked facets and of cells that yield, as `core/tables/crack_tables.hpp` declares them."""

import numpy as np

from bondem._cache_lines import exact_sums, lines
from bondem._tables.cell_tables import ElasticFacets, FacetForces, WallConstraints
from bondem._tables.columns import CrackNumber, CrackStatus, PlasticColumn
from bondem._tables.crack_tables import CohesiveCracks, CrackLists, YieldingCells
from bondem._types import Floats
from bondem.damage import crack_columns as at
from bondem.damage.failing_state import FailingState
from bondem.damage.softening_table import SofteningTable
from bondem.interactions.beams.bond_table import with_zeros
from bondem.interactions.cells.cell_constants import CellConstants

# Places per portion of a list, as in the core, and places behind a list that vector lanes and prefetching may read.
_PORTION, _BEHIND = 256, 64
#: Column of the history of a crack with the step in which it began, below 0 for cracks of the initial state.
BEGAN = 5


def new_cohesive_cracks(state: FailingState, listed: np.ndarray, slide: float) -> CohesiveCracks:
    """Return the cracks of a state as tables for all facets, whose memory is used only as facets crack.

    The core writes the status of each crack into `listed`, one byte per facet. `slide` is the slip over √A from which
    faces of a material plane no longer face each other [-].
    """
    m, count = len(state.integrity), len(state.cracks)
    cracks = CohesiveCracks(
        lines(m), lines(m), lines(m), lines(m), lines(m), lines(m), lines(m), np.zeros((m, 4)),
        np.zeros((m, 8), np.int32), np.zeros(3),
        np.zeros(m, np.int64), listed, state.integrity, np.array([count, 1], dtype=np.int64), slide,
    )  # fmt: skip
    facet = state.cracks[:, at.FACET].astype(np.int64)
    cracks.order[:count] = facet
    for column, table, of_row in _columns_of_cracks(cracks):
        table[facet, of_row] = state.cracks[:, column]
    cracks.pull[facet, :3] = state.facet_force[:, facet].T
    return cracks


def _columns_of_cracks(cracks: CohesiveCracks) -> list[tuple[int | slice, Floats, int | slice]]:
    """Return columns of `State.cracks`, each with a table of a run and its columns for the same values."""
    def columns(first: int, number: int) -> slice:
        return slice(first, first + number)

    return [
        (columns(at.AXES, 4), cracks.frame, columns(0, 4)), (columns(at.LEFT, 4), cracks.frame, columns(4, 4)),
        (columns(at.BEFORE, 4), cracks.past, columns(0, 4)), (columns(at.ROOT, 4), cracks.past, columns(4, 4)),
        (columns(at.SLIP, 3), cracks.state, columns(0, 3)), (columns(at.RUB, 3), cracks.state, columns(3, 3)),
        (at.FRESH, cracks.state, 6), (at.KIND, cracks.state, 7), (at.ONSET, cracks.softening, 7),
        (at.TOP, cracks.shape, 7), (at.STATUS, cracks.history, 0), (at.SPENT, cracks.history, 1),
        (at.ONSET_STEP, cracks.history, 6),
    ]  # fmt: skip


def keep_cracks(cracks: CohesiveCracks, stored: FacetForces, state: FailingState) -> None:
    """Write the cracks and the forces of facets into a state."""
    facet = cracks.order[: cracks.size[CrackNumber.CRACKS]]
    state.cracks = np.empty((len(facet), at.CRACK_COLUMNS))
    state.cracks[:, at.FACET] = facet
    rows: dict[int, Floats] = {}  # whole rows are copied several times faster than parts of them
    for column, table, of_row in _columns_of_cracks(cracks):
        if id(table) not in rows:
            rows[id(table)] = table.take(facet, axis=0)
        state.cracks[:, column] = rows[id(table)][:, of_row]
    state.facet_force[:] = stored.force[:, : state.facet_force.shape[1]]
    broken = facet[cracks.integrity[facet] == 0.0]
    active = facet[state.cracks[:, at.STATUS] == CrackStatus.ACTIVE]
    pull = cracks.pull.take(active, axis=0)
    for axis, force in enumerate(state.facet_force):
        force[broken] = 0.0
        force[active] = pull[:, axis]


def new_crack_lists(n: int, m: int) -> CrackLists:
    """Return empty lists of cracks for n cells and m facets, whose memory is used only as facets crack."""
    places = m + _BEHIND
    portions, halves = places // _PORTION + 1, 2 * places + 2
    numbers, shorts = np.zeros(places, np.int64), np.zeros(places, np.uint32)
    flags = np.zeros(places, np.uint8)
    return CrackLists(
        np.zeros(4, np.int64), numbers, numbers.copy(), shorts, shorts.copy(), shorts.copy(), shorts.copy(),
        numbers.copy(),
        np.zeros(n + _BEHIND, np.uint32), np.zeros(n, np.int32),
        np.zeros(halves, np.int32), flags, flags.copy(),
        np.zeros(portions, np.int64), np.zeros(portions, np.int64), np.zeros(n, np.uint8), np.full(n, -1, np.int32),
        np.zeros(n),
        lines(2 * halves).reshape(halves, 16), lines(n),
        np.zeros((n, 4)), exact_sums(),
    )  # fmt: skip


def facet_forces(state: FailingState, facets: ElasticFacets, area: Floats, rows: int) -> FacetForces:
    """Return the table of facet forces: those of the state, zero on facets whose cracks each step evaluates.

    `area` has the areas of the facets [m²], (m,); `rows` is the number of rows of the sums of a step.
    """
    force = with_zeros(state.facet_force).copy()
    active = state.cracks[:, at.STATUS] == CrackStatus.ACTIVE
    force[:, state.cracks[active, at.FACET].astype(np.int64)] = 0.0
    bends = with_zeros(4.0 * facets.k[: len(area)] / area**2)
    return FacetForces(bends, force, np.zeros((len(state.pose), 7)), lines(rows))


def yielding_of(
    state: FailingState, table: SofteningTable, facets: ElasticFacets, walls: WallConstraints,
    constants: CellConstants,
) -> tuple[YieldingCells, ...]:  # fmt: skip
    """Return the table of the cells that yield, in a tuple that is empty if none can."""
    G, lame = constants.G, constants.lame
    return tuple(
        YieldingCells(
            slip.cone, slip.strength, slip.slope, slip.dilation,
            # decrease of the yield function per slip at constant total strain
            G + ((9.0 * lame + 6.0 * G) if slip.cone else (lame + G)) * slip.slope * slip.dilation,
            slip.fade, slip.near_start, slip.near.astype(np.uint32), state.plastic[:, PlasticColumn.GAMMA].copy(),
            state.held_slip, state.plastic, facets.lever_i.copy(), facets.lever_j.copy(), walls.arm.copy(),
        )
        for slip in table.yielding
    )  # fmt: skip
