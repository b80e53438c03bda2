"""Kernel launches on a device for the passes that write records and check the energy."""

import numpy as np

from bondem._cache_lines import exact_sums
from bondem._device import Launch
from bondem._passes import kernels
from bondem._tables.device_tables import GaugeParts
from bondem._tables.step_tables import Gauges, HistoryRows, Moving, Rows
from bondem.dynamics.on_device import counts
from bondem.dynamics.on_device.translation import Counterpart, Translation, over

# Intended number of elements in a part of a gauge, and largest number of parts.
_GAUGED, _PARTS = 256, 1024


def _read(run: Translation, moving: Moving, rows: Rows, gauges: Gauges, history: HistoryRows) -> list[Launch]:
    count = len(gauges.quantity)
    each = min(max(int(np.diff(gauges.start).max(initial=1)) // _GAUGED, 1), _PARTS)
    parts = run.once(gauges, lambda: GaugeParts(each, exact_sums(3 * count), np.zeros((count * each, 3))))
    return [
        (kernels.read_part_of_gauge(moving, rows, gauges, parts), count * each),
        (kernels.write_gauge(run.span, gauges, parts, history), 3 * count),
    ]


COUNTERPARTS: dict[str, Counterpart] = {
    "sum_element_energies": over(kernels.sum_portion_of_elements, counts.portions_of_elements),
    "judge_energy": over(kernels.judge_all_energy, counts.one_thread),
    "write_ledger": over(kernels.write_whole_ledger, counts.one_thread),
    "read_gauges": _read,
}
