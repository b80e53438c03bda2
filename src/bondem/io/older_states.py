"""Conversion of states of older run files."""

import numpy as np

from bondem._tables.columns import CrackKind, CrackStatus, EventColumn
from bondem._types import Floats
from bondem.boundary.wall_rows import walls_at_rest
from bondem.damage.crack_columns import CRACK_COLUMNS, FACET, KIND, ONSET, ROOT, RUB, SLIP, SPENT, STATUS, TOP
from bondem.damage.crack_rows import axes_along, crack_rows, isotropic_left
from bondem.model.model import Model
from bondem.model.state import State

# First schema in which cracks are compared with the strength of their facet, and places are relative to the local
# origin; and first one with the step of initiation of failures and softening bonds, touching faces of contacts, and
# crack axes.
_BY_FACET, _WITH_ONSET = 8, 10
# First schema in which walls have an orientation, and the number of their columns before.
_TURNING, _UNTURNED = 11, 14
# First schema in which cracks have roots of energies in place of energies.
_WITH_ROOTS = 13
#: Arrays with new last columns in schema 10: number of these columns, and their value for older files.
_OF_ONSET = {"broken": (1, np.nan), "softened": (1, np.nan), "stretch": (3, 0.0)}
# Columns of older cracks: facet, strength, slip, rate, status, integrity a step ago, friction force, energy, top.
_OLDER = 13


def shape_in(schema: int, name: str, shape: tuple[int, ...]) -> tuple[int, ...]:
    """Convert the current shape of an array of a state to that in files of a schema."""
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
    if schema < _WITH_ROOTS:
        roots = state.cracks[:, ROOT : ROOT + 4]
        np.sqrt(roots, out=roots)
        roots[:, 3] = 0.0  # the bending of a step ago was not stored apart
    if schema >= _BY_FACET:
        return
    judge_anew(model, state)
    if state.origin.any():  # older places are relative to zero
        state.pose[:, :3] -= state.origin
        state.broken[:, EventColumn.PLACE : EventColumn.PLACE + 3] -= state.origin


def with_directions(model: Model, state: State) -> Floats:
    """Convert cracks of files with one integrity per facet, which becomes that along all crack axes."""
    older = state.cracks
    if not len(older):
        return np.zeros((0, CRACK_COLUMNS))
    facet = older[:, 0].astype(np.int64)
    table = model.softening
    isotropic = older[:, 1] == 0.0 if table is None else (older[:, 1] == 0.0) | table.plane[facet]
    axes = axes_along(model.cell_law.constants.normal[facet])
    rows = crack_rows(facet, older[:, 1], axes, isotropic_left(state.integrity[facet]), isotropic)
    rows[:, SLIP : SLIP + 3], rows[:, RUB : RUB + 3] = older[:, 2:5], older[:, 8:11]
    for column, of_row in ((ROOT, 5), (STATUS, 6), (SPENT, 11), (TOP, 12)):
        rows[:, column] = older[:, of_row]
    # resting cracks of the material become active, and its cracks lose their slip and friction
    softens = rows[:, KIND] == CrackKind.OF_MATERIAL
    rows[softens & (rows[:, STATUS] == CrackStatus.RESTING), STATUS] = CrackStatus.ACTIVE
    rows[softens, SLIP : SLIP + 3] = rows[softens, RUB : RUB + 3] = 0.0
    return rows


def judge_anew(model: Model, state: State) -> None:
    """Replace the traction at initiation of cracks by the strength, and reset the force limit of cracks at rest."""
    if model.softening is None:
        return
    rows = state.cracks
    strength = model.softening.strength[rows[:, FACET].astype(np.int64)]
    rows[:, ONSET] = np.where(rows[:, ONSET] > 0.0, strength, 0.0)
    rows[np.isfinite(rows[:, TOP]) & (rows[:, STATUS] == CrackStatus.RESTING), TOP] = 0.0
