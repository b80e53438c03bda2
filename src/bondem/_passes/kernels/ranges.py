"""Passes over an index, for devices, of `core/gpu/ranges.hpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Kernel
from bondem._tables.device_tables import DeviceSpan, Tick
from bondem._tables.step_tables import StepScheme


def count_record(device_span: DeviceSpan) -> Kernel:
    """The next record goes to the next row of the history."""
    return Kernel("count_record", (device_span,))


def set_clock(device_span: DeviceSpan, step_scheme: StepScheme, tick: Tick) -> Kernel:
    """Sets the clock to a number of steps from the present one."""
    return Kernel("set_clock", (device_span, step_scheme, tick))
