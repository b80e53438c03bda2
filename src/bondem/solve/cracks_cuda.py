"""Cracking facets of cells on a CUDA device: their tables, and the launches of a step.

Additional bytes on the device, in double precision:

    a facet   667: state of its crack 104, geometry 152, planes 17, both halves 128, loads 64, its force 24, log 72,
              integrity 8, kind of treatment 2, strength, softening, friction and weights 72, numbers and lists 24
    a cell    135: V σ, bending and stress 104, volume, weight and V θ 24, start of its cracks and marks 7

Where cells yield, there are 24 more per facet (levers without plastic strain), 176 per cell (17 variables, 5
constants) and 24 per facet that walls hold.
"""

from typing import Any

import numpy as np

from bondem._compile_cuda import Array, download, launch, refused, upload, zeros
from bondem.errors import InputError
from bondem.kernels.crack_tables import (
    CRACK_COLUMNS,
    CRACKS,
    FACET,
    GEOMETRY_COLUMNS,
    HALF_COLUMNS,
    LOGGED,
    OUTPUT_COLUMNS,
    STATUS,
    CellYield,
    CrackedFacets,
    CrackTable,
)
from bondem.kernels.cuda import crack_beginnings as beginnings
from bondem.kernels.cuda import cracks as states
from bondem.kernels.cuda.breaking import released_sum
from bondem.kernels.cuda.facets import facet_loads, swell
from bondem.kernels.cuda.guards import turn_guard
from bondem.kernels.cuda.stress_judging import Judging, judging
from bondem.kernels.cuda.tables import DeviceBody, DeviceLists, DeviceOnset
from bondem.kernels.cuda.yielding import follow_cells, heat_sums, stretch_all, stretch_holds, yield_some
from bondem.kernels.tables import BROKEN_COLUMNS, GripTable
from bondem.model.model import Model
from bondem.model.state import State
from bondem.solve.cracks import crack_table, with_forces
from bondem.solve.forces_cuda import DeviceFacetForces, DeviceRun, starts

# Parts in which what cracks dissipate in a step is added up: a number of its own, so that no bit depends on a device.
_PARTS = 256


