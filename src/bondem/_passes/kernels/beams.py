"""Passes over an index, for devices, of `core/gpu/beams.hpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Kernel
from bondem._tables.device_tables import DeviceSpan, LoadsOfBonds
from bondem._tables.step_tables import Beams, Dashpots, Ledger, Moving, UniformBeams


def check_portion(device_span: DeviceSpan, moving: Moving, beams: Beams, ledger: Ledger) -> Kernel:
    """Counts unbroken beams of a portion beyond safe angles (c1 or c2 < 0.7, w² < 0.75) and valid ones (0, 0.25);
    c, w as in `laws/beam.hpp`.

    Over one index.
    """
    return Kernel("check_portion", (device_span, moving, beams, ledger))


def load_beam(moving: Moving, beams: Beams, loads_of_bonds: LoadsOfBonds) -> Kernel:
    """Adds forces and torques of the beams of a block to the sums of their elements.

    Over one index.
    """
    return Kernel("load_beam", (moving, beams, loads_of_bonds))


def load_dashpot(moving: Moving, beams: Beams, dashpots: Dashpots, loads_of_bonds: LoadsOfBonds) -> Kernel:
    """Adds forces and torques of the dashpots of beams to sums of their own.

    Over one index.
    """
    return Kernel("load_dashpot", (moving, beams, dashpots, loads_of_bonds))


def load_uniform_beam(
    moving: Moving, beams: Beams, uniform_beams: UniformBeams, loads_of_bonds: LoadsOfBonds
) -> Kernel:
    """Adds forces and torques of beams that differ in length only.

    Over one index.
    """
    return Kernel("load_uniform_beam", (moving, beams, uniform_beams, loads_of_bonds))


def sum_portion_of_beams(device_span: DeviceSpan, moving: Moving, beams: Beams, ledger: Ledger) -> Kernel:
    """Sums normal, shear, bending and twisting energy of the beams of a portion [J].

    Over one index.
    """
    return Kernel("sum_portion_of_beams", (device_span, moving, beams, ledger))
