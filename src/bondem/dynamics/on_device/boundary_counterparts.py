"""Boundary conditions and body forces on a device."""

from bondem._device import IndexPass, Launch
from bondem._tables.device_tables import DeviceSpan, RowOrder
from bondem._tables.step_tables import BodyForces, CoupleTable, Drives, Moving, RowLoads, Rows, StepCut, Timeline
from bondem.dynamics.on_device.translation import Counterpart, Translation, elements, over

_clear_row = IndexPass("clear_row", Rows)
_follow_loads_of_row = IndexPass("follow_loads_of_row", DeviceSpan, Timeline, RowLoads, RowOrder, Moving, Rows)
_follow_all_couples = IndexPass("follow_all_couples", DeviceSpan, Timeline, CoupleTable, Moving, Rows)
_follow_drive = IndexPass("follow_drive", DeviceSpan, Timeline, Drives, Rows)
_follow_body_group = IndexPass("follow_body_group", DeviceSpan, Timeline, BodyForces)
_open_work_of_body = IndexPass("open_work_of_body", DeviceSpan, Moving, BodyForces)
_add_body_force = IndexPass("add_body_force", DeviceSpan, Moving, StepCut, BodyForces)
_add_work_of_body = IndexPass("add_work_of_body", DeviceSpan, Moving, StepCut, BodyForces)


def _clear(_: Translation, rows: Rows) -> list[Launch]:
    return [(_clear_row, len(rows.force), (rows,))]


def _loads(run: Translation, timeline: Timeline, loads: RowLoads, moving: Moving, rows: Rows) -> list[Launch]:
    tables = run.span, timeline, loads, run.order_of(loads.row), moving, rows
    return [(_follow_loads_of_row, len(rows.force), tables)]


def _drives(run: Translation, timeline: Timeline, drives: Drives, rows: Rows) -> list[Launch]:
    return [(_follow_drive, len(drives.row), (run.span, timeline, drives, rows))]


def _groups(run: Translation, timeline: Timeline, body: BodyForces) -> list[Launch]:
    return [(_follow_body_group, len(body.present), (run.span, timeline, body))]


def _work(run: Translation, moving: Moving, body: BodyForces) -> list[Launch]:
    return [(_add_work_of_body, run.span.n, (run.span, moving, run.cut, body))]


COUNTERPARTS: dict[str, Counterpart] = {
    "clear_row_forces": _clear,
    "follow_loads": _loads,
    "follow_couples": over(_follow_all_couples, lambda _: 1),
    "follow_drives": _drives,
    "follow_body_forces": _groups,
    "open_body_work": over(_open_work_of_body, elements),
    "add_body_forces": over(_add_body_force, elements),
    "add_body_work": _work,
}
