"""Boundary conditions and body forces on a device."""

from bondem._device import Launch
from bondem._passes import kernels
from bondem._tables.step_tables import BodyForces, Drives, Moving, RowLoads, Rows, Timeline
from bondem.dynamics.on_device.translation import Counterpart, Translation, elements, over


def _clear(_: Translation, rows: Rows) -> list[Launch]:
    return [(kernels.clear_row(rows), len(rows.force))]


def _loads(run: Translation, timeline: Timeline, loads: RowLoads, moving: Moving, rows: Rows) -> list[Launch]:
    tables = run.span, timeline, loads, run.order_of(loads.row), moving, rows
    return [(kernels.follow_loads_of_row(*tables), len(rows.force))]


def _drives(run: Translation, timeline: Timeline, drives: Drives, rows: Rows) -> list[Launch]:
    return [(kernels.follow_drive(run.span, timeline, drives, rows), len(drives.row))]


def _groups(run: Translation, timeline: Timeline, body: BodyForces) -> list[Launch]:
    return [(kernels.follow_body_group(run.span, timeline, body), len(body.present))]


def _work(run: Translation, moving: Moving, body: BodyForces) -> list[Launch]:
    return [(kernels.add_work_of_body(run.span, moving, run.cut, body), run.span.n)]


COUNTERPARTS: dict[str, Counterpart] = {
    "clear_row_forces": _clear,
    "follow_loads": _loads,
    "follow_couples": over(kernels.follow_all_couples, lambda _: 1),
    "follow_drives": _drives,
    "follow_body_forces": _groups,
    "open_body_work": over(kernels.open_work_of_body, elements),
    "add_body_forces": over(kernels.add_body_force, elements),
    "add_body_work": _work,
}
