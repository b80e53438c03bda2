"""Passes that steps are composed of, of `core/passes/contacts`; written by `python -m tests.core.passes`."""

from bondem._passes import StepEntry
from bondem._tables.beam_softening_tables import SofteningBounds
from bondem._tables.contact_tables import (
    AdheringPairs,
    ContactConstants,
    ContactEnergies,
    ContactPairs,
    ContactSums,
    FacePairs,
    NearPairs,
    RolledPairs,
    RolledWalls,
    Travel,
    WallContacts,
    WallMotions,
    Walls,
)
from bondem._tables.crack_tables import CohesiveCracks, CrackLists, PartedReach
from bondem._tables.damage_tables import EventLog, Postponed
from bondem._tables.step_tables import Gauges, HistoryRows, Moving, Portions, StepCut


def add_adhesion_loads(
    contact_pairs: ContactPairs, near_pairs: NearPairs, adhering_pairs: AdheringPairs, contact_sums: ContactSums
) -> StepEntry:
    """Adds adhesion to the elements of a range.

    Over elements, in a range a thread. Adds `sums` to elements.
    """
    return StepEntry("add_adhesion_loads", (contact_pairs, near_pairs, adhering_pairs, contact_sums))


def add_contact_loads(moving: Moving, step_cut: StepCut, contact_sums: ContactSums) -> StepEntry:
    """Adds forces and losses of contacts to those of the elements, and sets the former to zero.

    Over elements of a block, then shared ones. Changes `ContactSums.sums`, `StepCut.sums`, `loss` of an
    element.
    """
    return StepEntry("add_contact_loads", (moving, step_cut, contact_sums))


def add_face_loads(contact_pairs: ContactPairs, face_pairs: FacePairs, contact_sums: ContactSums) -> StepEntry:
    """Adds forces of faces to the elements of a range.

    Over elements, in a range a thread. Adds `sums` to elements.
    """
    return StepEntry("add_face_loads", (contact_pairs, face_pairs, contact_sums))


def add_pair_loads(
    contact_constants: ContactConstants, contact_pairs: ContactPairs, near_pairs: NearPairs, contact_sums:
    ContactSums
) -> StepEntry:
    """Adds forces of pairs to the elements of a range, in the order of the pairs.

    Over elements, in a range a thread. Adds `sums` to elements.
    """
    return StepEntry("add_pair_loads", (contact_constants, contact_pairs, near_pairs, contact_sums))


def add_rolling_loads(
    contact_pairs: ContactPairs, near_pairs: NearPairs, rolled_pairs: RolledPairs, contact_sums: ContactSums
) -> StepEntry:
    """Adds moments of resistance to rolling to the elements of a range.

    Over elements, in a range a thread. Adds `sums` to elements.
    """
    return StepEntry("add_rolling_loads", (contact_pairs, near_pairs, rolled_pairs, contact_sums))


def adhere_at_walls(
    moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts, walls: Walls, contact_sums:
    ContactSums
) -> StepEntry:
    """Finds the adhesion of a portion of elements at walls.

    Over elements, in portions. Reads `pose` of an element; changes `sums` of an element.
    """
    return StepEntry("adhere_at_walls", (moving, contact_constants, wall_contacts, walls, contact_sums))


def adhere_pairs(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, near_pairs: NearPairs,
    adhering_pairs: AdheringPairs
) -> StepEntry:
    """Finds the adhesion of the near pairs of a portion of elements.

    Over elements, in portions. Reads `pose` at both ends.
    """
    return StepEntry("adhere_pairs", (moving, contact_constants, contact_pairs, near_pairs, adhering_pairs))


def begin_contacts(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, near_pairs: NearPairs,
    event_log: EventLog, postponed: Postponed
) -> StepEntry:
    """Begins contact where beams have broken in this step, on the sums that are kept for their ends.

    Over what begins, changes or ends in the step, in order. Reads `motion` at both ends; reads `pose` at both
    ends, of elements that are postponed; adds `kept` to elements.
    """
    return StepEntry("begin_contacts", (moving, contact_constants, contact_pairs, near_pairs, event_log, postponed))


