"""Breaking bonds and facets on a CUDA device: the launches of a step, and the transfer back.

Breakage takes 128 more bytes per bond on the device, in double precision, and 1 per element. These are coefficients
32, station and contact point 16, bound 4, list 4, and log 72, because each bond breaks once. A facet takes 129
(instead of the 16, the weights of cells without it 16, and a mark), a cell 9.
"""

from typing import Any, Protocol

import numpy as np

from bondem._compile_cuda import Array, download, launch, upload, zeros
from bondem._types import PerBond
from bondem.kernels.cuda.breaking import LOGGED, break_bonds, judge_bonds, let_go, move_or_wait, released_sum
from bondem.kernels.cuda.facet_breaking import (
    break_facets,
    hold_neighbours,
    judge_facets,
    load_again,
    mark_facets,
    stress_again,
    swell_again,
    weigh_cells,
)
from bondem.kernels.cuda.tables import DeviceBodies, DeviceBreaks, WholeCells
from bondem.kernels.tables import BROKEN_COLUMNS
from bondem.model.failure_table import FailureTable
from bondem.model.model import Model
from bondem.model.state import State
from bondem.solve.forces_cuda import BeamForces, DeviceFacetForces, DeviceRun


def device_breaks(
    table: FailureTable, model: Model, state: State, limit: PerBond | None = None
) -> DeviceBreaks:
    """Return the table of breakage on the device.

    Args:
        table: table of the criterion.
        model: model of beams or cells.
        state: state with the released energy.
        limit: bound of each bond, if it differs from that of the criterion, (m,).
    """
    n, m = len(state.pose), len(state.integrity)
    station = share = np.zeros(0)
    if model.cells is None:
        bonds = model.bonds.stretched(state.eigenstrain)
        station, share = table.station, bonds.lever / bonds.length
    arrays = share, np.zeros(n, dtype=np.uint8), np.zeros(m, dtype=np.int32), np.zeros(3, dtype=np.int32)
    bound = (table.limit if limit is None else limit).astype(np.float32)
    judging = (
        table.kind, upload(table.coefficient), upload(station), upload(bound), table.of_force, table.of_moment,
    )  # fmt: skip
    return DeviceBreaks._make(
        [*judging, *map(upload, arrays), zeros(m, BROKEN_COLUMNS), upload(state.released)]
    )  # fmt: skip


class DeviceBreakage(Protocol):
    """Breakage of bonds or facets within the steps of a run."""

    def mark(self, stream: Any = 0) -> None:
        """Mark bonds to evaluate, before the forces of a step."""
        ...

    def move(self, tick: int, *, go_on: bool, stream: Any = 0) -> None:
        """Evaluate bonds, close the step, break bonds, and open the next step if the run continues."""
        ...

    def sums(self, parts: Array) -> None:
        """Write the energy released into `parts`."""
        ...

    def keep(self, state: State) -> None:
        """Write bonds that have broken since the last call into the state."""
        ...


class BeamBreakage:
    """Breakage of bonds that are beams."""

    def __init__(
        self, table: FailureTable, model: Model, state: State, run: DeviceRun, bodies: DeviceBodies,
        forces: BeamForces,
    ) -> None:  # fmt: skip
        self._run, self._bodies, self._forces = run, bodies, forces
        self._breaks = device_breaks(table, model, state)

    def mark(self, stream: Any = 0) -> None:
        """Do nothing: their bound is compared with the forces of this step."""

    def move(self, tick: int, *, go_on: bool, stream: Any = 0) -> None:
        """Do the same as `DeviceBreakage.move` by four launches in place of one."""
        run, bonds = self._run, self._forces.bonds
        launch(judge_bonds, bonds.m, run.elements, bonds, self._breaks, stream=stream)
        _move_or_wait(run, bonds.forces, self._bodies, self._breaks, tick, go_on, stream)
        launch(break_bonds, 1, run.clock, run.scheme, run.elements, bonds, self._breaks, stream=stream)
        _let_go(run, bonds.forces, self._bodies, self._breaks, go_on, stream)

    def sums(self, parts: Array) -> None:
        """Write the energy released into `parts`."""
        launch(released_sum, 1, self._breaks, parts)

    def keep(self, state: State) -> None:
        """Write bonds that have broken since the last call into the state."""
        _keep(self._breaks, self._forces.integrity, state)


