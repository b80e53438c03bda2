"""Tables of the kernels for bonds that break, and their transfer back to the state."""

import numpy as np

from bondem._types import Floats
from bondem.kernels.soft_tables import BEGUN, SOFT_OUTPUT_COLUMNS, SoftBonds
from bondem.kernels.tables import Breaks
from bondem.model.blocks import Blocks
from bondem.model.bond_table import GROUP
from bondem.model.event_columns import BROKEN_COLUMNS, SOFT_BOND, SOFT_COLUMNS
from bondem.model.model import Model
from bondem.model.state import State


def breaking(model: Model, state: State, blocks: Blocks) -> Breaks | None:
    """Return the kernels' table for breaking the bonds or facets of a state, or None if none can break.

    Args:
        model: model with a criterion, or without.
        state: state with the bonds that are already broken.
        blocks: blocks of the step; postponed elements have rows behind those of its sums.
    """
    table, cells = model.breaking, model.cells
    if table is None:
        return None
    n, m = len(state.pose), len(state.integrity)
    # facets, and bonds of the non-local law, are judged before all elements move, domain by domain
    whole = cells is None and model.non_local is None
    begin = blocks.bond[:-1] if whole else blocks.bond[blocks.domain[:-1]]
    weights = (np.zeros(0),) * 3 if cells is None else (cells.weight, cells.slack_i, cells.slack_j)
    adjacency = model.layout.adjacency
    limit = np.full(max(m, GROUP), np.inf, dtype=np.float32)
    limit[:m] = table.limit
    limit[state.softened[:, SOFT_BOND].astype(np.int64)] = np.inf
    return Breaks(
        kind=table.kind, coefficient=table.coefficient, station=table.station,
        softens=model.beam_softening is not None, onset=np.zeros((m if model.beam_softening is not None else 0, 3)),
        limit=limit,
        of_force=table.of_force, of_moment=table.of_moment, now=np.array([0.0, -1.0]),
        marked=np.empty(m, dtype=np.int64), begin=begin.astype(np.int64), found=np.zeros(len(begin), dtype=np.int64),
        held=np.zeros(n, dtype=np.uint8),
        turn=np.empty(n, dtype=np.uint32), turn_row=np.empty(n, dtype=np.uint32), first_row=blocks.rows,
        # memory is taken as bonds break
        log=np.empty((m, BROKEN_COLUMNS)), logged=np.zeros(1, dtype=np.int64), released=state.released,
        weight=weights[0], slack_i=weights[1], slack_j=weights[2],
        in_start=adjacency.in_start, out_start=adjacency.out_start, out_bond=adjacency.out_bond,
    )  # fmt: skip


def keep_broken(breaks: Breaks, integrity: np.ndarray, state: State) -> None:
    """Write bonds that have broken since the last call into the state."""
    count = int(breaks.logged[0])
    if count:
        state.broken = np.concatenate([state.broken, breaks.log[:count]])
        breaks.logged[0] = 0
        state.integrity[:] = integrity[: len(state.integrity)]


def soft_bonds(model: Model, state: State, load: Floats) -> SoftBonds | None:
    """Return the kernels' table for softening the beams of a state, or None if none can soften.

    Args:
        model: model with a criterion, or without.
        state: state with the beams that have begun to soften.
        load: force and torque of contacts and other sources on each element [N, N·m], (n, 6).
    """
    table = model.beam_softening
    if table is None:
        return None
    m, begun = len(state.integrity), len(state.softened)
    row = np.zeros((m, SOFT_COLUMNS))
    row[:begun] = state.softened
    return SoftBonds(
        tear=table.tear, shear=table.shear, handed=model.hands_over, row=row, sizes=np.array([begun, 0]),
        active=np.zeros(m, dtype=np.int64), output=np.zeros((m, SOFT_OUTPUT_COLUMNS)), load=load,
    )  # fmt: skip


def keep_softened(soft: SoftBonds, integrity: np.ndarray, state: State) -> None:
    """Write beams that have softened into the state."""
    state.softened = soft.row[: soft.sizes[BEGUN]].copy()
    state.integrity[:] = integrity[: len(state.integrity)]
