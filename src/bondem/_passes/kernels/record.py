"""Passes over an index, for devices, of `core/gpu/record.hpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Kernel
from bondem._tables.device_tables import DeviceSpan, GaugeParts
from bondem._tables.step_tables import Gauges, HistoryRows, Ledger, Moving, Rows


def judge_all_energy(device_span: DeviceSpan, rows: Rows, ledger: Ledger) -> Kernel:
    """Finds whether a number is not finite, or the kinetic energy is far above all energy supplied.

    Over one index.
    """
    return Kernel("judge_all_energy", (device_span, rows, ledger))


def read_part_of_gauge(moving: Moving, rows: Rows, gauges: Gauges, gauge_parts: GaugeParts) -> Kernel:
    """Adds part k % each of the elements of gauge k / each to its sums."""
    return Kernel("read_part_of_gauge", (moving, rows, gauges, gauge_parts))


def sum_portion_of_elements(device_span: DeviceSpan, moving: Moving, ledger: Ledger) -> Kernel:
    """Sums kinetic energies and losses of a portion of elements [J].

    Over one index.
    """
    return Kernel("sum_portion_of_elements", (device_span, moving, ledger))


def write_gauge(
    device_span: DeviceSpan, gauges: Gauges, gauge_parts: GaugeParts, history_rows: HistoryRows
) -> Kernel:
    """Writes component k % 3 of gauge k / 3 to the present row of the history, and clears its sum."""
    return Kernel("write_gauge", (device_span, gauges, gauge_parts, history_rows))


def write_whole_ledger(device_span: DeviceSpan, rows: Rows, ledger: Ledger, history_rows: HistoryRows) -> Kernel:
    """Writes time and the entries of the energy balance.

    Over one index.
    """
    return Kernel("write_whole_ledger", (device_span, rows, ledger, history_rows))
