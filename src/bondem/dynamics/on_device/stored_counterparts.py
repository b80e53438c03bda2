"""Beams of the incremental formulation on a device."""

from bondem._device import Launch
from bondem._passes import kernels
from bondem._tables.incremental_tables import StoredLoads
from bondem._tables.step_tables import Beams, Moving, Portions, StepCut
from bondem.dynamics.on_device.translation import Counterpart, Translation


def _load(run: Translation, moving: Moving, beams: Beams, stored: StoredLoads, _: StepCut) -> list[Launch]:
    return [(kernels.load_stored_beam(run.span, moving, beams, stored, run.loads), run.span.m)]


def _energies(
    run: Translation, moving: Moving, beams: Beams, stored: StoredLoads, portions: Portions
) -> list[Launch]:
    return [(kernels.sum_portion_of_stored(run.span, moving, beams, stored, portions), len(portions.bonds))]


COUNTERPARTS: dict[str, Counterpart] = {"add_stored_loads": _load, "sum_stored_energies": _energies}
