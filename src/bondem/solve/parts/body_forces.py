"""Body forces: accelerations of groups of elements, and their work."""

import numpy as np

from bondem._core_steps import StepPass
from bondem.kernels.tables import Added, StepCut
from bondem.solve.parts.part import Part
from bondem.solve.parts.shared_tables import SharedTables
from bondem.solve.step_tables import BodyForces, Moving, Timeline

_follow_body_forces = StepPass("follow_body_forces", Timeline, BodyForces)
_open_body_work = StepPass("open_body_work", Moving, BodyForces)
_add_body_forces = StepPass("add_body_forces", Moving, StepCut, BodyForces)
_add_body_work = StepPass("add_body_work", Moving, BodyForces)


def body_forces(shared: SharedTables, more: Added) -> Part:
    """Return the part of body forces."""
    member, pull = np.ascontiguousarray(more.member), np.ascontiguousarray(more.pull)
    table = BodyForces(more.group, member, pull, more.schedule, more.present, more.factor, more.body)
    return Part({
        "present": [(_follow_body_forces, shared.timeline, table)],
        "opening": [(_open_body_work, shared.moving, table)],
        "add": [(_add_body_forces, shared.moving, shared.cut, table)],
        "settle": [(_add_body_work, shared.moving, table)],
        "reopening": [(_add_body_work, shared.moving, table)],
    })  # fmt: skip
