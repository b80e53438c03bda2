"""Part of a step for body forces: accelerations of groups of elements, and their work."""

import numpy as np

from bondem._passes import steps
from bondem._tables.step_tables import BodyForces
from bondem.dynamics.parts.shared_tables import SharedTables
from bondem.interactions.step_part import Part
from bondem.model.model import Model
from bondem.model.state import State


def body_forces(model: Model, state: State, shared: SharedTables) -> Part | None:
    """Return the part of body forces, or None where none act."""
    constraints = model.constraints
    count = len(constraints.body_on)
    if count == 0:
        return None
    member, group = np.unique(constraints.body_on.T, axis=0, return_inverse=True)
    body, strain, *_ = constraints.works
    table = BodyForces(
        group=group.ravel().astype(np.uint32), member=np.ascontiguousarray(member, dtype=float),
        pull=np.ascontiguousarray(constraints.body_value), schedule=constraints.body_schedule, factor=np.zeros(count),
        present=np.zeros((len(member), 3)), work=state.work[body:strain].reshape(-1, 1),
    )  # fmt: skip
    return Part({
        "present": [steps.follow_body_forces(shared.timeline, table)],
        "opening": [steps.open_body_work(shared.moving, table)],
        "add": [steps.add_body_forces(shared.moving, shared.blocks, table)],
        "settle": [steps.add_body_work(shared.moving, table)],
        "reopening": [steps.add_body_work(shared.moving, table)],
    })  # fmt: skip
