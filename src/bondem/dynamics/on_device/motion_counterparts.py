"""Kernel launches on a device for the passes that sum loads and move elements."""

from bondem._passes import kernels
from bondem.dynamics.on_device import counts
from bondem.dynamics.on_device.beam_counterparts import DASHED
from bondem.dynamics.on_device.translation import Counterpart, gathered_or_summed, in_order, over

COUNTERPARTS: dict[str, Counterpart] = {
    "open_elements": over(kernels.open_element, counts.elements),
    "open_elements_and_rows": over(kernels.open_element_or_row, counts.elements),
    "collect_sums": over(kernels.gather_loads, lambda run, _: run.span.n if run.further else 0),
    "collect_dashpots": over(kernels.gather_dashpots, counts.elements, DASHED),
    "add_dashpots": in_order(),  # together with the sums of the dashpots
    "move_elements": gathered_or_summed(kernels.move_gathered, kernels.move_summed, counts.free),
    "move_resisted": gathered_or_summed(kernels.move_gathered_resisted, kernels.move_summed_resisted, counts.free),
    "move_rows": gathered_or_summed(kernels.move_gathered_row, kernels.move_summed_row, counts.owners),
    "move_resisted_rows": gathered_or_summed(
        kernels.move_gathered_resisted_row, kernels.move_summed_resisted_row, counts.owners
    ),
}
