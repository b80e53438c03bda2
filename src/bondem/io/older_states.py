"""Conversion of states of older run files."""

import numpy as np

from bondem.damage.crack_columns import FACET, ONSET, RESTING, STATUS, TOP
from bondem.damage.event_columns import BROKEN_PLACE
from bondem.model.model import Model
from bondem.model.state import State

# Schema from which on cracks are judged by the strength of their facet, and places count from the local origin; and
# from which on failures and what softens know the step of their onset, and contacts the faces by which cells touch.
_BY_FACET, _WITH_ONSET = 8, 10
#: Arrays with the number of their last columns that are new in the second, and what these are in older files.
_OF_ONSET = {"broken": (1, np.nan), "cracks": (1, np.nan), "softened": (1, np.nan), "stretch": (3, 0.0)}


def shape_in(schema: int, name: str, shape: tuple[int, ...]) -> tuple[int, ...]:
    """Return the shape of an array of a state in files of a schema, given that of today."""
    return (shape[0], shape[1] - _OF_ONSET[name][0]) if schema < _WITH_ONSET and name in _OF_ONSET else shape


def brought_up(model: Model, state: State, schema: int) -> None:
    """Convert a state of an older schema to the current one, in place."""
    if schema < _WITH_ONSET:
        fresh = State(model)
        for name, (_, value) in _OF_ONSET.items():
            rows = getattr(state, name)
            missing = getattr(fresh, name).shape[1] - rows.shape[1]
            setattr(state, name, np.pad(rows, ((0, 0), (0, missing)), constant_values=value))
    if schema >= _BY_FACET:
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
