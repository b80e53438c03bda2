"""Passes that steps are composed of, of `core/passes/damage`; written by `python -m tests.core.passes`."""

from bondem._passes import StepEntry
from bondem._tables.beam_softening_tables import SofteningBeams, SofteningBounds
from bondem._tables.damage_tables import (
    BeamIntegrity,
    Candidates,
    EventLog,
    Postponed,
    Strengths,
    StressCandidates,
    StressFunction,
)
from bondem._tables.step_tables import Beams, Dashpots, HistoryRows, Moving, Portions, Rows, StepCut


def begin_softening(
    candidates: Candidates, softening_bounds: SofteningBounds, softening_beams: SofteningBeams, event_log:
    EventLog
) -> StepEntry:
    """Writes the rows of beams that have begun to soften in this step, and adds up their dissipation.

    Over what begins, changes or ends in the step, in order.
    """
    return StepEntry("begin_softening", (candidates, softening_bounds, softening_beams, event_log))


def break_beams(
    moving: Moving, beams: Beams, beam_integrity: BeamIntegrity, candidates: Candidates, postponed: Postponed,
    event_log: EventLog
) -> StepEntry:
    """Removes the beams that fail.

    Over what begins, changes or ends in the step, in order. Reads `pose` at both ends, of elements that are
    postponed; adds `kept` to elements.
    """
    return StepEntry("break_beams", (moving, beams, beam_integrity, candidates, postponed, event_log))


def index_candidates_by_cone(stress_candidates: StressCandidates, stress_function: StressFunction) -> StepEntry:
    """Finds the index of each candidate by a criterion on its stress.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("index_candidates_by_cone", (stress_candidates, stress_function))


def index_candidates_by_function(stress_candidates: StressCandidates, stress_function: StressFunction) -> StepEntry:
    """Finds the index of each candidate by a criterion on its stress.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("index_candidates_by_function", (stress_candidates, stress_function))


