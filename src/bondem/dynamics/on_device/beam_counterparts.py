"""Counterparts on a device of the passes of beams."""

from bondem._passes import kernels
from bondem._tables.device_tables import LoadsOfBonds
from bondem._tables.step_tables import Strain
from bondem.dynamics.on_device.translation import (
    Counterpart,
    Made,
    bonds,
    in_order,
    length_of,
    one_thread,
    over,
    portions_of_bonds,
)

#: Table of the loads of dashpots, for launches that read or write loads of bonds.
DASHED: Made = {LoadsOfBonds: lambda run, _: run.dashed}


COUNTERPARTS: dict[str, Counterpart] = {
    "follow_strains": in_order(
        over(kernels.follow_strain_factors, one_thread),
        over(kernels.stretch_strained_beam, length_of(Strain, lambda strain: strain.bond)),
        over(kernels.add_work_of_strains, one_thread),
    ),
    "add_beam_loads": over(kernels.load_beam, bonds),
    "add_uniform_beam_loads": over(kernels.load_uniform_beam, bonds),
    "add_dashpot_loads": over(kernels.load_dashpot, bonds, DASHED),
    "check_beams": over(kernels.check_portion, portions_of_bonds),
    "sum_beam_energies": over(kernels.sum_portion_of_beams, portions_of_bonds),
}
