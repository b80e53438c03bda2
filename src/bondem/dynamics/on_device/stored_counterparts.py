"""Counterparts on a device of the passes of beams of the incremental formulation."""

from bondem._passes import kernels
from bondem.dynamics.on_device.translation import Counterpart, bonds, over, portions_of_bonds

COUNTERPARTS: dict[str, Counterpart] = {
    "add_stored_loads": over(kernels.load_stored_beam, bonds),
    "sum_stored_energies": over(kernels.sum_portion_of_stored, portions_of_bonds),
}
