"""Breakage of beams on a device."""

from typing import Any

import numpy as np

from bondem._device import IndexPass, Launch
from bondem._tables.damage_tables import BeamIntegrity, Candidates, EventLog, FailureBounds, Postponed, Strengths
from bondem._tables.device_tables import BondMarks, BondsOfElements, DeviceSpan, LoadsOfBonds
from bondem._tables.step_tables import (
    AlikeBeams,
    Beams,
    BodyForces,
    Dashpots,
    HistoryRows,
    Moving,
    Resistance,
    Rows,
    StepCut,
)
from bondem.damage.failure_passes import BEAM_CRITERIA
from bondem.dynamics.on_device.translation import Counterpart, Translation

_MARKS = LoadsOfBonds, FailureBounds, BondMarks
_load_marked_beam = IndexPass("load_marked_beam", Moving, Beams, *_MARKS)
_load_marked_alike_beam = IndexPass("load_marked_alike_beam", Moving, Beams, AlikeBeams, *_MARKS)
_JUDGES = {
    name: IndexPass(f"judge_beam_by_{name}", DeviceSpan, Moving, Beams, Strengths, BondMarks, Candidates, Postponed)
    for name in BEAM_CRITERIA
}
_rank_failing = IndexPass("rank_failing", BondMarks, Candidates)
_count_failures = IndexPass("count_failures", Candidates, EventLog)
_keep_gathered_sum = IndexPass("keep_gathered_sum", StepCut, BondsOfElements, LoadsOfBonds, Postponed)
_keep_sum = IndexPass("keep_sum", StepCut, Postponed)
_keep_dashed_sum = IndexPass("keep_dashed_sum", StepCut, Dashpots, Postponed)
_load_failing_dashpot = IndexPass("load_failing_dashpot", Moving, Beams, Dashpots, Candidates, LoadsOfBonds)
_OF_FAILING = BondsOfElements, BondMarks, LoadsOfBonds
_take_dashpots_off = IndexPass("take_dashpots_off_element", *_OF_FAILING, Dashpots, Candidates, Postponed)
_remove_beam = IndexPass(
    "remove_failing_beam", DeviceSpan, Moving, Beams, BeamIntegrity, Candidates, EventLog, LoadsOfBonds
)
_take_beams_off = IndexPass("take_beams_off_element", *_OF_FAILING, Candidates, Postponed)
_RESUMES = {
    (False, False): IndexPass("resume_free", DeviceSpan, Moving, StepCut, Postponed),
    (False, True): IndexPass("resume_resisted", DeviceSpan, Moving, StepCut, Resistance, Postponed),
    (True, False): IndexPass("resume_row", DeviceSpan, Moving, StepCut, Rows, Postponed),
    (True, True): IndexPass("resume_resisted_row", DeviceSpan, Moving, StepCut, Rows, Resistance, Postponed),
}
_reopen_work_of_body = IndexPass("reopen_work_of_body", DeviceSpan, Moving, BodyForces, Postponed)
_release_element = IndexPass("release_element", Candidates, Postponed)
_end_all_failures = IndexPass("end_all_failures", Candidates)
_write_released_energy = IndexPass("write_released_energy", DeviceSpan, EventLog, HistoryRows)


def marks_of(run: Translation) -> BondMarks:
    """Return the marks of the bonds of a run."""

    def make() -> BondMarks:
        m = run.span.m
        made = BondMarks(np.zeros(m, dtype=np.uint8), np.zeros(m, dtype=np.uint32), np.zeros(m, dtype=np.uint8))
        run.scratch += made
        return made

    return run.once(run.loads, make)


def ranked(run: Translation, candidates: Candidates) -> Launch:
    """Return the launch that puts bonds that fail into their order."""
    return _rank_failing, run.span.m, (marks_of(run), candidates)


def counted(run: Translation, candidates: Candidates, log: EventLog) -> Launch:
    """Return the launch that counts the events of a step, whose rows are filled, and adds up their energies."""
    run.keep_log(log)
    return _count_failures, 1, (candidates, log)


def marking(one: IndexPass) -> Counterpart:
    """Return the counterpart of a pass of loads that marks bonds near to failure."""

    def counterpart(run: Translation, moving: Moving, *tables: Any) -> list[Launch]:
        *bonds, _cut, bounds, _candidates = tables
        return [(one, run.span.m, (moving, *bonds, run.loads, bounds, marks_of(run)))]

    return counterpart


