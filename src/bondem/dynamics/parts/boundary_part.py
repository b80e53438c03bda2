"""Part of a step for boundary conditions: loads, couples and drives that follow schedules."""

from bondem._passes import steps
from bondem.boundary.couples import couple_table
from bondem.dynamics.parts.shared_tables import SharedTables
from bondem.interactions.step_part import Part, Passes
from bondem.model.constraints import Constraints


def boundary(constraints: Constraints, shared: SharedTables) -> Part:
    """Return the part that evaluates loads and prescribed velocities at the present time."""
    moving, rows, timeline = shared.moving, shared.rows, shared.timeline
    loads, drives, couples = constraints.loads, constraints.drives, constraints.couples
    present: Passes = []
    if len(loads.row) or couples:
        present.append(steps.clear_row_forces(rows))
    if len(loads.row):
        present.append(steps.follow_loads(timeline, loads, moving, rows))
    if couples:
        present.append(steps.follow_couples(timeline, couple_table(couples, constraints.row_of), moving, rows))
    if len(drives.row):
        present.append(steps.follow_drives(timeline, drives, rows))
    return Part({"present": present})
