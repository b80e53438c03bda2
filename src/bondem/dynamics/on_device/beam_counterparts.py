"""Beams on a device."""

import numpy as np

from bondem._device import IndexPass, Launch
from bondem._tables.device_tables import DeviceSpan, LoadsOfBonds, StrainPortions
from bondem._tables.step_tables import AlikeBeams, Beams, Dashpots, Moving, Portions, Rows, StepCut, Strain, Timeline
from bondem.dynamics.on_device.device_tables import WORKS
from bondem.dynamics.on_device.translation import Counterpart, Translation

_follow_factors = IndexPass("follow_strain_factors", DeviceSpan, Timeline, Strain, StrainPortions)
_strain_portion = IndexPass("strain_portion", Moving, Strain, Beams, StrainPortions)
_add_work = IndexPass("add_work_of_strains", DeviceSpan, Strain, StrainPortions, Rows)
_load_beam = IndexPass("load_beam", Moving, Beams, LoadsOfBonds)
_load_alike_beam = IndexPass("load_alike_beam", Moving, Beams, AlikeBeams, LoadsOfBonds)
_load_dashpot = IndexPass("load_dashpot", Moving, Beams, Dashpots, LoadsOfBonds)
_check_portion = IndexPass("check_portion", DeviceSpan, Moving, Beams, Portions)
_sum_portion_of_beams = IndexPass("sum_portion_of_beams", DeviceSpan, Moving, Beams, Portions)


def _strains(
    run: Translation, timeline: Timeline, strain: Strain, moving: Moving, beams: Beams, rows: Rows
) -> list[Launch]:
    count = -(-len(strain.bond) // WORKS)

    def make() -> StrainPortions:
        return StrainPortions(np.zeros(2, dtype=np.int64), np.zeros((count, len(strain.schedule))))

    portions = run.once(strain, make)
    return [
        (_follow_factors, 1, (run.span, timeline, strain, portions)),
        (_strain_portion, count, (moving, strain, beams, portions)),
        (_add_work, 1, (run.span, strain, portions, rows)),
    ]


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
    "follow_strains": _strains,
    "add_beam_loads": _load,
    "add_alike_beam_loads": _load_alike,
    "add_dashpot_loads": _dash,
    "check_beams": _check,
    "sum_beam_energies": _energies,
}