def index_candidates_by_mean_stress(
    stress_candidates: StressCandidates, stress_function: StressFunction
) -> StepEntry:
    """Finds the index of each candidate by a criterion on its stress.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("index_candidates_by_mean_stress", (stress_candidates, stress_function))


def judge_beams_by_elliptic(
    moving: Moving, beams: Beams, strengths: Strengths, candidates: Candidates, postponed: Postponed
) -> StepEntry:
    """Evaluates marked beams of a block by a criterion, and postpones the elements of failed ones.

    Over bonds of a block. Reads `pose` at both ends; adds `held` to elements.
    """
    return StepEntry("judge_beams_by_elliptic", (moving, beams, strengths, candidates, postponed))


def judge_beams_by_linear_sum(
    moving: Moving, beams: Beams, strengths: Strengths, candidates: Candidates, postponed: Postponed
) -> StepEntry:
    """Evaluates marked beams of a block by a criterion, and postpones the elements of failed ones.

    Over bonds of a block. Reads `pose` at both ends; adds `held` to elements.
    """
    return StepEntry("judge_beams_by_linear_sum", (moving, beams, strengths, candidates, postponed))


def judge_beams_by_mohr_coulomb(
    moving: Moving, beams: Beams, strengths: Strengths, candidates: Candidates, postponed: Postponed
) -> StepEntry:
    """Evaluates marked beams of a block by a criterion, and postpones the elements of failed ones.

    Over bonds of a block. Reads `pose` at both ends; adds `held` to elements.
    """
    return StepEntry("judge_beams_by_mohr_coulomb", (moving, beams, strengths, candidates, postponed))


def judge_beams_by_peripheral_stress(
    moving: Moving, beams: Beams, strengths: Strengths, candidates: Candidates, postponed: Postponed
) -> StepEntry:
    """Evaluates marked beams of a block by a criterion, and postpones the elements of failed ones.

    Over bonds of a block. Reads `pose` at both ends; adds `held` to elements.
    """
    return StepEntry("judge_beams_by_peripheral_stress", (moving, beams, strengths, candidates, postponed))


def keep_dashpots(dashpots: Dashpots, postponed: Postponed) -> StepEntry:
    """Keeps the sums of the dashpots of postponed elements.

    Over postponed elements of a block. Reads `held` of an element; changes `sums` of an element.
    """
    return StepEntry("keep_dashpots", (dashpots, postponed))


def keep_sums(step_cut: StepCut, postponed: Postponed) -> StepEntry:
    """Keeps the sums of postponed elements.

    Over postponed elements of a block. Reads `held`, `sums` of an element; changes `kept` of an element.
    """
    return StepEntry("keep_sums", (step_cut, postponed))


def list_postponed(rows: Rows, candidates: Candidates, postponed: Postponed) -> StepEntry:
    """Lists all postponed elements, those with rows of the boundary last, and ends the failures of the step.

    Over elements of a block, which it divides. Writes `held` of an element.
    """
    return StepEntry("list_postponed", (rows, candidates, postponed))


def log_softened_beams(
    moving: Moving, beams: Beams, softening_beams: SofteningBeams, event_log: EventLog
) -> StepEntry:
    """Adds up the dissipation of all portions, and logs broken beams.

    Over what begins, changes or ends in the step, in order. Reads `pose` at both ends.
    """
    return StepEntry("log_softened_beams", (moving, beams, softening_beams, event_log))


def postpone_elements(step_cut: StepCut, candidates: Candidates, postponed: Postponed) -> StepEntry:
    """Divides the elements of a block, or shared ones, into those that continue and those that are postponed.

    Over elements of a block, which it divides.
    """
    return StepEntry("postpone_elements", (step_cut, candidates, postponed))


def soften_beams(
    moving: Moving, beams: Beams, softening_bounds: SofteningBounds, softening_beams: SofteningBeams
) -> StepEntry:
    """Lowers the integrity of beams of a portion that soften, before the forces.

    Over bonds, in portions. Reads `motion`, `pose` at both ends.
    """
    return StepEntry("soften_beams", (moving, beams, softening_bounds, softening_beams))


def sum_pressed_energies(
    moving: Moving, beams: Beams, softening_bounds: SofteningBounds, portions: Portions
) -> StepEntry:
    """Adds the energy of the pressure on softened beams of a portion to their normal energy.

    Over bonds, in portions. Reads `pose` at both ends.
    """
    return StepEntry("sum_pressed_energies", (moving, beams, softening_bounds, portions))


def withdraw_dashpots(
    moving: Moving, beams: Beams, dashpots: Dashpots, candidates: Candidates, postponed: Postponed
) -> StepEntry:
    """Subtracts dashpots of failed beams from the kept sums of their ends, before the beams are removed.

    Over what begins, changes or ends in the step, in order. Reads `motion` at both ends; reads `pose` at both
    ends, of elements that are postponed; adds `kept`, `sums` to elements.
    """
    return StepEntry("withdraw_dashpots", (moving, beams, dashpots, candidates, postponed))


def write_crushing_of_beams(
    softening_bounds: SofteningBounds, softening_beams: SofteningBeams, event_log: EventLog, history_rows:
    HistoryRows
) -> StepEntry:
    """Writes the energy that beams have released beyond their fracture energy.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("write_crushing_of_beams", (softening_bounds, softening_beams, event_log, history_rows))


def write_released(event_log: EventLog, history_rows: HistoryRows) -> StepEntry:
    """Writes the energy released into a record.

    Over numbers that a body has once, such as those of a record.
    """
    return StepEntry("write_released", (event_log, history_rows))


#: Passes `index_candidates_by_…` by the name of their criterion.
INDEX_CANDIDATES_BY = {
    "cone": index_candidates_by_cone,
    "function": index_candidates_by_function,
    "mean_stress": index_candidates_by_mean_stress,
}
#: Passes `judge_beams_by_…` by the name of their criterion.
JUDGE_BEAMS_BY = {
    "elliptic": judge_beams_by_elliptic,
    "linear_sum": judge_beams_by_linear_sum,
    "mohr_coulomb": judge_beams_by_mohr_coulomb,
    "peripheral_stress": judge_beams_by_peripheral_stress,
}
