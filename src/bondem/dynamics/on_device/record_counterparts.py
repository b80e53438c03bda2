"""Records and the guard of the energy on a device."""

import numpy as np

from bondem._device import Launch
from bondem._passes import kernels
from bondem._tables.columns import DEVICE_SUMS
from bondem._tables.device_tables import GaugeParts
from bondem._tables.step_tables import Gauges, HistoryRows, Moving, Portions, Rows
from bondem.dynamics.on_device.translation import Counterpart, Given, Translation, in_order, length_of, over

# Elements of a part of a gauge, about, and parts of a gauge at most.
_GAUGED, _PARTS = 256, 1024


def _portions_of_works(run: Translation, _: Given) -> int:
    return len(run.works.works)


def _folded(run: Translation, _: Given) -> int:
    return run.folded.sums.size


# Sums of works, and all sums over portions.
_FOLD = in_order(over(kernels.sum_portion_of_works, _portions_of_works), over(kernels.fold_portions, _folded))


def _read(run: Translation, moving: Moving, rows: Rows, gauges: Gauges, history: HistoryRows) -> list[Launch]:
    count = len(gauges.quantity)
    each = min(max(int(np.diff(gauges.start).max(initial=1)) // _GAUGED, 1), _PARTS)
    parts = run.once(gauges, lambda: GaugeParts(each, np.zeros((count * each, 3))))
    return [
        (kernels.read_part_of_gauge(moving, rows, gauges, parts), count * each),
        (kernels.write_gauge(run.span, gauges, parts, history), 3 * count),
    ]


COUNTERPARTS: dict[str, Counterpart] = {
    "sum_element_energies": over(kernels.sum_portion_of_elements, length_of(Portions, lambda of: of.elements)),
    "judge_energy": _FOLD,  # the CPU evaluates the sums
    "write_ledger": in_order(_FOLD, over(kernels.write_sum, lambda *_: DEVICE_SUMS)),
    "read_gauges": _read,
}
