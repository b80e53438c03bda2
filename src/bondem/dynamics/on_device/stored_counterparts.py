"""Beams of the incremental formulation on a device."""

from bondem._device import IndexPass, Launch
from bondem.dynamics.on_device.device_tables import DeviceSpan, LoadsOfBonds
from bondem.dynamics.on_device.translation import Counterpart, Translation
from bondem.dynamics.step_tables import Moving, Portions
from bondem.interactions.beams.beam_tables import Beams
from bondem.model.domain_blocks import StepCut
from bondem.model.incremental_tables import StoredLoads

_load_stored_beam = IndexPass("load_stored_beam", DeviceSpan, Moving, Beams, StoredLoads, LoadsOfBonds)
_sum_portion = IndexPass("sum_portion_of_stored", DeviceSpan, Moving, Beams, StoredLoads, Portions)


def _load(run: Translation, moving: Moving, beams: Beams, stored: StoredLoads, _: StepCut) -> list[Launch]:
    return [(_load_stored_beam, run.span.m, (run.span, moving, beams, stored, run.loads))]


def _energies(
    run: Translation, moving: Moving, beams: Beams, stored: StoredLoads, portions: Portions
) -> list[Launch]:
    return [(_sum_portion, len(portions.bonds), (run.span, moving, beams, stored, portions))]


COUNTERPARTS: dict[str, Counterpart] = {"add_stored_loads": _load, "sum_stored_energies": _energies}