class FacetBreakage:
    """Breakage of the facets of a body of cells."""

    def __init__(
        self, table: FailureTable, model: Model, state: State, run: DeviceRun, bodies: DeviceBodies,
        forces: DeviceFacetForces,
    ) -> None:  # fmt: skip
        assert model.cells is not None
        self._run, self._bodies, self._forces = run, bodies, forces
        self._breaks = device_breaks(table, model, state)
        self._marked = upload(np.zeros(len(state.integrity), dtype=np.uint8))
        cells = model.cells
        self._whole = WholeCells._make(map(upload, (cells.weight, cells.slack_i, cells.slack_j)))
        self._weigh(True, 0)

    def _weigh(self, every: bool, stream: Any) -> None:
        """Compute the initial weights of cells by the kernel that renews them at breakages, to the same bit."""
        launch(
            weigh_cells, self._breaks.held.size, self._forces.facets, self._run.adjacency, self._whole, self._breaks,
            every, stream=stream,
        )  # fmt: skip

    def mark(self, stream: Any = 0) -> None:
        """Mark facets by one thread each."""
        facets = self._forces.facets
        launch(mark_facets, facets.m, self._run.elements.pose, facets, self._breaks, self._marked, stream=stream)

    def move(self, tick: int, *, go_on: bool, stream: Any = 0) -> None:
        """Do the same as `DeviceBreakage.move` by nine launches in place of one."""
        run, breaks, facets = self._run, self._breaks, self._forces.facets
        pose, n, m = run.elements.pose, breaks.held.size, facets.m
        launch(judge_facets, m, pose, facets, breaks, self._marked, stream=stream)
        launch(hold_neighbours, n, facets, run.adjacency, breaks, stream=stream)
        _move_or_wait(run, facets.forces, self._bodies, breaks, tick, go_on, stream)
        launch(
            break_facets, 1, run.clock, run.scheme, pose, facets, run.adjacency, self._whole, breaks, stream=stream
        )  # fmt: skip
        self._weigh(False, stream)
        launch(swell_again, m, pose, facets, breaks, stream=stream)
        launch(
            stress_again, n, pose, facets.weight, facets.forces, run.adjacency, run.rows, self._forces.grips,
            self._forces.holds, breaks.held, breaks.counts, stream=stream,
        )  # fmt: skip
        launch(load_again, m, pose, facets, breaks, stream=stream)
        _let_go(run, facets.forces, self._bodies, breaks, go_on, stream)

    def sums(self, parts: Array) -> None:
        """Write the energy released into `parts`."""
        launch(released_sum, 1, self._breaks, parts)

    def keep(self, state: State) -> None:
        """Write facets that have broken since the last call into the state."""
        _keep(self._breaks, self._forces.integrity, state)


def _move_or_wait(
    run: DeviceRun, forces: Array, bodies: DeviceBodies, breaks: DeviceBreaks, tick: int, go_on: bool, stream: Any
) -> None:
    launch(
        move_or_wait, breaks.held.size, run.clock, tick, run.elements, run.adjacency, forces, run.rows, bodies,
        run.scheme, breaks, go_on, stream=stream,
    )  # fmt: skip


def _let_go(
    run: DeviceRun, forces: Array, bodies: DeviceBodies, breaks: DeviceBreaks, go_on: bool, stream: Any
) -> None:
    still = run.scheme._replace(dt=0.0, finish=0.0)
    launch(
        let_go, breaks.held.size, run.elements, run.adjacency, forces, run.rows, bodies, still, run.scheme, breaks,
        go_on, stream=stream,
    )  # fmt: skip


def _keep(breaks: DeviceBreaks, integrity: Array, state: State) -> None:
    counts = breaks.counts.copy_to_host()
    logged = int(counts[LOGGED])
    if logged:
        state.broken = np.concatenate([state.broken, breaks.log[:logged].copy_to_host()])
        counts[LOGGED] = 0
        breaks.counts.copy_to_device(counts)
        download(integrity, state.integrity)
        download(breaks.released, state.released)
