"""Passes that steps are composed of, of `core/passes/damage/beam_failure.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.damage_tables import BeamIntegrity, Candidates, EventLog, Postponed, Strengths
from bondem._tables.step_tables import Beams, Dashpots, Moving


def break_beams(
    moving: Moving, beams: Beams, beam_integrity: BeamIntegrity, candidates: Candidates, postponed: Postponed,
    event_log: EventLog
) -> StepEntry:
    """Removes the beams that fail.

    Over events of the step, such as failures, in their order. Reads `pose` at both ends, of elements that are
    postponed; adds `sum` to elements.
    """
    return StepEntry("break_beams", (moving, beams, beam_integrity, candidates, postponed, event_log))


def judge_beams_by_elliptic(
    moving: Moving, beams: Beams, strengths: Strengths, candidates: Candidates, postponed: Postponed
) -> StepEntry:
    """Evaluates marked beams of a block by a criterion, and postpones the elements of failed beams.

    Over bonds of a block. Reads `pose` at both ends; adds `flag` to elements.
    """
    return StepEntry("judge_beams_by_elliptic", (moving, beams, strengths, candidates, postponed))


def judge_beams_by_linear_sum(
    moving: Moving, beams: Beams, strengths: Strengths, candidates: Candidates, postponed: Postponed
) -> StepEntry:
    """Evaluates marked beams of a block by a criterion, and postpones the elements of failed beams.

    Over bonds of a block. Reads `pose` at both ends; adds `flag` to elements.
    """
    return StepEntry("judge_beams_by_linear_sum", (moving, beams, strengths, candidates, postponed))


def judge_beams_by_mohr_coulomb(
    moving: Moving, beams: Beams, strengths: Strengths, candidates: Candidates, postponed: Postponed
) -> StepEntry:
    """Evaluates marked beams of a block by a criterion, and postpones the elements of failed beams.

    Over bonds of a block. Reads `pose` at both ends; adds `flag` to elements.
    """
    return StepEntry("judge_beams_by_mohr_coulomb", (moving, beams, strengths, candidates, postponed))


def judge_beams_by_peripheral_stress(
    moving: Moving, beams: Beams, strengths: Strengths, candidates: Candidates, postponed: Postponed
) -> StepEntry:
    """Evaluates marked beams of a block by a criterion, and postpones the elements of failed beams.

    Over bonds of a block. Reads `pose` at both ends; adds `flag` to elements.
    """
    return StepEntry("judge_beams_by_peripheral_stress", (moving, beams, strengths, candidates, postponed))


def withdraw_dashpots(
    moving: Moving, beams: Beams, dashpots: Dashpots, candidates: Candidates, postponed: Postponed
) -> StepEntry:
    """Subtracts dashpots of failed beams from the kept sums of their ends, before the beams are removed.

    Over events of the step, such as failures, in their order. Reads `motion` at both ends; reads `pose` at both
    ends, of elements that are postponed; adds `sum`, `sums` to elements.
    """
    return StepEntry("withdraw_dashpots", (moving, beams, dashpots, candidates, postponed))


#: Passes `judge_beams_by_…` by the name of their criterion.
JUDGE_BEAMS_BY = {
    "elliptic": judge_beams_by_elliptic,
    "linear_sum": judge_beams_by_linear_sum,
    "mohr_coulomb": judge_beams_by_mohr_coulomb,
    "peripheral_stress": judge_beams_by_peripheral_stress,
}
