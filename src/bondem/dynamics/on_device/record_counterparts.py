"""Records and the guard of the energy on a device."""

import numpy as np

from bondem._device import IndexPass, Launch
from bondem._tables.device_tables import DeviceSpan, FoldedPortions, GaugeParts
from bondem._tables.step_tables import Gauges, HistoryRows, Moving, Portions, Rows
from bondem.dynamics.on_device.device_tables import SUM_COLUMNS
from bondem.dynamics.on_device.translation import Counterpart, Translation

# Elements of a part of a gauge, about, and parts of a gauge at most.
_GAUGED, _PARTS = 256, 1024

_sum_portion_of_elements = IndexPass("sum_portion_of_elements", DeviceSpan, Moving, Portions)
_write_sum = IndexPass("write_sum", DeviceSpan, FoldedPortions, HistoryRows)
_read_part_of_gauge = IndexPass("read_part_of_gauge", Moving, Rows, Gauges, GaugeParts)
_write_gauge = IndexPass("write_gauge", DeviceSpan, Gauges, GaugeParts, HistoryRows)


def _sum(run: Translation, moving: Moving, portions: Portions) -> list[Launch]:
    return [(_sum_portion_of_elements, len(portions.elements), (run.span, moving, portions))]


def _judge(run: Translation, rows: Rows, portions: Portions) -> list[Launch]:
    """The CPU judges the sums."""
    return run.fold(rows, portions)


def _write(run: Translation, rows: Rows, portions: Portions, history: HistoryRows) -> list[Launch]:
    return [*run.fold(rows, portions), (_write_sum, len(SUM_COLUMNS), (run.span, run.folded, history))]


def _read(run: Translation, moving: Moving, rows: Rows, gauges: Gauges, history: HistoryRows) -> list[Launch]:
    count = len(gauges.quantity)
    each = min(max(int(np.diff(gauges.start).max(initial=1)) // _GAUGED, 1), _PARTS)
    parts = run.once(gauges, lambda: GaugeParts(each, np.zeros((count * each, 3))))
    return [
        (_read_part_of_gauge, count * each, (moving, rows, gauges, parts)),
        (_write_gauge, 3 * count, (run.span, gauges, parts, history)),
    ]


COUNTERPARTS: dict[str, Counterpart] = {
    "sum_element_energies": _sum,
    "judge_energy": _judge,
    "write_ledger": _write,
    "read_gauges": _read,
}
