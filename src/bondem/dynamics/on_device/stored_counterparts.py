"""Kernel launches on a device for the passes of beams of the incremental formulation."""

from bondem._passes import kernels
from bondem.dynamics.on_device import counts
from bondem.dynamics.on_device.translation import Counterpart, over

COUNTERPARTS: dict[str, Counterpart] = {
    "add_stored_loads": over(kernels.load_stored_beam, counts.bonds),
    "sum_stored_energies": over(kernels.sum_portion_of_stored, counts.portions_of_bonds),
}
