"""Passes that steps are composed of, of `core/passes/non_local/pair_failure.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.damage_tables import BeamIntegrity, Candidates, EventLog, Postponed, Strengths
from bondem._tables.non_local_tables import NonLocalBonds
from bondem._tables.step_tables import Beams, LaggedStresses, Moving


def break_pairs(
    moving: Moving, beams: Beams, non_local_bonds: NonLocalBonds, candidates: Candidates, postponed: Postponed,
    event_log: EventLog
) -> StepEntry:
    """Removes the bonds that fail: their force from the kept sums, and the energy of their springs.

    Over events of the step, such as failures, in their order. Reads `pose` at both ends, of elements that are
    postponed; adds `sum` to elements.
    """
    return StepEntry("break_pairs", (moving, beams, non_local_bonds, candidates, postponed, event_log))


def judge_pairs(
    beams: Beams, lagged_stresses: LaggedStresses, strengths: Strengths, candidates: Candidates, postponed:
    Postponed
) -> StepEntry:
    """Evaluates marked bonds of a block, and postpones the elements of failed bonds.

    Over bonds of a block. Reads `space` at both ends; adds `flag` to elements.
    """
    return StepEntry("judge_pairs", (beams, lagged_stresses, strengths, candidates, postponed))


def mark_pairs(
    beams: Beams, lagged_stresses: LaggedStresses, strengths: Strengths, candidates: Candidates
) -> StepEntry:
    """Marks the bonds of a block that reach their criterion by bounds of the principal stresses of both elements.

    Over bonds of a block. Reads `space` at both ends.
    """
    return StepEntry("mark_pairs", (beams, lagged_stresses, strengths, candidates))


def relieve_pairs(
    moving: Moving, beams: Beams, non_local_bonds: NonLocalBonds, lagged_stresses: LaggedStresses, beam_integrity:
    BeamIntegrity, candidates: Candidates
) -> StepEntry:
    """Subtracts failed bonds from the stresses of their elements, and sets their integrity to 0; after
    `break_pairs`.

    Over events of the step, such as failures, in their order. Reads `pose` of an element; adds `stress` to
    elements.
    """
    return StepEntry("relieve_pairs", (moving, beams, non_local_bonds, lagged_stresses, beam_integrity, candidates))
