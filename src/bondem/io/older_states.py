"""Conversion of states of older run files."""

import numpy as np

from bondem.damage.crack_columns import FACET, ONSET, RESTING, STATUS, TOP
from bondem.damage.event_columns import BROKEN_PLACE
from bondem.model.model import Model
from bondem.model.state import State

# Schema from which on cracks are judged by the strength of their facet, and places count from the local origin.
_TODAY = 8


def brought_up(model: Model, state: State, schema: int) -> None:
    """Convert a state of an older schema to the current one, in place."""
    if schema >= _TODAY:
        return
    judge_anew(model, state)
    if state.origin.any():  # places counted from zero
        state.pose[:, :3] -= state.origin
        state.broken[:, BROKEN_PLACE : BROKEN_PLACE + 3] -= state.origin


def judge_anew(model: Model, state: State) -> None:
    """Set the strength of softening facets that stored the traction at initiation, and reactivate resting ones."""
    if model.softening is None:
        return
    rows = state.cracks
    strength = model.softening.strength[rows[:, FACET].astype(np.int64)]
    rows[:, ONSET] = np.where(rows[:, ONSET] > 0.0, strength, 0.0)
    rows[np.isfinite(rows[:, TOP]) & (rows[:, STATUS] == RESTING), TOP] = 0.0
