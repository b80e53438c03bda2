"""Passes over an index, for devices, of `core/gpu/boundary.hpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Kernel
from bondem._tables.device_tables import DeviceSpan, RowOrder
from bondem._tables.step_tables import BodyForces, CoupleTable, Drives, Moving, RowLoads, Rows, Timeline


def clear_row(rows: Rows) -> Kernel:
    """Sets the forces of all rows to zero, before loads are added.

    Over one index.
    """
    return Kernel("clear_row", (rows,))


def follow_all_couples(
    device_span: DeviceSpan, timeline: Timeline, couple_table: CoupleTable, moving: Moving, rows: Rows
) -> Kernel:
    """Adds moments on regions as forces and torques of their elements.

    Over one index.
    """
    return Kernel("follow_all_couples", (device_span, timeline, couple_table, moving, rows))


def follow_body_group(device_span: DeviceSpan, timeline: Timeline, body_forces: BodyForces) -> Kernel:
    """Sets the accelerations by body forces at the time of the clock.

    Over one index.
    """
    return Kernel("follow_body_group", (device_span, timeline, body_forces))


def follow_drive(device_span: DeviceSpan, timeline: Timeline, drives: Drives, rows: Rows) -> Kernel:
    """Sets prescribed velocities at the time of the clock, and over the step that begins there.

    Over one index.
    """
    return Kernel("follow_drive", (device_span, timeline, drives, rows))


def follow_loads_of_row(
    device_span: DeviceSpan, timeline: Timeline, row_loads: RowLoads, row_order: RowOrder, moving: Moving, rows:
    Rows
) -> Kernel:
    """Adds forces and torques of loads to their rows, turned with the element if they follow it.

    Over one index.
    """
    return Kernel("follow_loads_of_row", (device_span, timeline, row_loads, row_order, moving, rows))
