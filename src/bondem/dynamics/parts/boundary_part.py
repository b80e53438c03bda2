"""Part of a step for boundary conditions: loads, couples and drives that follow schedules."""

import numpy as np

from bondem._passes import steps
from bondem._tables.step_tables import Drives, RowLoads
from bondem.dynamics.parts.shared_tables import SharedTables
from bondem.interactions.step_part import Part, Passes
from bondem.model.constraints import Schedules


def boundary(shared: SharedTables) -> Part:
    """Return the part that evaluates loads and prescribed velocities at the present time."""
    moving, rows, timeline, schedules = shared.moving, shared.rows, shared.timeline, shared.schedules
    present: Passes = []
    loaded, turned = len(schedules.load_row) > 0, len(schedules.couples.schedule) > 0
    if loaded or turned:
        present.append(steps.clear_row_forces(rows))
    if loaded:
        present.append(steps.follow_loads(timeline, _row_loads(schedules), moving, rows))
    if turned:
        present.append(steps.follow_couples(timeline, schedules.couples, moving, rows))
    if len(schedules.drive_row):
        drives = Drives(schedules.drive_row, schedules.drive_dof, schedules.drive_schedule, schedules.drive_rate)
        present.append(steps.follow_drives(timeline, drives, rows))
    return Part({"present": present})


def _row_loads(schedules: Schedules) -> RowLoads:
    turns = schedules.load_turns
    if len(turns) == 0:
        turns = np.full(len(schedules.load_row), -1, dtype=np.int64)
    return RowLoads(schedules.load_row, schedules.load_schedule, schedules.load_value, turns)
