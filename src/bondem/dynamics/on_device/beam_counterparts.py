"""Beams on a device."""

import numpy as np

from bondem._device import Launch
from bondem._passes import kernels
from bondem._tables.columns import WORKS_OF_PORTION
from bondem._tables.device_tables import StrainPortions
from bondem._tables.step_tables import AlikeBeams, Beams, Dashpots, Moving, Portions, Rows, StepCut, Strain, Timeline
from bondem.dynamics.on_device.translation import Counterpart, Translation


def _strains(
    run: Translation, timeline: Timeline, strain: Strain, moving: Moving, beams: Beams, rows: Rows
) -> list[Launch]:
    count = -(-len(strain.bond) // WORKS_OF_PORTION)

    def make() -> StrainPortions:
        return StrainPortions(np.zeros(2, dtype=np.int64), np.zeros((count, len(strain.schedule))))

    portions = run.once(strain, make)
    return [
        (kernels.follow_strain_factors(run.span, timeline, strain, portions), 1),
        (kernels.strain_portion(moving, strain, beams, portions), count),
        (kernels.add_work_of_strains(run.span, strain, portions, rows), 1),
    ]


def _load(run: Translation, moving: Moving, beams: Beams, _: StepCut) -> list[Launch]:
    return [(kernels.load_beam(moving, beams, run.loads), run.span.m)]


def _load_alike(run: Translation, moving: Moving, beams: Beams, alike: AlikeBeams, _: StepCut) -> list[Launch]:
    return [(kernels.load_alike_beam(moving, beams, alike, run.loads), run.span.m)]


def _dash(run: Translation, moving: Moving, beams: Beams, dashpots: Dashpots, _: StepCut) -> list[Launch]:
    return [(kernels.load_dashpot(moving, beams, dashpots, run.dashed), run.span.m)]


def _check(run: Translation, moving: Moving, beams: Beams, portions: Portions) -> list[Launch]:
    return [(kernels.check_portion(run.span, moving, beams, portions), len(portions.turned))]


def _energies(run: Translation, moving: Moving, beams: Beams, portions: Portions) -> list[Launch]:
    return [(kernels.sum_portion_of_beams(run.span, moving, beams, portions), len(portions.bonds))]


COUNTERPARTS: dict[str, Counterpart] = {
    "follow_strains": _strains,
    "add_beam_loads": _load,
    "add_alike_beam_loads": _load_alike,
    "add_dashpot_loads": _dash,
    "check_beams": _check,
    "sum_beam_energies": _energies,
}
