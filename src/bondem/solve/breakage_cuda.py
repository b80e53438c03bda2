"""Bonds and facets that break on a CUDA device: what a step launches for it, and what comes back.

Bytes on the device, in double precision: 128 a bond more than without (coefficients 32, where moments count and where
the contact point is 16, bound 4, list 4, and 72 of the log, as each breaks once), 1 an element. A facet takes 129
(instead of the 16, 16 of what cells weigh by without it, and a mark), a cell 9.
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
from bondem.solve.forces_cuda import BeamForces, DeviceRun, FacetForces


def device_breaks(
    table: FailureTable, model: Model, state: State, limit: PerBond | None = None
) -> DeviceBreaks:
    """When bonds break, on the device.

    Args:
        table: of the criterion.
        model: of beams or cells.
        state: what it has released.
        limit: of the bound of each bond, where that of the criterion is not asked of some, (m,).
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
    """What a step of a run with bonds or facets that break does beside their forces."""

    def mark(self, stream: Any = 0) -> None:
        """Before the forces of a step: mark what is to be judged."""
        ...

    def move(self, tick: int, *, go_on: bool, stream: Any = 0) -> None:
        """Judge, close the step, break what breaks, and open the next step if it is to go on."""
        ...

    def sums(self, parts: Array) -> None:
        """The energy released, into `parts`."""
        ...

    def keep(self, state: State) -> None:
        """Write what has broken since the last call into the state."""
        ...


class BeamBreakage:
    """Of bonds that are beams."""

    def __init__(
        self, table: FailureTable, model: Model, state: State, run: DeviceRun, bodies: DeviceBodies,
        forces: BeamForces,
    ) -> None:  # fmt: skip
        self._run, self._bodies, self._forces = run, bodies, forces
        self._breaks = device_breaks(table, model, state)

    def mark(self, stream: Any = 0) -> None:
        """Nothing: their bound is held against the forces of this step."""

    def move(self, tick: int, *, go_on: bool, stream: Any = 0) -> None:
        """Four launches in place of one."""
        run, bonds = self._run, self._forces.bonds
        launch(judge_bonds, bonds.m, run.elements, bonds, self._breaks, stream=stream)
        _move_or_wait(run, bonds.forces, self._bodies, self._breaks, tick, go_on, stream)
        launch(break_bonds, 1, run.clock, run.scheme, run.elements, bonds, self._breaks, stream=stream)
        _let_go(run, bonds.forces, self._bodies, self._breaks, go_on, stream)

    def sums(self, parts: Array) -> None:
        """The energy released, into `parts`."""
        launch(released_sum, 1, self._breaks, parts)

    def keep(self, state: State) -> None:
        """Write what has broken since the last call into the state."""
        _keep(self._breaks, self._forces.integrity, state)


class FacetBreakage:
    """Of the facets of a body of cells."""

    def __init__(
        self, table: FailureTable, model: Model, state: State, run: DeviceRun, bodies: DeviceBodies,
        forces: FacetForces,
    ) -> None:  # fmt: skip
        assert model.cells is not None
        self._run, self._bodies, self._forces = run, bodies, forces
        self._breaks = device_breaks(table, model, state)
        self._marked = upload(np.zeros(len(state.integrity), dtype=np.uint8))
        cells = model.cells
        self._whole = WholeCells._make(map(upload, (cells.weight, cells.slack_i, cells.slack_j)))
        self._weigh(True, 0)

    def _weigh(self, every: bool, stream: Any) -> None:
        """As a run begins by the kernel that weighs them anew where a facet breaks, to the bit."""
        launch(
            weigh_cells, self._breaks.held.size, self._forces.facets, self._run.adjacency, self._whole, self._breaks,
            every, stream=stream,
        )  # fmt: skip

    def mark(self, stream: Any = 0) -> None:
        """A thread a facet."""
        facets = self._forces.facets
        launch(mark_facets, facets.m, self._run.elements.pose, facets, self._breaks, self._marked, stream=stream)

    def move(self, tick: int, *, go_on: bool, stream: Any = 0) -> None:
        """Nine launches in place of one."""
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
        """The energy released, into `parts`."""
        launch(released_sum, 1, self._breaks, parts)

    def keep(self, state: State) -> None:
        """Write what has broken since the last call into the state."""
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
