"""The counterparts of all passes: for each pass that a step is composed of, the launches that do the same.

The parts of a step (`bondem.dynamics.parts`) compose it once, for the CPU and for devices. Each of its passes has a
counterpart, so that a device runs whatever the CPU runs.
"""

from collections.abc import Mapping

from bondem._device import Launch
from bondem.dynamics.on_device import (
    beam_counterparts,
    boundary_counterparts,
    breakage_counterparts,
    cell_counterparts,
    contact_counterparts,
    crack_counterparts,
    crack_onset_counterparts,
    facet_breakage_counterparts,
    motion_counterparts,
    non_local_counterparts,
    record_counterparts,
    softening_counterparts,
    stored_counterparts,
    stress_onset_counterparts,
    yielding_counterparts,
)
from bondem.dynamics.on_device.translation import Counterpart, Translation
from bondem.interactions.step_part import Passes

#: Passes that act on elements beside the loads of their bonds.
FURTHER = {
    "add_dashpot_loads", "add_body_forces", "add_wall_loads", "add_contact_loads", "add_crack_loads",
    "add_layer_torques", "add_inertia_forces",
}  # fmt: skip

#: Counterparts by the names of the passes of the CPU.
COUNTERPARTS = {
    **boundary_counterparts.COUNTERPARTS,
    **beam_counterparts.COUNTERPARTS,
    **breakage_counterparts.COUNTERPARTS,
    **cell_counterparts.COUNTERPARTS,
    **contact_counterparts.COUNTERPARTS,
    **crack_counterparts.COUNTERPARTS,
    **crack_onset_counterparts.COUNTERPARTS,
    **facet_breakage_counterparts.COUNTERPARTS,
    **motion_counterparts.COUNTERPARTS,
    **non_local_counterparts.COUNTERPARTS,
    **record_counterparts.COUNTERPARTS,
    **stress_onset_counterparts.COUNTERPARTS,
    **softening_counterparts.COUNTERPARTS,
    **stored_counterparts.COUNTERPARTS,
    **yielding_counterparts.COUNTERPARTS,
}


def launches_of(passes: Passes, run: Translation, instead: Mapping[str, Counterpart] | None = None) -> list[Launch]:
    """Return the launches that correspond to passes.

    Args:
        passes: passes of a step.
        run: tables of the run.
        instead: counterparts to use instead of the usual ones.
    """
    counterparts = COUNTERPARTS if instead is None else {**COUNTERPARTS, **instead}
    return [launch for name, tables in passes for launch in counterparts[name](run, *tables)]
