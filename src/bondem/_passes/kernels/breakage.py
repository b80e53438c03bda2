"""Passes over an index, for devices, of `core/gpu/breakage.hpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Kernel
from bondem._tables.damage_tables import BeamIntegrity, Candidates, EventLog, FailureBounds, Postponed, Strengths
from bondem._tables.device_tables import BondMarks, BondsOfElements, DeviceSpan, LoadsOfBonds
from bondem._tables.step_tables import (
    Beams,
    BodyForces,
    Dashpots,
    HistoryRows,
    Moving,
    Resistance,
    Rows,
    StepBlocks,
    UniformBeams,
)


def count_failures(candidates: Candidates, event_log: EventLog) -> Kernel:
    """Counts the events of a step, and adds up their released energies."""
    return Kernel("count_failures", (candidates, event_log))


def end_all_failures(candidates: Candidates) -> Kernel:
    """Pass of one index, defined in `core/gpu/breakage.hpp`."""
    return Kernel("end_all_failures", (candidates,))


def judge_beam_by_elliptic(
    device_span: DeviceSpan, moving: Moving, beams: Beams, strengths: Strengths, bond_marks: BondMarks,
    candidates: Candidates, postponed: Postponed
) -> Kernel:
    """Launched for `judge_beams`: evaluates marked beams of a block by a criterion, and postpones the elements of
    failed beams.

    Over one index.
    """
    return Kernel("judge_beam_by_elliptic", (
        device_span, moving, beams, strengths, bond_marks, candidates, postponed
    ))


def judge_beam_by_linear_sum(
    device_span: DeviceSpan, moving: Moving, beams: Beams, strengths: Strengths, bond_marks: BondMarks,
    candidates: Candidates, postponed: Postponed
) -> Kernel:
    """Launched for `judge_beams`: evaluates marked beams of a block by a criterion, and postpones the elements of
    failed beams.

    Over one index.
    """
    return Kernel("judge_beam_by_linear_sum", (
        device_span, moving, beams, strengths, bond_marks, candidates, postponed
    ))


def judge_beam_by_mohr_coulomb(
    device_span: DeviceSpan, moving: Moving, beams: Beams, strengths: Strengths, bond_marks: BondMarks,
    candidates: Candidates, postponed: Postponed
) -> Kernel:
    """Launched for `judge_beams`: evaluates marked beams of a block by a criterion, and postpones the elements of
    failed beams.

    Over one index.
    """
    return Kernel("judge_beam_by_mohr_coulomb", (
        device_span, moving, beams, strengths, bond_marks, candidates, postponed
    ))


def judge_beam_by_peripheral_stress(
    device_span: DeviceSpan, moving: Moving, beams: Beams, strengths: Strengths, bond_marks: BondMarks,
    candidates: Candidates, postponed: Postponed
) -> Kernel:
    """Launched for `judge_beams`: evaluates marked beams of a block by a criterion, and postpones the elements of
    failed beams.

    Over one index.
    """
    return Kernel("judge_beam_by_peripheral_stress", (
        device_span, moving, beams, strengths, bond_marks, candidates, postponed
    ))


def keep_dashed_sum(step_blocks: StepBlocks, dashpots: Dashpots, postponed: Postponed) -> Kernel:
    """Keeps the sums of the dashpots of postponed elements.

    Over one index.
    """
    return Kernel("keep_dashed_sum", (step_blocks, dashpots, postponed))


def keep_gathered_sum(
    step_blocks: StepBlocks, bonds_of_elements: BondsOfElements, loads_of_bonds: LoadsOfBonds, postponed:
    Postponed
) -> Kernel:
    """Launched for `keep_sums`: copies the sums of postponed elements, which are kept until failed bonds are
    removed.

    Over one index.
    """
    return Kernel("keep_gathered_sum", (step_blocks, bonds_of_elements, loads_of_bonds, postponed))


def keep_sum(step_blocks: StepBlocks, postponed: Postponed) -> Kernel:
    """Launched for `keep_sums`: copies the sums of postponed elements, which are kept until failed bonds are
    removed.

    Over one index.
    """
    return Kernel("keep_sum", (step_blocks, postponed))


def load_failing_dashpot(
    moving: Moving, beams: Beams, dashpots: Dashpots, candidates: Candidates, loads_of_bonds: LoadsOfBonds
) -> Kernel:
    """Launched for `withdraw_dashpots`: subtracts dashpots of failed beams from the kept sums of their ends,
    before the beams are removed.

    Over one index.
    """
    return Kernel("load_failing_dashpot", (moving, beams, dashpots, candidates, loads_of_bonds))


def load_marked_beam(
    moving: Moving, beams: Beams, loads_of_bonds: LoadsOfBonds, failure_bounds: FailureBounds, bond_marks:
    BondMarks
) -> Kernel:
    """Adds forces and torques of the beams of a block, and marks beams near to failure.

    Over one index.
    """
    return Kernel("load_marked_beam", (moving, beams, loads_of_bonds, failure_bounds, bond_marks))


def load_marked_uniform_beam(
    moving: Moving, beams: Beams, uniform_beams: UniformBeams, loads_of_bonds: LoadsOfBonds, failure_bounds:
    FailureBounds, bond_marks: BondMarks
) -> Kernel:
    """Adds forces and torques of beams that differ in length only, and marks beams near to failure.

    Over one index.
    """
    return Kernel("load_marked_uniform_beam", (
        moving, beams, uniform_beams, loads_of_bonds, failure_bounds, bond_marks
    ))


def rank_failing(bond_marks: BondMarks, candidates: Candidates) -> Kernel:
    """Moves bond number e of the unordered list of failed bonds to its place in the order of bonds."""
    return Kernel("rank_failing", (bond_marks, candidates))


def release_element(candidates: Candidates, postponed: Postponed) -> Kernel:
    """Pass of one index, defined in `core/gpu/breakage.hpp`."""
    return Kernel("release_element", (candidates, postponed))


def remove_failing_beam(
    device_span: DeviceSpan, moving: Moving, beams: Beams, beam_integrity: BeamIntegrity, candidates: Candidates,
    event_log: EventLog, loads_of_bonds: LoadsOfBonds
) -> Kernel:
    """Removes the failed beam at place e of the order of bonds, and writes the loads that its ends lose."""
    return Kernel("remove_failing_beam", (
        device_span, moving, beams, beam_integrity, candidates, event_log, loads_of_bonds
    ))


def reopen_work_of_body(
    device_span: DeviceSpan, moving: Moving, body_forces: BodyForces, postponed: Postponed
) -> Kernel:
    """Pass of one index, defined in `core/gpu/breakage.hpp`."""
    return Kernel("reopen_work_of_body", (device_span, moving, body_forces, postponed))


def resume_free(device_span: DeviceSpan, moving: Moving, step_blocks: StepBlocks, postponed: Postponed) -> Kernel:
    """Pass of one index, defined in `core/gpu/breakage.hpp`."""
    return Kernel("resume_free", (device_span, moving, step_blocks, postponed))


def resume_resisted(
    device_span: DeviceSpan, moving: Moving, step_blocks: StepBlocks, resistance: Resistance, postponed: Postponed
) -> Kernel:
    """Pass of one index, defined in `core/gpu/breakage.hpp`."""
    return Kernel("resume_resisted", (device_span, moving, step_blocks, resistance, postponed))


def resume_resisted_row(
    device_span: DeviceSpan, moving: Moving, step_blocks: StepBlocks, rows: Rows, resistance: Resistance,
    postponed: Postponed
) -> Kernel:
    """Pass of one index, defined in `core/gpu/breakage.hpp`."""
    return Kernel("resume_resisted_row", (device_span, moving, step_blocks, rows, resistance, postponed))


def resume_row(
    device_span: DeviceSpan, moving: Moving, step_blocks: StepBlocks, rows: Rows, postponed: Postponed
) -> Kernel:
    """Pass of one index, defined in `core/gpu/breakage.hpp`."""
    return Kernel("resume_row", (device_span, moving, step_blocks, rows, postponed))


def take_beams_off_element(
    bonds_of_elements: BondsOfElements, bond_marks: BondMarks, loads_of_bonds: LoadsOfBonds, candidates:
    Candidates, postponed: Postponed
) -> Kernel:
    """Launched for `break_beams`: removes the beams that fail.

    Over one index.
    """
    return Kernel("take_beams_off_element", (bonds_of_elements, bond_marks, loads_of_bonds, candidates, postponed))


def take_dashpots_off_element(
    bonds_of_elements: BondsOfElements, bond_marks: BondMarks, loads_of_bonds: LoadsOfBonds, dashpots: Dashpots,
    candidates: Candidates, postponed: Postponed
) -> Kernel:
    """Subtracts dashpots of failed beams from the sums of element p: that of all forces, and that of dashpots
    alone.
    """
    return Kernel("take_dashpots_off_element", (
        bonds_of_elements, bond_marks, loads_of_bonds, dashpots, candidates, postponed
    ))


def write_released_energy(device_span: DeviceSpan, event_log: EventLog, history_rows: HistoryRows) -> Kernel:
    """Writes the energy released into a record.

    Over one index.
    """
    return Kernel("write_released_energy", (device_span, event_log, history_rows))


#: Passes `judge_beam_by_…` by the name of their criterion.
JUDGE_BEAM_BY = {
    "elliptic": judge_beam_by_elliptic,
    "linear_sum": judge_beam_by_linear_sum,
    "mohr_coulomb": judge_beam_by_mohr_coulomb,
    "peripheral_stress": judge_beam_by_peripheral_stress,
}
