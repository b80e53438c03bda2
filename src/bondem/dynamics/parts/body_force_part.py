"""Body forces: accelerations of groups of elements, and their work."""

import numpy as np

from bondem._core_steps import StepPass
from bondem._tables.step_tables import BodyForces, Moving, StepCut, Timeline
from bondem.dynamics.parts.shared_tables import SharedTables
from bondem.interactions.step_part import Part
from bondem.model.model import Model
from bondem.model.state import State

_follow_body_forces = StepPass("follow_body_forces", Timeline, BodyForces)
_open_body_work = StepPass("open_body_work", Moving, BodyForces)
_add_body_forces = StepPass("add_body_forces", Moving, StepCut, BodyForces)
_add_body_work = StepPass("add_body_work", Moving, BodyForces)


def body_forces(model: Model, state: State, shared: SharedTables) -> Part | None:
    """Return the part of body forces, or None where none act."""
    held = model.constraints
    count = len(held.body_on)
    if count == 0:
        return None
    member, group = np.unique(held.body_on.T, axis=0, return_inverse=True)
    body, strain, *_ = held.works
    table = BodyForces(
        group=group.ravel().astype(np.uint32), member=np.ascontiguousarray(member, dtype=float),
        pull=np.ascontiguousarray(held.body_value), schedule=held.body_schedule, present=np.zeros((len(member), 3)),
        factor=np.zeros(count), work=state.work[body:strain].reshape(-1, 1),
    )  # fmt: skip
    return Part({
        "present": [(_follow_body_forces, shared.timeline, table)],
        "opening": [(_open_body_work, shared.moving, table)],
        "add": [(_add_body_forces, shared.moving, shared.cut, table)],
        "settle": [(_add_body_work, shared.moving, table)],
        "reopening": [(_add_body_work, shared.moving, table)],
    })  # fmt: skip