def begin_face_contacts(
    moving: Moving, contact_pairs: ContactPairs, near_pairs: NearPairs, face_pairs: FacePairs, crack_lists:
    CrackLists, event_log: EventLog
) -> StepEntry:
    """Begins the contact of faces that part in this step.

    Over what begins, changes or ends in the step, in order.
    """
    return StepEntry("begin_face_contacts", (moving, contact_pairs, near_pairs, face_pairs, crack_lists, event_log))


def begin_softened_contacts(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, near_pairs: NearPairs,
    event_log: EventLog, contact_sums: ContactSums
) -> StepEntry:
    """Begins contact where softening beams have broken at the beginning of this step.

    Over what begins, changes or ends in the step, in order. Reads `motion`, `pose` at both ends; adds `sums` to
    elements.
    """
    return StepEntry("begin_softened_contacts", (
        moving, contact_constants, contact_pairs, near_pairs, event_log, contact_sums
    ))


def check_travel(travel: Travel, walls: Walls, portions: Portions) -> StepEntry:
    """Finds whether the list may miss a contact by now, also where a centre is not a number.

    Over numbers that a body has once, such as those of a record.
    """
    return StepEntry("check_travel", (travel, walls, portions))


def count_wall_work(walls: Walls, portions: Portions) -> StepEntry:
    """Finds the work supplied by walls, for the guard of the energy.

    Over numbers that a body has once, such as those of a record.
    """
    return StepEntry("count_wall_work", (walls, portions))


def keep_measures(near_pairs: NearPairs, travel: Travel) -> StepEntry:
    """Stores distances that were measured in a step.

    Over numbers that a body has once, such as those of a record.
    """
    return StepEntry("keep_measures", (near_pairs, travel))


def load_walls(wall_contacts: WallContacts, wall_motions: WallMotions, walls: Walls) -> StepEntry:
    """Sums the forces of elements on walls, adds their work, and closes the step of free walls.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("load_walls", (wall_contacts, wall_motions, walls))


def measure_travel(moving: Moving, travel: Travel) -> StepEntry:
    """Finds the distances of the elements of a portion from their places at the last measurement.

    Over elements, in portions.
    """
    return StepEntry("measure_travel", (moving, travel))


def measure_wall_overlaps(
    moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts, walls: Walls, near_pairs:
    NearPairs, travel: Travel
) -> StepEntry:
    """Keeps the deepest overlap of the elements of a portion with a wall, over the radius, if distances are
    measured in this step.

    Over elements, in portions.
    """
    return StepEntry("measure_wall_overlaps", (moving, contact_constants, wall_contacts, walls, near_pairs, travel))


def move_walls(wall_motions: WallMotions, walls: Walls) -> StepEntry:
    """Moves walls to the end of the step that begins at the time of the clock.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("move_walls", (wall_motions, walls))


def press_pairs(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, near_pairs: NearPairs,
    travel: Travel
) -> StepEntry:
    """Finds forces and memory of the pairs of a portion of elements; renews the list of near pairs where elements
    have moved too far.

    Over elements, in portions. Reads `motion`, `pose` at both ends; writes `measured` of an element.
    """
    return StepEntry("press_pairs", (moving, contact_constants, contact_pairs, near_pairs, travel))


def press_pairs_and_faces(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, near_pairs: NearPairs,
    travel: Travel, face_pairs: FacePairs
) -> StepEntry:
    """Finds forces and memory of the pairs of a portion of cells with cracks, which touch by faces too.

    Over elements, in portions. Reads `faced`, `motion`, `pose` at both ends; writes `measured` of an element.
    """
    return StepEntry("press_pairs_and_faces", (
        moving, contact_constants, contact_pairs, near_pairs, travel, face_pairs
    ))


def press_walls(
    moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts, walls: Walls, contact_sums:
    ContactSums
) -> StepEntry:
    """Adds forces of walls to the elements of a portion, and keeps their memory.

    Over elements, in portions. Reads `motion`, `pose` of an element; changes `sums` of an element.
    """
    return StepEntry("press_walls", (moving, contact_constants, wall_contacts, walls, contact_sums))


def release_pressure(event_log: EventLog, softening_bounds: SofteningBounds) -> StepEntry:
    """Ends the pressure on softening beams that have broken at the beginning of this step.

    Over what begins, changes or ends in the step, in order.
    """
    return StepEntry("release_pressure", (event_log, softening_bounds))


