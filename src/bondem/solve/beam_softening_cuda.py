"""Softening beams on a CUDA device: their tables, and the launches of a step.

They take 108 more bytes per bond on the device, in double precision, than beams that break: state of softening 48,
forces 40, fracture energies 16, number 4.
"""

from typing import Any

import numpy as np

from bondem._compile_cuda import Array, download, launch, upload, zeros
from bondem.kernels.cuda import beam_softening as kernels
from bondem.kernels.cuda.breaking import LOGGED, released_sum
from bondem.kernels.soft_tables import BEGUN, SOFT_BOND, SoftBonds
from bondem.model.failure_table import FailureTable
from bondem.model.model import Model
from bondem.model.state import State
from bondem.solve.breakage import soft_bonds
from bondem.solve.breakage_cuda import device_breaks
from bondem.solve.forces_cuda import BeamForces, DeviceRun

# Parts in which what beams dissipate in a step is added up: a number of its own, so that no bit depends on a device.
_PARTS = 256


class SoftBeamForces:
    """Forces of bonds that are beams and soften."""

    def __init__(self, table: FailureTable, model: Model, state: State, run: DeviceRun) -> None:
        self._run, self._beams = run, BeamForces(model, state, run)
        self.m, self.forces, self.integrity = self._beams.m, self._beams.forces, self._beams.integrity
        limit = table.limit.copy()
        limit[state.softened[:, SOFT_BOND].astype(np.int64)] = np.inf  # their criterion is not asked again
        self._breaks = device_breaks(table, model, state, limit)
        self._soft, self._lost = _soft(model, state), zeros(_PARTS)

    def act(self, ahead: int, stream: Any = 0) -> None:
        """Compute integrities, then forces; then mark beams that begin to soften."""
        run, bonds, breaks, table, lost = self._run, self._beams.bonds, self._breaks, self._soft, self._lost
        pose = run.elements.pose
        launch(kernels.soften_beams, self.m, pose, bonds, breaks, table, ahead > 0, stream=stream)
        if ahead > 0:
            launch(kernels.add_soft_losses, _PARTS, table, lost, stream=stream)
            launch(kernels.log_soft, 1, run.clock, run.scheme, pose, bonds, breaks, table, lost, stream=stream)
        self._beams.act(ahead, stream)
        launch(kernels.press_some, self.m, bonds, table, stream=stream)
        if ahead > 0:
            launch(kernels.find_soft, self.m, pose, bonds, breaks, stream=stream)
            launch(kernels.order_soft, 1, breaks, table, stream=stream)
            launch(kernels.begin_soft, self.m, pose, bonds, breaks, table, stream=stream)

    def take_up(self) -> None:
        """Do nothing: a record needs poses and integrities only."""

    def guard(self, flags: Array) -> None:
        """Count by one thread per bond."""
        self._beams.guard(flags)

    def sums(self, parts: Array) -> None:
        """Add the energies of bonds and of the compression of softening ones, and the dissipated energy."""
        self._beams.sums(parts)
        launch(kernels.soft_sums, parts.shape[1], self._run.elements.pose, self._beams.bonds, self._soft, parts)
        launch(released_sum, 1, self._breaks, parts)

    def keep(self, state: State) -> None:
        """Write bonds that have softened and broken since the last call into the state."""
        table: Any = self._soft
        counts = self._breaks.counts.copy_to_host()
        logged, begun = int(counts[LOGGED]), int(table.sizes.copy_to_host()[BEGUN])
        state.softened = np.array(table.row.copy_to_host()[:begun])
        download(self.integrity, state.integrity)
        download(self._breaks.released, state.released)
        if logged:
            state.broken = np.concatenate([state.broken, self._breaks.log[:logged].copy_to_host()])
            counts[LOGGED] = 0
            self._breaks.counts.copy_to_device(counts)


def _soft(model: Model, state: State) -> SoftBonds:
    """Return the CPU's table on the device; its list of active rows holds the bonds that begin to soften."""
    table = soft_bonds(model, state, np.zeros((0, 6)))
    assert table is not None
    small: dict[str, Any] = {"active": table.active.astype(np.int32), "sizes": table.sizes.astype(np.int32)}
    arrays = {
        name: upload(small.get(name, getattr(table, name))) for name in SoftBonds._fields if name != "handed"
    }  # fmt: skip
    return SoftBonds(handed=False, **arrays)
