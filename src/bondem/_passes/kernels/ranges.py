"""Passes over an index, for devices, of `core/gpu/ranges.hpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Kernel
from bondem._tables.device_tables import DeviceSpan, Tick
from bondem._tables.step_tables import StepScheme


def count_record(device_span: DeviceSpan) -> Kernel:
    """Advances the row of the history to which the next record is written."""
    return Kernel("count_record", (device_span,))


def set_clock(device_span: DeviceSpan, step_scheme: StepScheme, tick: Tick) -> Kernel:
    """Advances the clock by `ahead` steps and sets its flags; for a step of no duration its coefficients are 0."""
    return Kernel("set_clock", (device_span, step_scheme, tick))