def roll_at_walls(
    moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts, walls: Walls, rolled_walls:
    RolledWalls, contact_sums: ContactSums
) -> StepEntry:
    """Finds moments of resistance to rolling of a portion of elements at walls.

    Over elements, in portions. Reads `motion` of an element; changes `sums` of an element.
    """
    return StepEntry("roll_at_walls", (moving, contact_constants, wall_contacts, walls, rolled_walls, contact_sums))


def roll_pairs(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, near_pairs: NearPairs,
    rolled_pairs: RolledPairs
) -> StepEntry:
    """Finds moments and memory of the pairs of a portion of elements that touch and may roll.

    Over elements, in portions. Reads `motion`, `pose` at both ends.
    """
    return StepEntry("roll_pairs", (moving, contact_constants, contact_pairs, near_pairs, rolled_pairs))


def sum_adhesion_at_walls(
    moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts, walls: Walls,
    contact_energies: ContactEnergies
) -> StepEntry:
    """Adds the energy of adhesion at walls of a portion of elements, below 0 [J].

    Over elements, in portions.
    """
    return StepEntry("sum_adhesion_at_walls", (moving, contact_constants, wall_contacts, walls, contact_energies))


def sum_adhesion_energies(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, contact_energies:
    ContactEnergies
) -> StepEntry:
    """Adds the energy of adhesion of the pairs of a portion, below 0 [J].

    Over elements, in portions.
    """
    return StepEntry("sum_adhesion_energies", (moving, contact_constants, contact_pairs, contact_energies))


def sum_face_energies(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, face_pairs: FacePairs,
    contact_energies: ContactEnergies
) -> StepEntry:
    """Adds the elastic energy of the pairs of a portion that touch by faces [J].

    Over elements, in portions.
    """
    return StepEntry("sum_face_energies", (moving, contact_constants, contact_pairs, face_pairs, contact_energies))


def sum_pair_energies(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, contact_energies:
    ContactEnergies
) -> StepEntry:
    """Sums the elastic energy of the pairs of a portion [J].

    Over elements, in portions.
    """
    return StepEntry("sum_pair_energies", (moving, contact_constants, contact_pairs, contact_energies))


def sum_rolling_at_walls(
    contact_constants: ContactConstants, wall_contacts: WallContacts, rolled_walls: RolledWalls, contact_energies:
    ContactEnergies
) -> StepEntry:
    """Adds the energy that springs of rolling store at walls, of a portion of elements [J].

    Over elements, in portions.
    """
    return StepEntry("sum_rolling_at_walls", (contact_constants, wall_contacts, rolled_walls, contact_energies))


def sum_rolling_energies(
    contact_constants: ContactConstants, contact_pairs: ContactPairs, rolled_pairs: RolledPairs, contact_energies:
    ContactEnergies
) -> StepEntry:
    """Adds the energy that springs of rolling store in the pairs of a portion [J].

    Over elements, in portions.
    """
    return StepEntry("sum_rolling_energies", (contact_constants, contact_pairs, rolled_pairs, contact_energies))


def sum_wall_energies(
    moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts, walls: Walls,
    contact_energies: ContactEnergies
) -> StepEntry:
    """Adds the elastic energy of contacts of a portion with walls [J].

    Over elements, in portions.
    """
    return StepEntry("sum_wall_energies", (moving, contact_constants, wall_contacts, walls, contact_energies))


def touch_parted_faces(
    moving: Moving, contact_pairs: ContactPairs, near_pairs: NearPairs, cohesive_cracks: CohesiveCracks,
    crack_lists: CrackLists, parted_reach: PartedReach
) -> StepEntry:
    """Makes pairs of the cells whose faces have parted in this step.

    Over what begins, changes or ends in the step, in order. Reads `pose` at both ends.
    """
    return StepEntry("touch_parted_faces", (
        moving, contact_pairs, near_pairs, cohesive_cracks, crack_lists, parted_reach
    ))


def write_contact_energy(contact_energies: ContactEnergies, history_rows: HistoryRows) -> StepEntry:
    """Adds the energy of contacts to a record.

    Over numbers that a body has once, such as those of a record.
    """
    return StepEntry("write_contact_energy", (contact_energies, history_rows))


def write_walls(walls: Walls, gauges: Gauges, history_rows: HistoryRows) -> StepEntry:
    """Adds the work of walls to a record, and writes gauges of walls.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("write_walls", (walls, gauges, history_rows))
