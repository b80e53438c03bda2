"""Beams that soften on a device, and the contact of beams that have broken."""

import numpy as np

from bondem._device import IndexPass, Launch
from bondem.damage.failure_passes import SOFTENING_CRITERIA, Strengths
from bondem.dynamics.contact_tables import ContactConstants, ContactPairs, ContactSums, NearPairs
from bondem.dynamics.damage_tables import BeamIntegrity, Candidates, EventLog, SofteningBeams, SofteningBounds
from bondem.dynamics.on_device.breakage_counterparts import judging, marking
from bondem.dynamics.on_device.device_tables import BondMarks, DeviceSpan, LoadsOfBonds, SofteningLosses
from bondem.dynamics.on_device.translation import Counterpart, Translation, over
from bondem.dynamics.step_tables import Moving, Portions
from bondem.interactions.beams.beam_tables import AlikeBeams, Beams

_LOSING = BeamIntegrity, SofteningBounds, SofteningBeams, SofteningLosses
_soften_listed = IndexPass("soften_listed", DeviceSpan, Moving, Beams, *_LOSING)
_end_portion = IndexPass("end_portion_of_softening", BeamIntegrity, SofteningBeams, SofteningLosses)
_log = IndexPass("log_all_softened", DeviceSpan, Moving, Beams, SofteningBeams, EventLog)
_MARKS = LoadsOfBonds, SofteningBounds, BondMarks
_load_beam = IndexPass("load_softening_beam", Moving, Beams, *_MARKS)
_load_alike_beam = IndexPass("load_softening_alike_beam", Moving, Beams, AlikeBeams, *_MARKS)
_FIND = {
    name: IndexPass(
        f"find_beginning_by_{name}", DeviceSpan, Moving, Beams, Strengths, BondMarks, Candidates, SofteningBeams
    )
    for name in SOFTENING_CRITERIA
}
_begin = IndexPass("begin_all_softening", DeviceSpan, Candidates, SofteningBounds, SofteningBeams)
_release_pressure = IndexPass("release_all_pressure", DeviceSpan, EventLog, SofteningBounds)
_begin_contacts = IndexPass(
    "begin_all_softened_contacts",
    DeviceSpan, Moving, ContactConstants, ContactPairs, NearPairs, EventLog, ContactSums,
)  # fmt: skip
_sum_pressure = IndexPass("sum_portion_of_pressure", DeviceSpan, Moving, Beams, SofteningBounds, Portions)


def _soften(
    run: Translation,
    moving: Moving,
    beams: Beams,
    integrity: BeamIntegrity,
    bounds: SofteningBounds,
    soft: SofteningBeams,
) -> list[Launch]:
    losses = run.once(soft, lambda: SofteningLosses(np.zeros(run.span.m)))
    return [
        (_soften_listed, run.span.m, (run.span, moving, beams, integrity, bounds, soft, losses)),
        (_end_portion, len(soft.number), (integrity, soft, losses)),
    ]


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


COUNTERPARTS: dict[str, Counterpart] = {
    "soften_beams": _soften,
    "log_softened_beams": _log_softened,
    "add_softening_beam_loads": marking(_load_beam),
    "add_softening_alike_beam_loads": marking(_load_alike_beam),
    **{f"find_softening_by_{name}": judging(one) for name, one in _FIND.items()},
    "begin_softening": over(_begin, _one_thread),
    "release_pressure": over(_release_pressure, _one_thread),
    "begin_softened_contacts": over(_begin_contacts, _one_thread),
    "sum_pressed_energies": _pressed,
}
