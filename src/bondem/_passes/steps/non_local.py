"""Passes that steps are composed of, of `core/passes/non_local`; written by `python -m tests.core.passes`."""

from bondem._passes import StepEntry
from bondem._tables.contact_tables import ContactConstants, ContactPairs, NearPairs, WallContacts, Walls
from bondem._tables.damage_tables import BeamIntegrity, Candidates, EventLog, Postponed, Strengths
from bondem._tables.non_local_tables import NonLocalBonds, NonLocalWork
from bondem._tables.step_tables import Beams, HistoryRows, LaggedStresses, Moving, Portions, StepCut


def add_begun_contacts(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, lagged_stresses:
    LaggedStresses, event_log: EventLog
) -> StepEntry:
    """Adds new contacts to the stresses of the ends of bonds that have failed in this step, after these contacts
    have begun.

    Over what begins, changes or ends in the step, in order. Reads `motion` at both ends; reads `pose` at both
    ends, of elements that are postponed; adds `stress` to elements.
    """
    return StepEntry("add_begun_contacts", (moving, contact_constants, contact_pairs, lagged_stresses, event_log))


def add_lasting_loads(
    moving: Moving, beams: Beams, non_local_bonds: NonLocalBonds, lagged_stresses: LaggedStresses, step_cut:
    StepCut
) -> StepEntry:
    """Finds and adds forces and torques of bonds that cannot fail, without keeping them.

    Over bonds of a block. Reads `pose`, `space` at both ends; adds `moment`, `sums` to elements.
    """
    return StepEntry("add_lasting_loads", (moving, beams, non_local_bonds, lagged_stresses, step_cut))


def add_non_local_loads(non_local_bonds: NonLocalBonds, step_cut: StepCut) -> StepEntry:
    """Adds forces and torques of the bonds to the sums of the elements, in the order of the bonds.

    Over bonds of a block. Adds `sums` to elements.
    """
    return StepEntry("add_non_local_loads", (non_local_bonds, step_cut))


def add_pair_moments(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, near_pairs: NearPairs,
    lagged_stresses: LaggedStresses
) -> StepEntry:
    """Adds contacts of pairs to the stresses of the elements of a range, in the order of the pairs.

    Over elements, in a range a thread. Reads `pose` at both ends; adds `moment` to elements.
    """
    return StepEntry("add_pair_moments", (moving, contact_constants, contact_pairs, near_pairs, lagged_stresses))


def add_wall_moments(
    moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts, walls: Walls,
    lagged_stresses: LaggedStresses
) -> StepEntry:
    """Adds contacts with walls to the stresses of the elements of a portion.

    Over elements, in portions. Reads `pose` of an element; changes `moment` of an element.
    """
    return StepEntry("add_wall_moments", (moving, contact_constants, wall_contacts, walls, lagged_stresses))


def break_pairs(
    moving: Moving, beams: Beams, non_local_bonds: NonLocalBonds, candidates: Candidates, postponed: Postponed,
    event_log: EventLog
) -> StepEntry:
    """Removes the bonds that fail: their force from the kept sums, and the energy of their springs.

    Over what begins, changes or ends in the step, in order. Reads `pose` at both ends, of elements that are
    postponed; adds `kept` to elements.
    """
    return StepEntry("break_pairs", (moving, beams, non_local_bonds, candidates, postponed, event_log))


def collect_moments(step_cut: StepCut, lagged_stresses: LaggedStresses) -> StepEntry:
    """Adds moments of bonds of other domains to the stresses of shared elements, and sets their rows to zero.

    Over elements that domains share. Changes `moment` of an element.
    """
    return StepEntry("collect_moments", (step_cut, lagged_stresses))


def find_non_local_forces(
    moving: Moving, beams: Beams, non_local_bonds: NonLocalBonds, lagged_stresses: LaggedStresses
) -> StepEntry:
    """Finds forces and torques of the bonds of a block, integrates their stored values over the step, and adds
    their moments to the stresses of their elements.

    Over bonds of a block. Reads `pose`, `space` at both ends; adds `moment` to elements.
    """
    return StepEntry("find_non_local_forces", (moving, beams, non_local_bonds, lagged_stresses))


def find_stresses(moving: Moving, lagged_stresses: LaggedStresses) -> StepEntry:
    """Finds the stresses of a portion of elements, and bounds of their principal stresses; sets the moments to
    zero.

    Over elements, in portions. Reads `pose` of an element; changes `moment` of an element; writes `space`,
    `stress` of an element.
    """
    return StepEntry("find_stresses", (moving, lagged_stresses))


def find_stresses_of_block(moving: Moving, lagged_stresses: LaggedStresses) -> StepEntry:
    """Finds the stresses of the elements of a block, and bounds of their principal stresses; sets the moments to
    zero.

    Over elements of a block, then shared ones. Reads `pose` of an element; changes `moment` of an element;
    writes `space`, `stress` of an element.
    """
    return StepEntry("find_stresses_of_block", (moving, lagged_stresses))


def judge_pairs(
    beams: Beams, lagged_stresses: LaggedStresses, strengths: Strengths, candidates: Candidates, postponed:
    Postponed
) -> StepEntry:
    """Evaluates marked bonds of a block, and postpones the elements of failed ones.

    Over bonds of a block. Reads `space` at both ends; adds `held` to elements.
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
    """Subtracts the force of failed bonds from the stresses of their elements, and sets their integrity to 0;
    after `break_pairs`.

    Over what begins, changes or ends in the step, in order. Reads `pose` of an element; adds `stress` to
    elements.
    """
    return StepEntry("relieve_pairs", (moving, beams, non_local_bonds, lagged_stresses, beam_integrity, candidates))


def sum_non_local_energies(
    moving: Moving, beams: Beams, non_local_bonds: NonLocalBonds, portions: Portions, non_local_work: NonLocalWork
) -> StepEntry:
    """Sums normal and shear energy of the springs of a portion, and the work of extra forces [J].

    Over bonds, in portions. Reads `pose` at both ends.
    """
    return StepEntry("sum_non_local_energies", (moving, beams, non_local_bonds, portions, non_local_work))


def turn_stresses(moving: Moving, lagged_stresses: LaggedStresses) -> StepEntry:
    """Turns the stresses of a step ago with their elements.

    Over elements, in portions. Reads `pose`, `stress` of an element; writes `space` of an element.
    """
    return StepEntry("turn_stresses", (moving, lagged_stresses))


def write_non_local_work(non_local_work: NonLocalWork, history_rows: HistoryRows) -> StepEntry:
    """Writes the work of the extra forces of bonds to the energy balance.

    Over numbers that a body has once, such as those of a record.
    """
    return StepEntry("write_non_local_work", (non_local_work, history_rows))
