"""Bonds that break on a CUDA device: what a step launches for it, and what comes back.

Bytes on the device, in double precision: 128 a bond more than without (coefficients 32, where moments count and where
the contact point is 16, bound 4, list 4, and 72 of the log, as each breaks once), 1 an element.
"""

from typing import Any

import numpy as np

from bondem._compile_cuda import Array, download, launch, upload, zeros
from bondem.kernels.cuda.breaking import LOGGED, break_bonds, judge_bonds, let_go, move_or_wait, released_sum
from bondem.kernels.cuda.tables import DeviceBodies, DeviceBreaks
from bondem.kernels.tables import BROKEN_COLUMNS
from bondem.model.failure_table import FailureTable
from bondem.model.model import Model
from bondem.model.state import State
from bondem.solve.forces_cuda import BeamForces, DeviceRun


def device_breaks(table: FailureTable, model: Model, state: State) -> DeviceBreaks:
    """When bonds break, on the device.

    Args:
        table: of the criterion.
        model: of beams.
        state: what it has released.
    """
    n, m = len(state.pose), len(state.integrity)
    bonds = model.bonds.stretched(state.eigenstrain)
    arrays = (
        bonds.lever / bonds.length, np.zeros(n, dtype=np.uint8), np.zeros(m, dtype=np.int32),
        np.zeros(3, dtype=np.int32),
    )  # fmt: skip
    judging = (
        table.kind, upload(table.coefficient), upload(table.station), upload(table.limit.astype(np.float32)),
        table.of_force, table.of_moment,
    )  # fmt: skip
    return DeviceBreaks._make(
        [*judging, *map(upload, arrays), zeros(m, BROKEN_COLUMNS), upload(state.released)]
    )  # fmt: skip


class DeviceBreakage:
    """What a step of a run with breaking bonds does after their forces."""

    def __init__(
        self, table: FailureTable, model: Model, state: State, run: DeviceRun, bodies: DeviceBodies,
        forces: BeamForces,
    ) -> None:  # fmt: skip
        self._run, self._bodies, self._forces = run, bodies, forces
        self._breaks = device_breaks(table, model, state)
        self._count = len(state.pose)
        self._still = run.scheme._replace(dt=0.0, finish=0.0)

    def move(self, tick: int, *, go_on: bool, stream: Any = 0) -> None:
        """Judge all bonds, close the step, break what breaks, and open the next step if it is to go on."""
        clock, scheme, elements, adjacency, rows, _ = self._run
        breaks, of, count = self._breaks, self._forces.forces, self._count
        bonds = self._forces.bonds
        launch(judge_bonds, bonds.m, elements, bonds, breaks, stream=stream)
        launch(
            move_or_wait, count, clock, tick, elements, adjacency, of, rows, self._bodies, scheme, breaks, go_on,
            stream=stream,
        )  # fmt: skip
        launch(break_bonds, 1, clock, scheme, elements, bonds, breaks, stream=stream)
        launch(
            let_go, count, elements, adjacency, of, rows, self._bodies, self._still, scheme, breaks, go_on,
            stream=stream,
        )  # fmt: skip

    def sums(self, parts: Array) -> None:
        """The energy released, into `parts`."""
        launch(released_sum, 1, self._breaks, parts)

    def keep(self, state: State) -> None:
        """Write what has broken since the last call into the state."""
        counts = self._breaks.counts.copy_to_host()
        logged = int(counts[LOGGED])
        if logged:
            state.broken = np.concatenate([state.broken, self._breaks.log[:logged].copy_to_host()])
            counts[LOGGED] = 0
            self._breaks.counts.copy_to_device(counts)
            download(self._forces.integrity, state.integrity)
            download(self._breaks.released, state.released)
