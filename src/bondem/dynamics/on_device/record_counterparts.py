"""Records and the guard of the energy on a device."""

import numpy as np

from bondem._device import Launch
from bondem._passes import kernels
from bondem._tables.columns import DEVICE_SUMS
from bondem._tables.device_tables import GaugeParts
from bondem._tables.step_tables import Gauges, HistoryRows, Moving, Portions, Rows
from bondem.dynamics.on_device.translation import Counterpart, Translation

# Elements of a part of a gauge, about, and parts of a gauge at most.
_GAUGED, _PARTS = 256, 1024



def _sum(run: Translation, moving: Moving, portions: Portions) -> list[Launch]:
    return [(kernels.sum_portion_of_elements(run.span, moving, portions), len(portions.elements))]


def _judge(run: Translation, rows: Rows, portions: Portions) -> list[Launch]:
    """Return the launches of the sums that the CPU evaluates."""
    return run.fold(rows, portions)


def _write(run: Translation, rows: Rows, portions: Portions, history: HistoryRows) -> list[Launch]:
    return [*run.fold(rows, portions), (kernels.write_sum(run.span, run.folded, history), DEVICE_SUMS)]


def _read(run: Translation, moving: Moving, rows: Rows, gauges: Gauges, history: HistoryRows) -> list[Launch]:
    count = len(gauges.quantity)
    each = min(max(int(np.diff(gauges.start).max(initial=1)) // _GAUGED, 1), _PARTS)
    parts = run.once(gauges, lambda: GaugeParts(each, np.zeros((count * each, 3))))
    return [
        (kernels.read_part_of_gauge(moving, rows, gauges, parts), count * each),
        (kernels.write_gauge(run.span, gauges, parts, history), 3 * count),
    ]


COUNTERPARTS: dict[str, Counterpart] = {
    "sum_element_energies": _sum,
    "judge_energy": _judge,
    "write_ledger": _write,
    "read_gauges": _read,
}
