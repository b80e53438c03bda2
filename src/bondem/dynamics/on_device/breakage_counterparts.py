"""Breakage of beams on a device."""

from typing import Any

import numpy as np

from bondem._device import Launch
from bondem._passes import kernels
from bondem._tables.damage_tables import BeamIntegrity, Candidates, EventLog, Postponed, Strengths
from bondem._tables.device_tables import BondMarks
from bondem._tables.step_tables import (
    Beams,
    BodyForces,
    Dashpots,
    HistoryRows,
    Moving,
    Rows,
    StepCut,
)
from bondem.dynamics.on_device.translation import Counterpart, KernelOf, Translation

_RESUMES: dict[tuple[bool, bool], KernelOf] = {
    (False, False): kernels.resume_free,
    (False, True): kernels.resume_resisted,
    (True, False): kernels.resume_row,
    (True, True): kernels.resume_resisted_row,
}


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
    return kernels.rank_failing(marks_of(run), candidates), run.span.m


def counted(run: Translation, candidates: Candidates, log: EventLog) -> Launch:
    """Return the launch that counts the events of a step, whose rows are filled, and adds up their energies."""
    run.keep_log(log)
    return kernels.count_failures(candidates, log), 1


def marking(one: KernelOf) -> Counterpart:
    """Return the counterpart of a pass of loads that marks bonds near to failure."""

    def counterpart(run: Translation, moving: Moving, *tables: Any) -> list[Launch]:
        *bonds, _cut, bounds, _candidates = tables
        return [(one(moving, *bonds, run.loads, bounds, marks_of(run)), run.span.m)]

    return counterpart


def judging(one: KernelOf) -> Counterpart:
    """Return the counterpart of a pass that evaluates marked bonds, and lists those that fail in their order."""

    def counterpart(
        run: Translation, moving: Moving, beams: Beams, strengths: Strengths, candidates: Candidates, last: Any
    ) -> list[Launch]:
        tables = run.span, moving, beams, strengths, marks_of(run), candidates, last
        return [(one(*tables), run.span.m), ranked(run, candidates)]

    return counterpart


def _keep(run: Translation, cut: StepCut, postponed: Postponed) -> list[Launch]:
    if run.further:
        return [(kernels.keep_sum(cut, postponed), run.span.n)]
    return [(kernels.keep_gathered_sum(cut, run.bonds, run.loads, postponed), run.span.n)]


def _keep_dashed(run: Translation, dashpots: Dashpots, postponed: Postponed) -> list[Launch]:
    return [(kernels.keep_dashed_sum(run.cut, dashpots, postponed), run.span.n)]


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
        (kernels.load_failing_dashpot(moving, beams, dashpots, candidates, run.dashed), run.span.m),
        (kernels.take_dashpots_off_element(*of_failing, dashpots, candidates, postponed), run.span.n),
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
        (kernels.remove_failing_beam(run.span, moving, beams, integrity, candidates, log, run.loads), run.span.m),
        (kernels.take_beams_off_element(run.bonds, marks_of(run), run.loads, candidates, postponed), run.span.n),
        counted(run, candidates, log),
    ]


def _write(run: Translation, log: EventLog, history: HistoryRows) -> list[Launch]:
    return [(kernels.write_released_energy(run.span, log, history), 1)]


#: Bonds that fail in a step, and elements that this postpones.
Postponement = tuple[Candidates, Postponed]


def resuming(late: Postponement) -> dict[str, Counterpart]:
    """Return the counterparts of passes that act on postponed elements only."""
    _, postponed = late

    def move(run: Translation, moving: Moving, cut: StepCut, *more: Any, rows: Rows | None = None) -> list[Launch]:
        one = _RESUMES[rows is not None, len(more) > 0]
        count = run.span.n - run.held if rows is None else run.held
        given = more if rows is None else (rows, *more)
        return [(one(run.span, moving, cut, *given, postponed), count)]

    def move_rows(run: Translation, moving: Moving, cut: StepCut, rows: Rows, *more: Any) -> list[Launch]:
        return move(run, moving, cut, *more, rows=rows)

    def work(run: Translation, moving: Moving, body: BodyForces) -> list[Launch]:
        return [(kernels.reopen_work_of_body(run.span, moving, body, postponed), run.span.n)]

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
    return [(kernels.release_element(candidates, postponed), run.span.n), (kernels.end_all_failures(candidates), 1)]


COUNTERPARTS: dict[str, Counterpart] = {
    "add_marked_beam_loads": marking(kernels.load_marked_beam),
    "add_marked_alike_beam_loads": marking(kernels.load_marked_alike_beam),
    **{f"judge_beams_by_{name}": judging(one) for name, one in kernels.JUDGE_BEAM_BY.items()},
    "postpone_elements": lambda *_: [],
    "keep_sums": _keep,
    "keep_dashpots": _keep_dashed,
    "withdraw_dashpots": _withdraw_dashpots,
    "break_beams": _break,
    "write_released": _write,
}
