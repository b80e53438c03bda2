"""Beams that soften on a device, and the contact of beams that have broken."""

from typing import Any

import numpy as np

from bondem._device import IndexPass, Launch
from bondem._tables.beam_softening_tables import SofteningBeams, SofteningBounds
from bondem._tables.contact_tables import ContactConstants, ContactPairs, ContactSums, NearPairs
from bondem._tables.damage_tables import Candidates, EventLog
from bondem._tables.device_tables import BondMarks, DeviceSpan, LoadsOfBonds, SofteningLosses
from bondem._tables.step_tables import AlikeBeams, Beams, HistoryRows, Moving, Portions
from bondem.damage.failure_passes import SOFTENING_CRITERIA
from bondem.dynamics.on_device.breakage_counterparts import marks_of, ranked
from bondem.dynamics.on_device.translation import Counterpart, Translation, over

_soften_listed = IndexPass(
    "soften_listed", DeviceSpan, Moving, Beams, SofteningBounds, SofteningBeams, SofteningLosses
)
_end_portion = IndexPass("end_portion_of_softening", SofteningBounds, SofteningBeams, SofteningLosses)
_log = IndexPass("log_all_softened", DeviceSpan, Moving, Beams, SofteningBeams, EventLog)
_MARKS = LoadsOfBonds, SofteningBounds, BondMarks
_load_beam = IndexPass("load_softening_beam", Moving, Beams, *_MARKS)
_load_alike_beam = IndexPass("load_softening_alike_beam", Moving, Beams, AlikeBeams, *_MARKS)
_BEGIN = {
    name: IndexPass(f"begin_beam_by_{name}", DeviceSpan, Moving, Beams, *_MARKS, Candidates)
    for name in SOFTENING_CRITERIA
}
_begin = IndexPass("begin_all_softening", DeviceSpan, Candidates, SofteningBounds, SofteningBeams, EventLog)
_release_pressure = IndexPass("release_all_pressure", DeviceSpan, EventLog, SofteningBounds)
_begin_contacts = IndexPass(
    "begin_all_softened_contacts",
    DeviceSpan, Moving, ContactConstants, ContactPairs, NearPairs, EventLog, ContactSums,
)  # fmt: skip
_sum_pressure = IndexPass("sum_portion_of_pressure", DeviceSpan, Moving, Beams, SofteningBounds, Portions)
_crushing = IndexPass(
    "write_all_crushing_of_beams", DeviceSpan, SofteningBounds, SofteningBeams, EventLog, HistoryRows
)


def _soften(
    run: Translation, moving: Moving, beams: Beams, bounds: SofteningBounds, soft: SofteningBeams
) -> list[Launch]:
    losses = run.once(soft, lambda: SofteningLosses(np.zeros(run.span.m)))
    return [
        (_soften_listed, run.span.m, (run.span, moving, beams, bounds, soft, losses)),
        (_end_portion, len(soft.number), (bounds, soft, losses)),
    ]


def _loading(load: IndexPass, begin: IndexPass) -> Counterpart:
    """Return the counterpart of a pass of loads of beams that begin to soften, which lists these in their order."""

    def counterpart(run: Translation, moving: Moving, beams: Beams, *tables: Any) -> list[Launch]:
        *alike, _cut, bounds, candidates = tables
        marks = marks_of(run)
        return [
            (load, run.span.m, (moving, beams, *alike, run.loads, bounds, marks)),
            (begin, run.span.m, (run.span, moving, beams, run.loads, bounds, marks, candidates)),
            ranked(run, candidates),
        ]

    return counterpart


def _log_softened(
    run: Translation, moving: Moving, beams: Beams, soft: SofteningBeams, log: EventLog
) -> list[Launch]:
    run.keep_log(log)
    return [(_log, 1, (run.span, moving, beams, soft, log))]


def _one_thread(_: Translation) -> int:
    return 1


def _pressed(
    run: Translation, moving: Moving, beams: Beams, bounds: SofteningBounds, portions: Portions
) -> list[Launch]:
    return [(_sum_pressure, len(portions.bonds), (run.span, moving, beams, bounds, portions))]


def _write_crushing(
    run: Translation, bounds: SofteningBounds, soft: SofteningBeams, log: EventLog, history: HistoryRows
) -> list[Launch]:
    return [(_crushing, 1, (run.span, bounds, soft, log, history))]


COUNTERPARTS: dict[str, Counterpart] = {
    "soften_beams": _soften,
    "log_softened_beams": _log_softened,
    **{f"add_beam_loads_softening_by_{name}": _loading(_load_beam, one) for name, one in _BEGIN.items()},
    **{f"add_alike_beam_loads_softening_by_{name}": _loading(_load_alike_beam, one) for name, one in _BEGIN.items()},
    "begin_softening": over(_begin, _one_thread),
    "release_pressure": over(_release_pressure, _one_thread),
    "begin_softened_contacts": over(_begin_contacts, _one_thread),
    "sum_pressed_energies": _pressed,
    "write_crushing_of_beams": _write_crushing,
}
