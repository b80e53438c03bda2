"""Counterparts of all passes of a step: the kernel launches on a device that compute the same.

The parts of a step (`bondem.dynamics.parts`) compose it once, for the CPU and for devices. Each of its passes has a
counterpart, so that a device runs whatever the CPU runs. Most counterparts are kernels with their numbers of threads
(`translation.over`, `in_order`). Counterparts that also make tables of the run are functions.
"""

from collections.abc import Mapping
from importlib import import_module
from pkgutil import iter_modules

from bondem._device import Launch
from bondem.dynamics import on_device
from bondem.dynamics.on_device.translation import Counterpart, Translation
from bondem.interactions.step_part import Passes

#: Passes that add loads to elements, in addition to those of bonds.
FURTHER = {
    "add_dashpot_loads", "add_body_forces", "add_wall_loads", "add_contact_loads", "add_crack_loads",
    "add_layer_torques", "add_inertia_forces",
}  # fmt: skip

#: Counterparts by the names of the passes of the CPU, of all modules `…_counterparts`: each subject has its own.
COUNTERPARTS: dict[str, Counterpart] = {}
for _module in iter_modules(on_device.__path__, f"{on_device.__name__}."):
    if _module.name.endswith("_counterparts"):
        COUNTERPARTS |= import_module(_module.name).COUNTERPARTS


def launches_of(passes: Passes, run: Translation, instead: Mapping[str, Counterpart] | None = None) -> list[Launch]:
    """Return the launches that compute what passes compute on the CPU, in their order.

    Args:
        passes: passes of a step.
        run: translation with the tables of the run.
        instead: counterparts to use instead of the usual ones.
    """
    counterparts = COUNTERPARTS if instead is None else {**COUNTERPARTS, **instead}
    return [launch for name, tables in passes for launch in counterparts[name](run, *tables)]
