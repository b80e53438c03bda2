"""Passes over an index, for devices, of `core/gpu/non_local_pairs.hpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Kernel
from bondem._tables.contact_tables import ContactConstants, ContactPairs, NearPairs, WallContacts, Walls
from bondem._tables.damage_tables import BeamIntegrity, Candidates, EventLog, Postponed, Strengths
from bondem._tables.device_tables import BondMarks, BondsOfElements, DeviceSpan, EarlierPairs, LoadsOfBonds
from bondem._tables.non_local_tables import NonLocalBonds
from bondem._tables.step_tables import Beams, LaggedStresses, Ledger, Moving


def add_all_new_contacts(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs,
    lagged_stresses: LaggedStresses, event_log: EventLog
) -> Kernel:
    """Adds new contacts to the stresses of the ends of bonds that have failed in this step, after these contacts
    have begun.

    Over one index.
    """
    return Kernel("add_all_new_contacts", (
        device_span, moving, contact_constants, contact_pairs, lagged_stresses, event_log
    ))


def add_pair_moments_of_element(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, earlier_pairs: EarlierPairs,
    near_pairs: NearPairs, lagged_stresses: LaggedStresses
) -> Kernel:
    """Adds the pairs of element p to its stress: as the later element of a pair, then as the earlier one."""
    return Kernel("add_pair_moments_of_element", (
        moving, contact_constants, contact_pairs, earlier_pairs, near_pairs, lagged_stresses
    ))


def add_wall_moments_of_element(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts,
    walls: Walls, lagged_stresses: LaggedStresses
) -> Kernel:
    """Adds contacts with walls to the stresses of the elements of a portion.

    Over one index.
    """
    return Kernel("add_wall_moments_of_element", (
        device_span, moving, contact_constants, wall_contacts, walls, lagged_stresses
    ))


def end_failing_pair(non_local_bonds: NonLocalBonds, beam_integrity: BeamIntegrity, candidates: Candidates) -> Kernel:
    """Launched for `relieve_pairs`: subtracts failed bonds from the stresses of their elements, and sets their
    integrity to 0; after `break_pairs`.

    Over one index.
    """
    return Kernel("end_failing_pair", (non_local_bonds, beam_integrity, candidates))


def find_force_of_pair(
    device_span: DeviceSpan, moving: Moving, beams: Beams, non_local_bonds: NonLocalBonds, lagged_stresses:
    LaggedStresses, loads_of_bonds: LoadsOfBonds
) -> Kernel:
    """Pass of one index, defined in `core/gpu/non_local_pairs.hpp`."""
    return Kernel("find_force_of_pair", (
        device_span, moving, beams, non_local_bonds, lagged_stresses, loads_of_bonds
    ))


def find_stress_of_element(moving: Moving, lagged_stresses: LaggedStresses) -> Kernel:
    """Pass of one index, defined in `core/gpu/non_local_pairs.hpp`."""
    return Kernel("find_stress_of_element", (moving, lagged_stresses))


def gather_moments(
    moving: Moving, non_local_bonds: NonLocalBonds, bonds_of_elements: BondsOfElements, lagged_stresses:
    LaggedStresses
) -> Kernel:
    """Pass of one index, defined in `core/gpu/non_local_pairs.hpp`."""
    return Kernel("gather_moments", (moving, non_local_bonds, bonds_of_elements, lagged_stresses))


def judge_pair(
    device_span: DeviceSpan, beams: Beams, lagged_stresses: LaggedStresses, strengths: Strengths, bond_marks:
    BondMarks, candidates: Candidates, postponed: Postponed
) -> Kernel:
    """Launched for `judge_pairs`: evaluates marked bonds of a block, and postpones the elements of failed bonds.

    Over one index.
    """
    return Kernel("judge_pair", (device_span, beams, lagged_stresses, strengths, bond_marks, candidates, postponed))


def relieve_element(
    moving: Moving, non_local_bonds: NonLocalBonds, bonds_of_elements: BondsOfElements, bond_marks: BondMarks,
    lagged_stresses: LaggedStresses, candidates: Candidates
) -> Kernel:
    """Launched for `relieve_pairs`: subtracts failed bonds from the stresses of their elements, and sets their
    integrity to 0; after `break_pairs`.

    Over one index.
    """
    return Kernel("relieve_element", (
        moving, non_local_bonds, bonds_of_elements, bond_marks, lagged_stresses, candidates
    ))


def sum_portion_of_springs(
    device_span: DeviceSpan, moving: Moving, beams: Beams, non_local_bonds: NonLocalBonds, ledger: Ledger
) -> Kernel:
    """Sums normal and shear energy of the springs of a portion of bonds, and the work of their extra forces [J].

    Over one index.
    """
    return Kernel("sum_portion_of_springs", (device_span, moving, beams, non_local_bonds, ledger))


def take_pairs_off_element(
    non_local_bonds: NonLocalBonds, bonds_of_elements: BondsOfElements, bond_marks: BondMarks, candidates:
    Candidates, postponed: Postponed
) -> Kernel:
    """Launched for `break_pairs`: removes the bonds that fail: their force from the kept sums, and the energy of
    their springs.

    Over one index.
    """
    return Kernel("take_pairs_off_element", (non_local_bonds, bonds_of_elements, bond_marks, candidates, postponed))


def turn_stress_of_element(moving: Moving, lagged_stresses: LaggedStresses) -> Kernel:
    """Turns the stresses of a step ago with their elements.

    Over one index.
    """
    return Kernel("turn_stress_of_element", (moving, lagged_stresses))


def write_pair_failure(
    device_span: DeviceSpan, moving: Moving, beams: Beams, non_local_bonds: NonLocalBonds, candidates: Candidates,
    event_log: EventLog
) -> Kernel:
    """Launched for `break_pairs`: removes the bonds that fail: their force from the kept sums, and the energy of
    their springs.

    Over one index.
    """
    return Kernel("write_pair_failure", (device_span, moving, beams, non_local_bonds, candidates, event_log))
