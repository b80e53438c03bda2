"""Passes over an index, for devices, of `core/gpu/storing_beams.hpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Kernel
from bondem._tables.device_tables import DeviceSpan, LoadsOfBonds
from bondem._tables.incremental_tables import StoredLoads
from bondem._tables.step_tables import Beams, Ledger, Moving


def load_stored_beam(
    device_span: DeviceSpan, moving: Moving, beams: Beams, stored_loads: StoredLoads, loads_of_bonds: LoadsOfBonds
) -> Kernel:
    """Integrates the stored loads of the beams of a block over the step, and adds them to the sums of their
    elements.

    Over one index.
    """
    return Kernel("load_stored_beam", (device_span, moving, beams, stored_loads, loads_of_bonds))


def sum_portion_of_stored(
    device_span: DeviceSpan, moving: Moving, beams: Beams, stored_loads: StoredLoads, ledger: Ledger
) -> Kernel:
    """Sums normal, shear, bending and twisting energy of the beams of a portion, by their stored loads [J].

    Over one index.
    """
    return Kernel("sum_portion_of_stored", (device_span, moving, beams, stored_loads, ledger))
