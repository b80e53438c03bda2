"""Beams that soften on a device, and the contact of beams that have broken."""

from typing import Any

import numpy as np

from bondem._device import Launch
from bondem._passes import kernels
from bondem._tables.beam_softening_tables import SofteningBeams, SofteningBounds
from bondem._tables.damage_tables import EventLog
from bondem._tables.device_tables import SofteningLosses
from bondem._tables.step_tables import Beams, HistoryRows, Moving, Portions
from bondem.dynamics.on_device.breakage_counterparts import marks_of, ranked
from bondem.dynamics.on_device.translation import Counterpart, KernelOf, Translation, over


def _soften(
    run: Translation, moving: Moving, beams: Beams, bounds: SofteningBounds, soft: SofteningBeams
) -> list[Launch]:
    losses = run.once(soft, lambda: SofteningLosses(np.zeros(run.span.m)))
    return [
        (kernels.soften_listed(run.span, moving, beams, bounds, soft, losses), run.span.m),
        (kernels.end_portion_of_softening(bounds, soft, losses), len(soft.number)),
    ]


def _loading(load: KernelOf, begin: KernelOf) -> Counterpart:
    """Return the counterpart of a pass of loads of beams that begin to soften, which lists these in their order."""

    def counterpart(run: Translation, moving: Moving, beams: Beams, *tables: Any) -> list[Launch]:
        *alike, _cut, bounds, candidates = tables
        marks = marks_of(run)
        return [
            (load(moving, beams, *alike, run.loads, bounds, marks), run.span.m),
            (begin(run.span, moving, beams, run.loads, bounds, marks, candidates), run.span.m),
            ranked(run, candidates),
        ]

    return counterpart


def _log_softened(
    run: Translation, moving: Moving, beams: Beams, soft: SofteningBeams, log: EventLog
) -> list[Launch]:
    run.keep_log(log)
    return [(kernels.log_all_softened(run.span, moving, beams, soft, log), 1)]


def _one_thread(_: Translation) -> int:
    return 1


def _pressed(
    run: Translation, moving: Moving, beams: Beams, bounds: SofteningBounds, portions: Portions
) -> list[Launch]:
    return [(kernels.sum_portion_of_pressure(run.span, moving, beams, bounds, portions), len(portions.bonds))]


def _write_crushing(
    run: Translation, bounds: SofteningBounds, soft: SofteningBeams, log: EventLog, history: HistoryRows
) -> list[Launch]:
    return [(kernels.write_all_crushing_of_beams(run.span, bounds, soft, log, history), 1)]


COUNTERPARTS: dict[str, Counterpart] = {
    "soften_beams": _soften,
    "log_softened_beams": _log_softened,
    **{
        f"add{alike}_beam_loads_softening_by_{name}": _loading(load, one)
        for name, one in kernels.BEGIN_BEAM_BY.items()
        for alike, load in (("", kernels.load_softening_beam), ("_alike", kernels.load_softening_alike_beam))
    },
    "begin_softening": over(kernels.begin_all_softening, _one_thread),
    "release_pressure": over(kernels.release_all_pressure, _one_thread),
    "begin_softened_contacts": over(kernels.begin_all_softened_contacts, _one_thread),
    "sum_pressed_energies": _pressed,
    "write_crushing_of_beams": _write_crushing,
}
