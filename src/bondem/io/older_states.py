"""Conversion of states of older run files."""

import numpy as np

from bondem._tables.columns import CrackKind, CrackStatus, EventColumn
from bondem._types import Floats
from bondem.boundary.wall_rows import walls_at_rest
from bondem.damage.crack_columns import CRACK_COLUMNS, FACET, KIND, ONSET, RATE, RUB, SLIP, SPENT, STATUS, TOP
from bondem.damage.crack_rows import axes_along, crack_rows, isotropic_left
from bondem.model.model import Model
from bondem.model.state import State

# Schema from which on cracks are judged by the strength of their facet, and places count from the local origin; and
# from which on failures and what softens know the step of their onset, contacts the faces by which cells touch, and
# cracks their directions.
_BY_FACET, _WITH_ONSET = 8, 10
# Schema from which on walls have an orientation, and their columns before.
_TURNING, _UNTURNED = 11, 14
#: Arrays with the number of their last columns that are new in the second, and what these are in older files.
_OF_ONSET = {"broken": (1, np.nan), "softened": (1, np.nan), "stretch": (3, 0.0)}
# Columns of a crack before: facet, strength, slip, rate, status, integrity a step ago, friction force, energy, top.
_OLDER = 13


def shape_in(schema: int, name: str, shape: tuple[int, ...]) -> tuple[int, ...]:
    """Return the shape of an array of a state in files of a schema, given that of today."""
    if name == "walls" and schema < _TURNING:
        return shape[0], _UNTURNED
    if schema >= _WITH_ONSET:
        return shape
    if name == "cracks":
        return shape[0], _OLDER
    return (shape[0], shape[1] - _OF_ONSET[name][0]) if name in _OF_ONSET else shape


def brought_up(model: Model, state: State, schema: int) -> None:
    """Convert a state of an older schema to the current one, in place."""
    if schema < _TURNING:
        state.walls = np.hstack([state.walls, walls_at_rest(len(state.walls))[:, _UNTURNED:]])
    if schema < _WITH_ONSET:
        fresh = State(model)
        for name, (_, value) in _OF_ONSET.items():
            rows = getattr(state, name)
            missing = getattr(fresh, name).shape[1] - rows.shape[1]
            setattr(state, name, np.pad(rows, ((0, 0), (0, missing)), constant_values=value))
        state.cracks = with_directions(model, state)
    if schema >= _BY_FACET:
        return
    judge_anew(model, state)
    if state.origin.any():  # places counted from zero
        state.pose[:, :3] -= state.origin
        state.broken[:, EventColumn.PLACE : EventColumn.PLACE + 3] -= state.origin


def with_directions(model: Model, state: State) -> Floats:
    """Return cracks of files whose facets had one integrity, which becomes that of all directions."""
    older = state.cracks
    if not len(older):
        return np.zeros((0, CRACK_COLUMNS))
    facet = older[:, 0].astype(np.int64)
    table = model.softening
    isotropic = older[:, 1] == 0.0 if table is None else (older[:, 1] == 0.0) | table.plane[facet]
    axes = axes_along(model.cell_law.constants.normal[facet])
    rows = crack_rows(facet, older[:, 1], axes, isotropic_left(state.integrity[facet]), isotropic)
    rows[:, SLIP : SLIP + 3], rows[:, RUB : RUB + 3] = older[:, 2:5], older[:, 8:11]
    for column, of_row in ((RATE, 5), (STATUS, 6), (SPENT, 11), (TOP, 12)):
        rows[:, column] = older[:, of_row]
    # cracks of the material that are not gone are treated one by one
    softens = rows[:, KIND] == CrackKind.OF_MATERIAL
    rows[softens & (rows[:, STATUS] == CrackStatus.RESTING), STATUS] = CrackStatus.ACTIVE
    rows[softens, SLIP : SLIP + 3] = rows[softens, RUB : RUB + 3] = 0.0
    return rows


def judge_anew(model: Model, state: State) -> None:
    """Set the strength of softening facets that stored the traction at initiation, and reactivate resting ones."""
    if model.softening is None:
        return
    rows = state.cracks
    strength = model.softening.strength[rows[:, FACET].astype(np.int64)]
    rows[:, ONSET] = np.where(rows[:, ONSET] > 0.0, strength, 0.0)
    rows[np.isfinite(rows[:, TOP]) & (rows[:, STATUS] == CrackStatus.RESTING), TOP] = 0.0
