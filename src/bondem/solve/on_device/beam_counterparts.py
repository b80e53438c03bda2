"""Beams on a device."""

from bondem._device import IndexPass, Launch
from bondem.kernels.tables import StepCut
from bondem.model.beam_tables import AlikeBeams, Beams
from bondem.solve.on_device.device_tables import DeviceSpan, LoadsOfBonds
from bondem.solve.on_device.translation import Counterpart, Translation
from bondem.solve.step_tables import Dashpots, Moving, Portions

_load_beam = IndexPass("load_beam", Moving, Beams, LoadsOfBonds)
_load_alike_beam = IndexPass("load_alike_beam", Moving, Beams, AlikeBeams, LoadsOfBonds)
_load_dashpot = IndexPass("load_dashpot", Moving, Beams, Dashpots, LoadsOfBonds)
_check_portion = IndexPass("check_portion", DeviceSpan, Moving, Beams, Portions)
_sum_portion_of_beams = IndexPass("sum_portion_of_beams", DeviceSpan, Moving, Beams, Portions)


def _load(run: Translation, moving: Moving, beams: Beams, _: StepCut) -> list[Launch]:
    return [(_load_beam, run.span.m, (moving, beams, run.loads))]


def _load_alike(run: Translation, moving: Moving, beams: Beams, alike: AlikeBeams, _: StepCut) -> list[Launch]:
    return [(_load_alike_beam, run.span.m, (moving, beams, alike, run.loads))]


def _dash(run: Translation, moving: Moving, beams: Beams, dashpots: Dashpots, _: StepCut) -> list[Launch]:
    return [(_load_dashpot, run.span.m, (moving, beams, dashpots, run.dashed))]


def _check(run: Translation, moving: Moving, beams: Beams, portions: Portions) -> list[Launch]:
    return [(_check_portion, len(portions.turned), (run.span, moving, beams, portions))]


def _energies(run: Translation, moving: Moving, beams: Beams, portions: Portions) -> list[Launch]:
    return [(_sum_portion_of_beams, len(portions.bonds), (run.span, moving, beams, portions))]


COUNTERPARTS: dict[str, Counterpart] = {
    "add_beam_loads": _load,
    "add_alike_beam_loads": _load_alike,
    "add_dashpot_loads": _dash,
    "check_beams": _check,
    "sum_beam_energies": _energies,
}