class CrackForces:
    """Forces of the facets of a body of cells that crack."""

    def __init__(self, model: Model, state: State, run: DeviceRun, dt: float) -> None:
        self._run = run
        self._whole = DeviceFacetForces(model, state, run)
        facets, self.m = self._whole.facets, self._whole.m
        self.forces, self.integrity = facets.forces, facets.integrity
        forces = np.zeros((9, self.m))
        forces[:3] = -state.facet_force
        facets.forces.copy_to_device(forces)
        n = len(state.pose)
        assert model.cells is not None
        constants = model.cells.stretched(state.eigenstrain, model.layout)
        cells = with_forces(constants.rows(model.layout.i), model, state, 0)
        grips = constants.grips.table(model.layout, model.constraints.row_of, 0, state.grips)
        table = crack_table(model, state, cells, grips, np.zeros((0, 6)), dt)
        assert table is not None
        assert cells.bends is not None
        self._body = DeviceBody(
            *facets, *run.adjacency, bends=upload(cells.bends[: self.m]), moment=zeros(n, 7)
        )  # fmt: skip
        self._onset, self._lists = _onset(model, table), _lists(table)
        self._cracks, self._judging = _cracks(table.facets), judging_of(model)
        self._flow = _flow(table, grips) if table.flow.yielding else None
        if self._flow is not None:
            launch(stretch_all, n, self._body, self._flow)
            launch(stretch_holds, len(grips.row), len(grips.row), self._whole.grips, self._flow)
        launch(states.weigh_all_cracked, n, self._body, self._cracks)

    def act(self, ahead: int, stream: Any = 0) -> None:
        """Compute the forces: facets begin to crack at the present step, and cracks change."""
        run, whole, body, cracks, lists = self._run, self._whole, self._body, self._cracks, self._lists
        pose, n, m = run.elements.pose, run.elements.pose.shape[0], self.m
        if ahead > 0:
            self._begin(stream)
        launch(swell, m, run.elements, whole.facets, stream=stream)
        launch(
            states.begin_stresses, n, run.clock, ahead, run.scheme, pose, body.weight, body.forces, run.adjacency,
            run.rows, run.schedules, whole.grips, whole.holds, stream=stream,
        )  # fmt: skip
        launch(states.link_cells, n, pose, body, cracks, lists, self._onset.cracked, stream=stream)
        launch(states.measure_some, m, pose, body, cracks, stream=stream)
        launch(states.relax_some, n, pose, body, cracks, stream=stream)
        if ahead > 0:
            self._change(stream)
        launch(states.end_stresses, n, pose, run.rows, whole.grips, whole.holds, stream=stream)
        launch(facet_loads, m, run.elements, whole.facets, stream=stream)
        launch(states.load_cracks, m, pose, body, cracks, lists, ahead > 0, stream=stream)
        if ahead > 0:
            launch(states.add_losses, _PARTS, cracks, lists, stream=stream)
            launch(states.log_cracks, 1, pose, body, cracks, lists, stream=stream)
        launch(beginnings.sum_moments, n, run.elements, body, cracks, ahead > 0, stream=stream)

    def _begin(self, stream: Any) -> None:
        """Initiate cracks at the beginning of a step, by the stresses of the step before."""
        run, body, cracks, onset, lists = self._run, self._body, self._cracks, self._onset, self._lists
        pose, n = run.elements.pose, run.elements.pose.shape[0]
        self._find_stresses(1, stream)
        if self._flow is not None:
            self._yield(self._flow, stream)
        mark, begin = beginnings.mark_cracks, beginnings.begin_cracks
        if self._judging is not None:
            mark, begin = self._judging.mark, self._judging.begin
            launch(self._judging.cool, n, cracks.tensor, body.moment, onset, stream=stream)
        launch(mark, self.m, pose, body, cracks, onset, lists, stream=stream)
        launch(beginnings.order_beginnings, 1, run.clock, run.scheme, cracks, lists, stream=stream)
        launch(begin, self.m, pose, body, cracks, onset, lists, stream=stream)

    def _find_stresses(self, ahead: int, stream: Any = None) -> None:
        """Compute stresses of all cells, with walls and tractions now or in the step `ahead`."""
        run, body, cracks, onset, whole = self._run, self._body, self._cracks, self._onset, self._whole
        pose, n = run.elements.pose, run.elements.pose.shape[0]
        launch(beginnings.stress_tensors, n, pose, body, cracks, onset.volume, stream=stream)
        launch(
            beginnings.heat_cells, n, run.clock, ahead, run.scheme, pose, cracks.tensor, body.moment, run.rows,
            run.schedules, whole.grips, whole.holds, onset, stream=stream,
        )  # fmt: skip

    def _yield(self, flow: CellYield, stream: Any) -> None:
        """Let cells yield, and update their surfaces."""
        run, onset, n = self._run, self._onset, self._run.elements.pose.shape[0]
        launch(yield_some, n, run.elements.pose, self._body, self._cracks.tensor, onset, flow, stream=stream)
        launch(
            follow_cells, n, run.clock, run.scheme, run.rows.of, run.rows.work, run.schedules, self._whole.grips,
            self._whole.holds.grip_start, onset, flow, stream=stream,
        )  # fmt: skip

    def _change(self, stream: Any) -> None:
        """Activate, soften, separate and deactivate cracks, and update their cells."""
        body, cracks, lists = self._body, self._cracks, self._lists
        pose, n, m = self._run.elements.pose, self._run.elements.pose.shape[0], self.m
        launch(states.wake_some, m, pose, body, cracks, stream=stream)
        launch(states.wake_cells, n, pose, body, cracks, lists, self._onset.cracked, stream=stream)
        launch(states.soften_some, m, pose, body, cracks, lists, stream=stream)
        launch(states.part_cracks, 1, pose, body, cracks, lists, stream=stream)
        launch(states.calm_cracks, m, body, cracks, stream=stream)
        launch(states.change_cells, n, pose, body, cracks, stream=stream)

    def take_up(self) -> None:
        """Bring walls, tractions and cracks to the present time; stresses and forces are those of the state."""
        run, whole, body, cracks = self._run, self._whole, self._body, self._cracks
        pose, n = run.elements.pose, run.elements.pose.shape[0]
        launch(
            states.take_up_holds, n, run.clock, run.scheme, pose, run.rows, run.schedules, whole.grips, whole.holds
        )  # fmt: skip
        launch(states.link_cells, n, pose, body, cracks, self._lists, self._onset.cracked)
        launch(states.measure_some, self.m, pose, body, cracks)
        launch(beginnings.sum_moments, n, run.elements, body, cracks, False)
        if self._flow is not None:
            self._find_stresses(0)

    def guard(self, flags: Array) -> None:
        """Count by one thread per facet, with levers without plastic strain, as directions are of the reference."""
        facets, flow = self._whole.facets, self._flow
        if flow is not None:
            facets = facets._replace(lever_i=flow.base_i, lever_j=flow.base_j)
        launch(turn_guard, self.m, self._run.elements, facets, flags)

    def sums(self, parts: Array) -> None:
        """Add the energies of facets, cells and walls, of cracks, and the energy that these have dissipated."""
        self._whole.sums(parts)
        launch(states.crack_sums, parts.shape[1], self._run.elements.pose, self._body, self._cracks, parts)
        launch(released_sum, 1, self._cracks, parts)
        if self._flow is not None:
            tensor, volume = self._cracks.tensor, self._onset.volume
            launch(heat_sums, parts.shape[1], tensor, volume, self._flow.plastic, parts)

    def keep(self, state: State) -> None:
        """Write facets that have cracked and broken since the last call into the state."""
        cracks: Any = self._cracks
        sizes = cracks.sizes.copy_to_host()
        count, logged = int(sizes[CRACKS]), int(sizes[LOGGED])
        state.cracks = cracks.row[:count].copy_to_host() if count else np.zeros((0, CRACK_COLUMNS))
        state.facet_force[:] = -self.forces[:3].copy_to_host()[:, : self.m]  # the device has those on cells j
        download(cracks.integrity, state.integrity)
        download(cracks.released, state.released)
        if self._flow is not None:
            download(self._flow.plastic, state.plastic)
        if logged:
            state.broken = np.concatenate([state.broken, cracks.log[:logged].copy_to_host()])
            sizes[LOGGED] = 0
            cracks.sizes.copy_to_device(sizes)


