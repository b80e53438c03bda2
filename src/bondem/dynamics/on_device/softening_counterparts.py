"""Counterparts on a device of the passes of softening beams, and of their contact after failure."""

from bondem._device import Launch
from bondem._passes import kernels
from bondem._tables.beam_softening_tables import SofteningBeams
from bondem._tables.damage_tables import EventLog
from bondem._tables.step_tables import Beams, Moving
from bondem.dynamics.on_device.breakage_counterparts import MARKS, RANKED
from bondem.dynamics.on_device.translation import (
    Counterpart,
    Translation,
    bonds,
    in_order,
    length_of,
    one_thread,
    over,
    portions_of_bonds,
)


def _log_softened(
    run: Translation, moving: Moving, beams: Beams, soft: SofteningBeams, log: EventLog
) -> list[Launch]:
    run.keep_log(log)
    return [(kernels.log_all_softened(run.span, moving, beams, soft, log), 1)]


COUNTERPARTS: dict[str, Counterpart] = {
    "soften_beams": in_order(
        over(kernels.soften_listed, bonds),
        over(kernels.end_portion_of_softening, length_of(SofteningBeams, lambda soft: soft.number)),
    ),
    "log_softened_beams": _log_softened,
    **{
        f"add{kind}_beam_loads_softening_by_{name}": in_order(
            over(load, bonds, MARKS), over(one, bonds, MARKS), RANKED
        )
        for name, one in kernels.BEGIN_BEAM_BY.items()
        for kind, load in (("", kernels.load_softening_beam), ("_uniform", kernels.load_softening_uniform_beam))
    },
    "begin_softening": over(kernels.begin_all_softening, one_thread),
    "release_pressure": over(kernels.release_all_pressure, one_thread),
    "begin_softened_contacts": over(kernels.begin_all_softened_contacts, one_thread),
    "sum_pressed_energies": over(kernels.sum_portion_of_pressure, portions_of_bonds),
    "write_crushing_of_beams": over(kernels.write_all_crushing_of_beams, one_thread),
}
