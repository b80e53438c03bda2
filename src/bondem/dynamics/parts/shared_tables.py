"""Tables of a run that several parts of a step use."""

from dataclasses import dataclass

import numpy as np

from bondem._cache_lines import exact_sums
from bondem._tables.columns import HistoryColumn
from bondem._tables.step_tables import Ledger, Moving, Rows, StepBlocks, Timeline
from bondem._types import PerBond
from bondem.model.model import Model
from bondem.model.state import State


@dataclass(frozen=True, eq=False)
class SharedTables:
    """Tables of a run that begins from a state; those of elements and of the boundary refer to arrays of the state.

    Attributes:
        moving: motion of the elements.
        rows: one row per element that is fixed, driven or loaded.
        blocks: division of a step into domains and blocks, and sums of forces.
        ledger: sums of energies for a record or for a check of the energy.
        timeline: schedules of the boundary as functions of time.
        owned: True if elements are fixed, driven or loaded.
    """

    moving: Moving
    rows: Rows
    blocks: StepBlocks
    ledger: Ledger
    timeline: Timeline
    owned: bool

    @classmethod
    def of(cls, model: Model, state: State, blocks: StepBlocks) -> "SharedTables":
        """Return the tables of a run that begins from `state` and is divided into `blocks`."""
        constraints = model.constraints
        return cls(
            moving=Moving(state.pose, state.motion, state.acceleration, state.loss, state.rest),
            rows=constraints.rows(state.reaction, state.work),
            blocks=blocks,
            ledger=new_ledger(),
            timeline=constraints.timeline,
            owned=len(constraints.element) > 0,
        )


def new_ledger() -> Ledger:
    """Return a table of the energy balance with all sums zero."""
    counts = np.zeros(3, dtype=np.int64), np.zeros(4, dtype=np.int64)
    return Ledger(exact_sums(HistoryColumn.COUNT), counts[0], np.zeros(2), counts[1])


def apart(model: Model, state: State) -> PerBond:
    """Return the distance of the centres at which the elements of each bond touch once it has failed [m], (m,)."""
    return model.bonds.stretched(state.rest_strain).length.copy()
