"""Tables of the kernels for facets that crack and cells that yield, and their transfer back to the state."""

import numpy as np

from bondem._types import Floats, PerBond
from bondem.kernels.crack_tables import (
    GEOMETRY_COLUMNS,
    HALF_COLUMNS,
    OUTPUT_COLUMNS,
    CellStresses,
    CellYield,
    CrackedFacets,
    CrackTable,
    Onset,
)
from bondem.kernels.tables import CellTable, GripTable
from bondem.model.bond_table import with_zeros
from bondem.model.boundary import Load
from bondem.model.cache_lines import lines
from bondem.model.cell_constants import CellConstants, body_of
from bondem.model.crack_columns import CRACK_COLUMNS, FACET, PARTED, STATUS, TOP
from bondem.model.event_columns import BROKEN_COLUMNS
from bondem.model.loads import Pressure, is_face
from bondem.model.model import Model
from bondem.model.softening_table import SofteningTable
from bondem.model.state import State

# What breaks at once loses this share of its integrity, at most, in the time 1/ω in which the facet between its two
# cells swings by itself, and in a step: the ledger closes, the better the shorter the step.
LOSS = 0.1


def with_forces(cells: CellTable, model: Model, state: State, rows: int) -> CellTable:
    """Return the table of a body that stores the forces of its facets, initially those of the state.

    Args:
        cells: facets and cells.
        model: model with a criterion that softens.
        state: initial state.
        rows: number of rows of sums.
    """
    adjacency, table = model.layout.adjacency, model.softening
    assert table is not None
    return cells._replace(
        bends=with_zeros(4.0 * cells.k[: len(table.area)] / table.area**2),
        in_start=adjacency.in_start, out_start=adjacency.out_start, out_bond=adjacency.out_bond,
        force=with_zeros(state.facet_force), moment=np.zeros((len(state.pose), 7)), sums=lines(rows),
    )  # fmt: skip


def joints(model: Model, state: State, integrity: PerBond) -> tuple[PerBond, PerBond]:
    """Return the joints of the elements of bonds, 0 for none, and contact distances without them [m], (m,) each.

    Cracked facets join two cells as long as their faces face each other.

    Args:
        model: model of the bonds.
        state: state with the present cracks.
        integrity: integrity of the bonds in the form of the loop over them; at least (m,).
    """
    apart = model.bonds.stretched(state.rest_strain).length.copy()
    if model.softening is None:
        return integrity, apart
    joined = (state.integrity > 0.0).astype(float)
    facet, parted = state.cracks[:, FACET].astype(np.int64), state.cracks[:, STATUS] == PARTED
    joined[facet] = np.where(parted, 0.0, 1.0)
    apart[facet[parted]] = np.minimum(apart[facet[parted]], state.cracks[parted, TOP])
    return joined, apart


