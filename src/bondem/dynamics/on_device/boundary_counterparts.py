"""Kernel launches on a device for the passes of boundary conditions and body forces."""

from bondem._passes import kernels
from bondem._tables.step_tables import BodyForces, Drives, RowLoads
from bondem.dynamics.on_device import counts
from bondem.dynamics.on_device.translation import Counterpart, ordered, over

_BY_ROW = ordered(RowLoads, lambda loads: loads.row)

COUNTERPARTS: dict[str, Counterpart] = {
    "clear_row_forces": over(kernels.clear_row, counts.rows),
    "follow_loads": over(kernels.follow_loads_of_row, counts.rows, _BY_ROW),
    "follow_couples": over(kernels.follow_all_couples, counts.one_thread),
    "follow_drives": over(kernels.follow_drive, counts.length_of(Drives, lambda drives: drives.row)),
    "follow_body_forces": over(kernels.follow_body_group, counts.length_of(BodyForces, lambda body: body.present)),
    "open_body_work": over(kernels.open_work_of_body, counts.elements),
    "add_body_forces": over(kernels.add_body_force, counts.elements),
    "add_body_work": over(kernels.add_work_of_body, counts.elements),
}
