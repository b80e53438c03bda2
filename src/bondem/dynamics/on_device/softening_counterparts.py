"""Kernel launches on a device for the passes of softening beams, and of their contact after failure."""

from bondem._device import Launch
from bondem._passes import kernels
from bondem._tables.beam_softening_tables import SofteningBeams
from bondem._tables.damage_tables import EventLog
from bondem._tables.step_tables import Beams, Moving
from bondem.dynamics.on_device import counts
from bondem.dynamics.on_device.breakage_counterparts import MARKS, RANKED
from bondem.dynamics.on_device.translation import Counterpart, Translation, in_order, over


def _log_softened(
    run: Translation, moving: Moving, beams: Beams, soft: SofteningBeams, log: EventLog
) -> list[Launch]:
    run.keep_log(log)
    return [(kernels.log_all_softened(run.span, moving, beams, soft, log), 1)]


COUNTERPARTS: dict[str, Counterpart] = {
    "soften_beams": in_order(
        over(kernels.soften_listed, counts.bonds),
        over(kernels.end_portion_of_softening, counts.length_of(SofteningBeams, lambda soft: soft.number)),
    ),
    "log_softened_beams": _log_softened,
    **{
        f"add{kind}_beam_loads_softening_by_{name}": in_order(
            over(load, counts.bonds, MARKS), over(one, counts.bonds, MARKS), RANKED
        )
        for name, one in kernels.BEGIN_BEAM_BY.items()
        for kind, load in (("", kernels.load_softening_beam), ("_uniform", kernels.load_softening_uniform_beam))
    },
    "begin_softening": over(kernels.begin_all_softening, counts.one_thread),
    "release_pressure": over(kernels.release_all_pressure, counts.one_thread),
    "begin_softened_contacts": over(kernels.begin_all_softened_contacts, counts.one_thread),
    "sum_pressed_energies": over(kernels.sum_portion_of_pressure, counts.portions_of_bonds),
    "write_crushing_of_beams": over(kernels.write_all_crushing_of_beams, counts.one_thread),
}