def crack_table(
    model: Model, state: State, cells: CellTable | None, grips: GripTable, load: Floats, dt: float
) -> CrackTable | None:
    """Return the kernels' table for cracking the facets of a state and yielding its cells, or None if none can.

    Args:
        model: model with a criterion that softens, or without.
        state: state with the present cracks and plastic strains.
        cells: facets and cells, from `with_forces`.
        grips: walls that hold some of them.
        load: force and torque of cracks on each cell, (n, 6).
        dt: time step [s].
    """
    table, constants = model.softening, model.cells
    if table is None or constants is None or cells is None:
        return None
    n, m = len(state.pose), len(state.integrity)
    tensor = np.zeros((n, 6))
    row = np.zeros((m, CRACK_COLUMNS))  # memory is taken as facets crack
    count = len(state.cracks)
    row[:count] = state.cracks
    facet = state.cracks[:, FACET].astype(np.int64)
    pull = np.zeros((m, 3))
    pull[:count] = state.facet_force[:, facet].T
    i, j = model.layout.i, model.layout.j
    swing = np.sqrt(cells.k[:m] * (state.motion[i, 3] + state.motion[j, 3]))  # of a facet by itself [1/s]
    listed = np.zeros(m, dtype=np.uint8)
    facets = CrackedFacets(
        last=table.last, part=table.part, fastest=LOSS * np.minimum(dt * swing, 1.0), area=table.area,
        kink=table.kink, steep=table.steep, friction=table.friction, plane=table.plane.astype(np.uint8),
        cohesion=table.cohesion, last_slip=table.last_slip, tensor=tensor, weight=constants.weight,
        slack_i=constants.slack_i, slack_j=constants.slack_j, now=np.array([0.0, -1.0]), integrity=state.integrity,
        listed=listed, row=row, sizes=np.array([count, 0, 0, 0, 0], dtype=np.int64), flag=np.zeros(m, dtype=np.uint8),
        facet=np.zeros(m, dtype=np.int64), active=np.zeros(m, dtype=np.int64), resting=np.zeros(m, dtype=np.int64),
        geometry=np.zeros((m, GEOMETRY_COLUMNS)), half=np.zeros((2 * m, HALF_COLUMNS)),
        cell=np.zeros(n, dtype=np.int64), head=np.full(n, -1, dtype=np.int64),
        after=np.full(2 * m, -1, dtype=np.int64), stale=np.zeros(n, dtype=np.uint8), base=np.zeros(n),
        pull=pull, output=np.zeros((m, OUTPUT_COLUMNS)), load=load, log=np.empty((m, BROKEN_COLUMNS)),
        released=state.released,
    )  # fmt: skip
    cracked = np.zeros(n, dtype=np.uint8)
    cracked[i[facet]] = cracked[j[facet]] = 1
    return CrackTable(
        stress=CellStresses(volume=constants.volume, tensor=tensor, bending=np.zeros(n)),
        flow=_flow(model, state, table, cells, grips, constants),
        onset=Onset(
            strength=table.strength, area=table.area, plane=np.flatnonzero(table.plane), hot=table.hot,
            judge=0, given=np.zeros(0), cracked=cracked,
            least=table.least, tension=table.tension, hotter=np.zeros(n, dtype=np.uint8),
            marked=np.zeros(m, dtype=np.uint8), listed=listed,
        ),
        facets=facets,
    )  # fmt: skip


def _flow(
    model: Model, state: State, table: SofteningTable, cells: CellTable, grips: GripTable, constants: CellConstants
) -> CellYield:
    """Return the parameters of yielding, unused if no cell can yield."""
    slip, bare, none = table.slip, np.zeros((3, 0), dtype=np.int32), np.zeros(len(constants.volume))
    G = constants.G
    if slip is not None and slip.cone:
        G = G + (9.0 * constants.lame + 6.0 * G) * slip.slope * slip.dilation
    return CellYield(
        yielding=slip is not None, cone=slip is not None and slip.cone,
        cohesion=none if slip is None else slip.strength, sine=none if slip is None else slip.slope,
        dilation=none if slip is None else slip.dilation, fade=none if slip is None else slip.fade, G=G,
        base_i=bare if slip is None else cells.lever_i.copy(), base_j=bare if slip is None else cells.lever_j.copy(),
        base_grip=grips.arm.copy(), pressed=pressed_moments(model), plastic=state.plastic,
    )  # fmt: skip


def pressed_moments(model: Model) -> Floats:
    """Return b⊗F of loads on free facets, xx, yy, zz, xy, xz, yz, in the order of kernels' loads [J], (l, n, 6)."""
    _, cells = body_of(model.lattice)
    free, found = cells.free, []
    for condition in model.boundary:
        if isinstance(condition, Load | Pressure) and is_face(condition.region):
            numbers, force = condition.on_facets(model.lattice)
            cell, moment = free.cell[numbers], np.zeros((len(cells.volume), 6))
            arm = free.centroid[numbers] - cells.centroid[cell]
            for column, (a, b) in enumerate(((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))):
                part = 0.5 * (arm[:, a] * force[:, b] + arm[:, b] * force[:, a])
                moment[:, column] = np.bincount(cell, part, len(moment))
            found.append(moment[model.layout.order])
    return np.array(found).reshape(len(found), len(cells.volume), 6)