def judging(one: IndexPass) -> Counterpart:
    """Return the counterpart of a pass that evaluates marked bonds, and lists those that fail in their order."""

    def counterpart(
        run: Translation, moving: Moving, beams: Beams, strengths: Strengths, candidates: Candidates, last: Any
    ) -> list[Launch]:
        tables = run.span, moving, beams, strengths, marks_of(run), candidates, last
        return [(one, run.span.m, tables), ranked(run, candidates)]

    return counterpart


def _keep(run: Translation, cut: StepCut, postponed: Postponed) -> list[Launch]:
    if run.further:
        return [(_keep_sum, run.span.n, (cut, postponed))]
    return [(_keep_gathered_sum, run.span.n, (cut, run.bonds, run.loads, postponed))]


def _keep_dashed(run: Translation, dashpots: Dashpots, postponed: Postponed) -> list[Launch]:
    return [(_keep_dashed_sum, run.span.n, (run.cut, dashpots, postponed))]


def _withdraw_dashpots(
    run: Translation,
    moving: Moving,
    beams: Beams,
    dashpots: Dashpots,
    candidates: Candidates,
    postponed: Postponed,
) -> list[Launch]:
    of_failing = run.bonds, marks_of(run), run.dashed
    return [
        (_load_failing_dashpot, run.span.m, (moving, beams, dashpots, candidates, run.dashed)),
        (_take_dashpots_off, run.span.n, (*of_failing, dashpots, candidates, postponed)),
    ]


def _break(
    run: Translation,
    moving: Moving,
    beams: Beams,
    integrity: BeamIntegrity,
    candidates: Candidates,
    postponed: Postponed,
    log: EventLog,
) -> list[Launch]:
    return [
        (_remove_beam, run.span.m, (run.span, moving, beams, integrity, candidates, log, run.loads)),
        (_take_beams_off, run.span.n, (run.bonds, marks_of(run), run.loads, candidates, postponed)),
        counted(run, candidates, log),
    ]


def _write(run: Translation, log: EventLog, history: HistoryRows) -> list[Launch]:
    return [(_write_released_energy, 1, (run.span, log, history))]


#: Bonds that fail in a step, and elements that this postpones.
Postponement = tuple[Candidates, Postponed]


def resuming(late: Postponement) -> dict[str, Counterpart]:
    """Return the counterparts of passes that act on postponed elements only."""
    _, postponed = late

    def move(run: Translation, moving: Moving, cut: StepCut, *more: Any, rows: Rows | None = None) -> list[Launch]:
        one = _RESUMES[rows is not None, len(more) > 0]
        count = run.span.n - run.held if rows is None else run.held
        given = more if rows is None else (rows, *more)
        return [(one, count, (run.span, moving, cut, *given, postponed))]

    def move_rows(run: Translation, moving: Moving, cut: StepCut, rows: Rows, *more: Any) -> list[Launch]:
        return move(run, moving, cut, *more, rows=rows)

    def work(run: Translation, moving: Moving, body: BodyForces) -> list[Launch]:
        return [(_reopen_work_of_body, run.span.n, (run.span, moving, body, postponed))]

    def nothing(*_: Any) -> list[Launch]:
        return []

    return {
        "list_postponed": nothing,  # each thread asks whether its element is postponed
        "move_elements": move,
        "move_resisted": move,
        "move_rows": move_rows,
        "move_resisted_rows": move_rows,
        "reopen_elements": nothing,  # together with their acceleration
        "reopen_rows": nothing,
        "add_body_work": work,
    }


def end(run: Translation, late: Postponement) -> list[Launch]:
    """Return the launches that end the failures of a step."""
    candidates, postponed = late
    return [(_release_element, run.span.n, (candidates, postponed)), (_end_all_failures, 1, (candidates,))]


COUNTERPARTS: dict[str, Counterpart] = {
    "add_marked_beam_loads": marking(_load_marked_beam),
    "add_marked_alike_beam_loads": marking(_load_marked_alike_beam),
    **{f"judge_beams_by_{name}": judging(one) for name, one in _JUDGES.items()},
    "postpone_elements": lambda *_: [],
    "keep_sums": _keep,
    "keep_dashpots": _keep_dashed,
    "withdraw_dashpots": _withdraw_dashpots,
    "break_beams": _break,
    "write_released": _write,
}
