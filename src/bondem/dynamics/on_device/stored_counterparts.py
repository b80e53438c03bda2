"""Beams of the incremental formulation on a device."""

from bondem._device import IndexPass, Launch
from bondem._tables.device_tables import DeviceSpan, LoadsOfBonds
from bondem._tables.incremental_tables import StoredLoads
from bondem._tables.step_tables import Beams, Moving, Portions, StepCut
from bondem.dynamics.on_device.translation import Counterpart, Translation

_load_stored_beam = IndexPass("load_stored_beam", DeviceSpan, Moving, Beams, StoredLoads, LoadsOfBonds)
_sum_portion = IndexPass("sum_portion_of_stored", DeviceSpan, Moving, Beams, StoredLoads, Portions)


def _load(run: Translation, moving: Moving, beams: Beams, stored: StoredLoads, _: StepCut) -> list[Launch]:
    return [(_load_stored_beam, run.span.m, (run.span, moving, beams, stored, run.loads))]


def _energies(
    run: Translation, moving: Moving, beams: Beams, stored: StoredLoads, portions: Portions
) -> list[Launch]:
    return [(_sum_portion, len(portions.bonds), (run.span, moving, beams, stored, portions))]


COUNTERPARTS: dict[str, Counterpart] = {"add_stored_loads": _load, "sum_stored_energies": _energies}
