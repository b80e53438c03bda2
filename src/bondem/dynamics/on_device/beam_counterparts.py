"""Kernel launches on a device for the passes of beams."""

from bondem._passes import kernels
from bondem._tables.device_tables import LoadsOfBonds
from bondem._tables.step_tables import Strain
from bondem.dynamics.on_device import counts
from bondem.dynamics.on_device.translation import Counterpart, Made, in_order, over

#: Table of the loads of dashpots, for launches that read or write loads of bonds.
DASHED: Made = {LoadsOfBonds: lambda run, _: run.dashed}


COUNTERPARTS: dict[str, Counterpart] = {
    "follow_strains": in_order(
        over(kernels.follow_strain_factors, counts.one_thread),
        over(kernels.stretch_strained_beam, counts.length_of(Strain, lambda strain: strain.bond)),
        over(kernels.add_work_of_strains, counts.one_thread),
    ),
    "add_beam_loads": over(kernels.load_beam, counts.bonds),
    "add_uniform_beam_loads": over(kernels.load_uniform_beam, counts.bonds),
    "add_dashpot_loads": over(kernels.load_dashpot, counts.bonds, DASHED),
    "check_beams": over(kernels.check_portion, counts.portions_of_bonds),
    "sum_beam_energies": over(kernels.sum_portion_of_beams, counts.portions_of_bonds),
}
