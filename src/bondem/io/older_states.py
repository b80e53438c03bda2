"""What states of older run files mean today."""

import numpy as np

from bondem.kernels.crack_tables import FACET, ONSET, RESTING, STATUS, TOP
from bondem.kernels.tables import BROKEN_PLACE
from bondem.model.model import Model
from bondem.model.state import State

# Schema from which on cracks are judged by the strength of their facet, and places count from the local origin.
_TODAY = 8


def brought_up(model: Model, state: State, schema: int) -> None:
    """Change a state that was read from a run file of an older schema into one of today, in place."""
    if schema >= _TODAY:
        return
    judge_anew(model, state)
    if state.origin.any():  # places counted from zero
        state.pose[:, :3] -= state.origin
        state.broken[:, BROKEN_PLACE : BROKEN_PLACE + 3] -= state.origin


def judge_anew(model: Model, state: State) -> None:
    """Give cracks the strength of their facets, where they had the traction at which they began; wake all at rest."""
    if model.softening is None:
        return
    rows = state.cracks
    strength = model.softening.strength[rows[:, FACET].astype(np.int64)]
    rows[:, ONSET] = np.where(rows[:, ONSET] > 0.0, strength, 0.0)
    rows[np.isfinite(rows[:, TOP]) & (rows[:, STATUS] == RESTING), TOP] = 0.0
