"""Passes over an index, for devices, of `core/gpu/record.hpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Kernel
from bondem._tables.device_tables import DeviceSpan, FoldedPortions, GaugeParts, WorkPortions
from bondem._tables.step_tables import Gauges, HistoryRows, Moving, Portions, Rows


def fold_portions(portions: Portions, work_portions: WorkPortions, folded_portions: FoldedPortions) -> Kernel:
    """Column k % 13 of group k / 13."""
    return Kernel("fold_portions", (portions, work_portions, folded_portions))


def read_part_of_gauge(moving: Moving, rows: Rows, gauges: Gauges, gauge_parts: GaugeParts) -> Kernel:
    """Part k % each of the sum of gauge k / each."""
    return Kernel("read_part_of_gauge", (moving, rows, gauges, gauge_parts))


def sum_portion_of_elements(device_span: DeviceSpan, moving: Moving, portions: Portions) -> Kernel:
    """Sums kinetic energies and losses of a portion [J].

    Over one index.
    """
    return Kernel("sum_portion_of_elements", (device_span, moving, portions))


def sum_portion_of_works(rows: Rows, work_portions: WorkPortions) -> Kernel:
    """Pass of one index, defined in `core/gpu/record.hpp`."""
    return Kernel("sum_portion_of_works", (rows, work_portions))


def write_gauge(
    device_span: DeviceSpan, gauges: Gauges, gauge_parts: GaugeParts, history_rows: HistoryRows
) -> Kernel:
    """Component k % 3 of gauge k / 3, in the present row of records."""
    return Kernel("write_gauge", (device_span, gauges, gauge_parts, history_rows))


def write_sum(device_span: DeviceSpan, folded_portions: FoldedPortions, history_rows: HistoryRows) -> Kernel:
    """Column c of the present row of records."""
    return Kernel("write_sum", (device_span, folded_portions, history_rows))