def _cracks(table: CrackedFacets) -> CrackedFacets:
    """Return the CPU's table on the device, where every crack and every cell has its own place in the lists."""
    n, m = len(table.head), len(table.integrity)
    own = upload(np.arange(max(n, m), dtype=np.int32))
    large = {
        "geometry": zeros(m, GEOMETRY_COLUMNS), "half": zeros(2 * m, HALF_COLUMNS),
        "output": zeros(m, OUTPUT_COLUMNS), "log": zeros(m, BROKEN_COLUMNS), "load": zeros(1, 6),
        "active": own, "resting": own, "cell": own,
    }  # fmt: skip
    small = {
        "facet": table.row[:, FACET].astype(np.int32), "listed": _listed(table), "head": table.head.astype(np.int32),
        "after": table.after.astype(np.int32),
    }  # fmt: skip
    numbers = {"kink": table.kink, "steep": table.steep}
    shared = {
        name: upload(getattr(table, name))
        for name in CrackedFacets._fields
        if name not in large and name not in small and name not in numbers
    }
    moved = {name: upload(array) for name, array in small.items()}
    return CrackedFacets(**numbers, **shared, **moved, **large)


def _listed(table: CrackedFacets) -> np.ndarray:
    """Return the treatment of the facets, in the form of `kernels.crack_list.treat`."""
    count = table.sizes[CRACKS]
    listed = np.zeros(len(table.integrity), dtype=np.uint8)
    listed[table.row[:count, FACET].astype(np.int64)] = 1 + table.row[:count, STATUS].astype(np.uint8)
    return listed


def _lists(table: CrackTable) -> DeviceLists:
    facets = table.facets
    m, count = len(facets.integrity), facets.sizes[CRACKS]
    crack = np.full(m, -1, dtype=np.int32)
    crack[facets.row[:count, FACET].astype(np.int64)] = np.arange(count, dtype=np.int32)
    arrays = np.zeros(m, dtype=np.int32), np.zeros(2, dtype=np.int32), crack
    return DeviceLists._make([*map(upload, arrays), zeros(_PARTS)])


def _onset(model: Model, table: CrackTable) -> DeviceOnset:
    held, onset, n = model.constraints, table.onset, len(table.stress.volume)
    pressed = table.flow.pressed[:, held.element].transpose(1, 0, 2)  # (r, l, 6)
    row, load = np.nonzero(pressed.any(axis=2))
    arrays = starts(row, len(held.element)), held.press_schedule[load], pressed[row, load]
    return DeviceOnset(
        upload(onset.strength), onset.hot, onset.least, onset.tension, upload(table.stress.volume),
        *map(upload, arrays),
        cracked=upload(onset.cracked), hotter=upload(np.zeros(n, dtype=np.uint8)),
    )  # fmt: skip


def _flow(table: CrackTable, grips: GripTable) -> CellYield:
    """Return the CPU's table on the device, with the walls in the order of the rows."""
    flow, order = table.flow, np.argsort(grips.row, kind="stable")
    arrays = {
        name: upload(getattr(flow, name))
        for name in ("cohesion", "sine", "dilation", "fade", "G", "plastic")
    }  # fmt: skip
    m = len(table.facets.integrity)
    return CellYield(
        yielding=True, cone=flow.cone, base_i=upload(flow.base_i[:, :m]), base_j=upload(flow.base_j[:, :m]),
        base_grip=upload(flow.base_grip[order]), pressed=zeros(1, 1, 6), **arrays,
    )  # fmt: skip


def judging_of(model: Model) -> Judging | None:
    """Return the kernels of a criterion that is a function of the stress.

    Raises:
        InputError: CUDA does not compile the function.
    """
    table = model.softening
    if table is None or table.judge is None:
        return None
    function, given = table.judge.function, tuple(table.given.tolist())
    reason = refused(function, len(given))
    if reason is not None:
        raise InputError(
            f"device='gpu' cannot compile the function of the criterion for CUDA ({reason}): use numbers and math in"
            " it, no functions of NumPy, or device='cpu'"
        )
    return judging(function, given)
