"""Tables of the kernels for facets that crack and cells that yield, and what comes back from them."""

import math

import numpy as np

from bondem._types import Floats
from bondem.kernels.cell_tensors import stretch_body
from bondem.kernels.crack_list import link_cracks
from bondem.kernels.crack_tables import ACTIVE, CRACK_COLUMNS, FACET, GEOMETRY_COLUMNS, STATUS, CrackTable
from bondem.kernels.tables import BROKEN_COLUMNS, Bonds, CellTable, GripTable
from bondem.model.boundary import Load
from bondem.model.cell_constants import body_of
from bondem.model.loads import Pressure, is_face
from bondem.model.model import Model
from bondem.model.state import State


def crack_table(model: Model, state: State, cells: CellTable | None, grips: GripTable) -> CrackTable | None:
    """What kernels take to let the facets of a state crack and its cells yield; None where none do.

    Args:
        model: with a criterion that softens, or without.
        state: what has cracked and yielded so far.
        cells: facets and cells; they keep their forces in `state.facet_force`.
        grips: walls that hold some of them.
    """
    table, constants = model.softening, model.cells
    if table is None or constants is None or cells is None:
        return None
    n, m = len(state.pose), len(state.integrity)
    row = np.zeros((m, CRACK_COLUMNS))  # memory is taken as facets crack
    count = len(state.cracks)
    row[:count] = state.cracks
    facet = state.cracks[:, FACET].astype(np.int64)
    pull = np.zeros((m, 3))
    pull[:count] = state.facet_force[:, facet].T
    adjacency, slip = model.layout.adjacency, table.slip
    angle = 0.0 if slip is None else slip.friction_angle
    bare = np.zeros((3, 0), dtype=np.int32)
    return CrackTable(
        strength=table.strength, last=table.last, area=table.area, part=table.part, friction=table.friction,
        hot=table.hot, volume=constants.volume, weight=constants.weight, slack_i=constants.slack_i,
        slack_j=constants.slack_j, in_start=adjacency.in_start, out_start=adjacency.out_start,
        out_bond=adjacency.out_bond, yielding=slip is not None,
        cohesion=np.full(n, 0.0 if slip is None else slip.cohesion * math.cos(angle)), sine=math.sin(angle),
        dilation=0.0 if slip is None else math.sin(slip.dilatancy), fade=table.fade, G=constants.G,
        base_i=bare if slip is None else cells.lever_i.copy(), base_j=bare if slip is None else cells.lever_j.copy(),
        pressed=_pressed(model), base_grip=grips.lever.copy(), now=np.array([0.0, -1.0]), integrity=state.integrity,
        listed=np.zeros(m, dtype=np.uint8), onset=np.zeros(m, dtype=np.uint8), row=row,
        sizes=np.array([count, 0, 0], dtype=np.int64), geometry=np.zeros((m, GEOMETRY_COLUMNS)),
        cell=np.zeros(n, dtype=np.int64), head=np.full(n, -1, dtype=np.int64),
        after_i=np.full(m, -1, dtype=np.int64), after_j=np.full(m, -1, dtype=np.int64), base=np.zeros(n),
        force=cells.force, pull=pull, load=np.zeros((n, 6)), tensor=np.zeros((n, 6)),
        hotter=np.zeros(n, dtype=np.uint8), plastic=state.plastic, log=np.empty((m, BROKEN_COLUMNS)),
        released=state.released,
    )  # fmt: skip


def _pressed(model: Model) -> Floats:
    """b⊗F of each load on free facets, xx, yy, zz, xy, xz, yz, in the order of the kernels' loads [J], (l, n, 6)."""
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


def take_up(bonds: Bonds, cells: CellTable, grips: GripTable, cracks: CrackTable) -> None:
    """Go on with cracks and plastic strains as a run begins: lists, weights and levers."""
    link_cracks(bonds, cells, cracks)
    stretch_body(bonds, cells, grips, cracks)


def keep_cracks(cracks: CrackTable, state: State) -> None:
    """Write what has cracked and broken since the last call into the state."""
    count, logged = int(cracks.sizes[0]), int(cracks.sizes[2])
    state.cracks = cracks.row[:count].copy()
    state.facet_force[:] = cracks.force[:, : state.facet_force.shape[1]]
    one_by_one = np.flatnonzero(state.cracks[:, STATUS] == ACTIVE)
    state.facet_force[:, state.cracks[one_by_one, FACET].astype(np.int64)] = cracks.pull[one_by_one].T
    if logged:
        state.broken = np.concatenate([state.broken, cracks.log[:logged]])
        cracks.sizes[2] = 0
