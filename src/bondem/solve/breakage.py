"""Tables of the kernels for bonds that break, and what comes back from them."""

import numpy as np

from bondem.kernels.lanes import WIDTH
from bondem.kernels.tables import BROKEN_COLUMNS, Breaks
from bondem.model.failure_table import FailureTable
from bondem.model.state import State


def breaking(table: FailureTable | None, state: State, blocks: int, first_row: int) -> Breaks | None:
    """What kernels take to break the bonds of a state; None where none break.

    Args:
        table: when they do.
        state: which of them are broken already.
        blocks: of the step.
        first_row: where the rows of sums begin that elements wait in.
    """
    if table is None:
        return None
    n, m = len(state.pose), len(state.integrity)
    limit = np.full(max(m, WIDTH), np.inf, dtype=np.float32)
    limit[:m] = table.limit
    return Breaks(
        kind=table.kind, coefficient=table.coefficient, station=table.station, limit=limit,
        of_force=table.of_force, of_moment=table.of_moment, now=np.array([0.0, -1.0]),
        marked=np.empty(m, dtype=np.int64), count=np.zeros(blocks, dtype=np.int64), held=np.zeros(n, dtype=np.uint8),
        turn=np.empty(n, dtype=np.uint32), turn_row=np.empty(n, dtype=np.uint32), first_row=first_row,
        # memory is taken as bonds break
        log=np.empty((m, BROKEN_COLUMNS)), logged=np.zeros(1, dtype=np.int64), released=state.released,
    )  # fmt: skip


def keep_broken(breaks: Breaks, integrity: np.ndarray, state: State) -> None:
    """Write what has broken since the last call into the state."""
    count = int(breaks.logged[0])
    if count:
        state.broken = np.concatenate([state.broken, breaks.log[:count]])
        breaks.logged[0] = 0
        state.integrity[:] = integrity[: len(state.integrity)]
