"""Contacts of elements with each other and with walls: forces, motion of walls, energies, gauges, and their lists."""

import numpy as np

from bondem._cache_lines import lines
from bondem._core_steps import StepPass
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
from bondem._tables.non_local_tables import LaggedStresses
from bondem._tables.step_tables import Gauges, HistoryRows, Moving, Portions, StepCut
from bondem._types import Floats
from bondem.boundary.wall_rows import named_rows, no_rows, wall_rows
from bondem.dynamics.contact_check import ContactCheck, ListedContacts
from bondem.dynamics.cracked_faces import CrackedFaces
from bondem.dynamics.neighbour_list import ContactSearch, FoundContacts
from bondem.dynamics.parts.damage_part import Joints
from bondem.dynamics.parts.shared_tables import SharedTables
from bondem.interactions.contact.contact_model import ContactModel
from bondem.interactions.contact.contact_search import keep_wall_places, walls_at
from bondem.interactions.step_part import Part, Passes
from bondem.model.model import Model
from bondem.model.state import State

_move_walls = StepPass("move_walls", WallMotions, Walls)
_measure_travel = StepPass("measure_travel", Moving, Travel)
_check_travel = StepPass("check_travel", Travel, Walls, Portions)
_press_pairs = StepPass("press_pairs", Moving, ContactConstants, ContactPairs, NearPairs, Travel)
_add_pair_loads = StepPass("add_pair_loads", ContactConstants, ContactPairs, NearPairs, ContactSums)
_press_pairs_and_faces = StepPass(
    "press_pairs_and_faces", Moving, ContactConstants, ContactPairs, NearPairs, Travel, FacePairs
)
_add_face_loads = StepPass("add_face_loads", ContactPairs, FacePairs, ContactSums)
_sum_face_energies = StepPass(
    "sum_face_energies", Moving, ContactConstants, ContactPairs, FacePairs, ContactEnergies
)
_begin_face_contacts = StepPass(
    "begin_face_contacts", Moving, ContactPairs, NearPairs, FacePairs, CrackLists, EventLog
)
_press_walls = StepPass("press_walls", Moving, ContactConstants, WallContacts, Walls, ContactSums)
_measure_walls = StepPass("measure_wall_overlaps", Moving, ContactConstants, WallContacts, Walls, NearPairs, Travel)
_keep_measures = StepPass("keep_measures", NearPairs, Travel)
_load_walls = StepPass("load_walls", WallContacts, WallMotions, Walls)
_add_contact_loads = StepPass("add_contact_loads", Moving, StepCut, ContactSums)
_sum_pair_energies = StepPass("sum_pair_energies", Moving, ContactConstants, ContactPairs, ContactEnergies)
_sum_wall_energies = StepPass("sum_wall_energies", Moving, ContactConstants, WallContacts, Walls, ContactEnergies)
_write_contact_energy = StepPass("write_contact_energy", ContactEnergies, HistoryRows)
_count_wall_work = StepPass("count_wall_work", Walls, Portions)
_begin_contacts = StepPass(
    "begin_contacts", Moving, ContactConstants, ContactPairs, NearPairs, EventLog, Postponed
)
_release_pressure = StepPass("release_pressure", EventLog, SofteningBounds)
_begin_softened_contacts = StepPass(
    "begin_softened_contacts", Moving, ContactConstants, ContactPairs, NearPairs, EventLog, ContactSums
)
_touch_parted_faces = StepPass(
    "touch_parted_faces", Moving, ContactPairs, NearPairs, CohesiveCracks, CrackLists, PartedReach
)
_write_walls = StepPass("write_walls", Walls, Gauges, HistoryRows)
_add_pair_moments = StepPass("add_pair_moments", Moving, ContactConstants, ContactPairs, NearPairs, LaggedStresses)
_add_wall_moments = StepPass("add_wall_moments", Moving, ContactConstants, WallContacts, Walls, LaggedStresses)
_add_begun_contacts = StepPass(
    "add_begun_contacts", Moving, ContactConstants, ContactPairs, LaggedStresses, EventLog
)

_roll_pairs = StepPass("roll_pairs", Moving, ContactConstants, ContactPairs, NearPairs, RolledPairs)
_add_rolling = StepPass("add_rolling_loads", ContactPairs, NearPairs, RolledPairs, ContactSums)
_roll_at_walls = StepPass(
    "roll_at_walls", Moving, ContactConstants, WallContacts, Walls, RolledWalls, ContactSums
)
_sum_rolling = StepPass("sum_rolling_energies", ContactConstants, ContactPairs, RolledPairs, ContactEnergies)
_sum_rolling_at_walls = StepPass(
    "sum_rolling_at_walls", ContactConstants, WallContacts, RolledWalls, ContactEnergies
)

_adhere_pairs = StepPass("adhere_pairs", Moving, ContactConstants, ContactPairs, NearPairs, AdheringPairs)
_add_adhesion = StepPass("add_adhesion_loads", ContactPairs, NearPairs, AdheringPairs, ContactSums)
_adhere_at_walls = StepPass("adhere_at_walls", Moving, ContactConstants, WallContacts, Walls, ContactSums)
_sum_adhesion = StepPass("sum_adhesion_energies", Moving, ContactConstants, ContactPairs, ContactEnergies)
_sum_adhesion_at_walls = StepPass(
    "sum_adhesion_at_walls", Moving, ContactConstants, WallContacts, Walls, ContactEnergies
)

# Distances of all pairs are measured again when an element has moved this share of the reach of the list.
_FRESH = 0.1


class ContactTables:
    """Tables of the contacts of a run, with their present list.

    Args:
        model: model of the elements.
        contacts: contacts of the model.
        state: state of the run; its arrays are shared.
        shared: tables of all parts.
        gauges: gauges of the run.
        joints: bonds that join the elements.
        dt: time step [s].
    """

    def __init__(
        self, model: Model, contacts: ContactModel, state: State, shared: SharedTables, gauges: Gauges,
        joints: Joints, dt: float,
    ) -> None:  # fmt: skip
        self._state, self._shared, self._gauges = state, shared, gauges
        cracks = joints.cracks
        self._faces = None
        if cracks is not None and len(cracks.strengths.planes):
            self._faces = CrackedFaces(cracks, state)
        outer = None if self._faces is None else self._faces.outer
        self._search = ContactSearch(model, contacts, state, (joints.integrity, joints.apart), outer)
        self._check = ContactCheck(contacts, dt)
        self._period, self._joints = model.period, joints
        n, portions = len(state.pose), len(shared.portions.elements)
        laws = contacts.laws
        kind = np.ascontiguousarray(laws.kind[model.layout.order])
        self._law = ContactConstants(*laws.rows, kind, laws.hertzian, contacts.radius)
        self._rolls, self._beyond = laws.rolls, laws.beyond
        self._sums = ContactSums(lines(n))
        self._energies = ContactEnergies(np.zeros(portions))
        walls = contacts.walls
        self._walls, self._turning = walls_at(walls, state.walls), walls.turning
        self._motions = WallMotions(
            walls.times, walls.values, walls.start, walls.drive_wall, walls.drive_component, walls.drive_schedule,
            walls.drive_rate, walls.drive_axis, walls.servo_wall, walls.servo_schedule, walls.servo_speed,
            walls.servo_mass, walls.servo_damping, walls.free_wall, walls.free_mass, walls.free_force,
            walls.free_torque,
        )  # fmt: skip
        self._deepest = 0.0
        found = self._search.find(state.step)
        if found is not None:
            self._list(found)

    def _list(self, found: FoundContacts) -> None:
        """Make the tables of a list."""
        pairs, at_walls = found.pairs, found.walls
        c, portions = len(pairs.first), len(self._energies.energy)
        self._whole = found.whole
        self._pairs = ContactPairs(
            pairs.first, pairs.second, pairs.start, found.least, found.own, pairs.memory, pairs.touch,
            pairs.bond, self._joints.integrity, found.of_bond, self._period,
        )  # fmt: skip
        faces = self._faces
        self._face_pairs = (
            None if faces is None else faces.pairs(self._pairs, found.faces, found.whole, portions)
        )  # fmt: skip
        self._near = NearPairs(
            np.zeros(c + 1, dtype=np.uint32), np.zeros(c + 1, dtype=np.uint32), np.empty((c, 8)),
            np.zeros((portions, 2), dtype=np.int64), _FRESH * found.reach, self._beyond,
        )  # fmt: skip
        self._travel = Travel(
            found.position, found.position.copy(), np.zeros((portions, 3)),
            np.array([np.inf, -1.0]), found.reach,
        )  # fmt: skip
        self._at_walls = WallContacts(
            found.wall_start, at_walls.element, at_walls.wall, at_walls.gap, at_walls.memory, at_walls.touch,
            no_rows("WallLoad", len(at_walls.wall)),
        )  # fmt: skip
        self._rolled = RolledPairs(found.rolled, np.zeros((c, 4))) if self._rolls else None
        self._rolled_walls = RolledWalls(found.wall_rolled)
        self._adhering = AdheringPairs(np.zeros((c, 3)))
        keep_wall_places(self._walls, found.position, self._turning)

    def part(self) -> Part:
        """Return the part of contacts with their present list."""
        s, law, walls, faces = self._shared, self._law, self._walls, self._face_pairs
        walled = len(walls.body) > 0
        travel: Passes = [(_measure_travel, s.moving, self._travel), (_check_travel, self._travel, walls, s.portions)]
        add = (_add_pair_loads, law, self._pairs, self._near, self._sums)
        examined = s.moving, law, self._pairs, self._near, self._travel
        contacts: Passes = [(_press_pairs, *examined), add]
        if faces is not None:
            contacts = [
                (_press_pairs_and_faces, *examined, faces), add,
                (_add_face_loads, self._pairs, faces, self._sums),
            ]  # fmt: skip
        if self._rolled is not None:
            contacts += [
                (_roll_pairs, s.moving, law, self._pairs, self._near, self._rolled),
                (_add_rolling, self._pairs, self._near, self._rolled, self._sums),
            ]
        if self._beyond > 0.0:
            contacts += [
                (_adhere_pairs, s.moving, law, self._pairs, self._near, self._adhering),
                (_add_adhesion, self._pairs, self._near, self._adhering, self._sums),
            ]
        guard: Passes = []
        if walled:
            travel.insert(0, (_move_walls, self._motions, walls))
            contacts += [
                (_press_walls, s.moving, law, self._at_walls, walls, self._sums),
                *self._beside_pressure_at_walls(),
                (_measure_walls, s.moving, law, self._at_walls, walls, self._near, self._travel),
                (_load_walls, self._at_walls, self._motions, walls),
            ]
            guard.append((_count_wall_work, walls, s.portions))
        contacts.append((_keep_measures, self._near, self._travel))
        loads: Passes = [(_add_contact_loads, s.moving, s.cut, self._sums)]
        stages = {**self._after_failure(), "travel": travel, "contacts": contacts, "add": loads, "guard": guard}
        return Part(stages, record=self._record, keep=self._keep, renewed=self._renewed)

    def _beside_pressure_at_walls(self) -> Passes:
        at, passes = (self._shared.moving, self._law, self._at_walls, self._walls), Passes()
        if self._rolled is not None:
            passes.append((_roll_at_walls, *at, self._rolled_walls, self._sums))
        if self._beyond > 0.0:
            passes.append((_adhere_at_walls, *at, self._sums))
        return passes

    def _after_failure(self) -> dict[str, Passes]:
        """Return the passes that begin contact where bonds have failed."""
        moving, law, pairs, near, joints = self._shared.moving, self._law, self._pairs, self._near, self._joints
        if joints.cracks is not None:
            cracks, lists, reach = joints.cracks.cracks, joints.cracks.lists, PartedReach(joints.apart)
            begin: Passes = [(_touch_parted_faces, moving, pairs, near, cracks, lists, reach)]
            if (faces := self._face_pairs) is not None:
                begin.append((_begin_face_contacts, moving, pairs, near, faces, lists, joints.cracks.log))
            return {"constrain": begin}
        if joints.damage is None:
            return {}
        log = joints.damage.log
        if joints.pressed is None:
            return {"hand_over": [(_begin_contacts, moving, law, pairs, near, log, joints.damage.postponed)]}
        return {
            "loads": [
                (_release_pressure, log, joints.pressed),
                (_begin_softened_contacts, moving, law, pairs, near, log, self._sums),
            ]
        }

    def moments(self, stresses: LaggedStresses) -> Part:
        """Return the part of contacts in stresses of elements (`bondem.dynamics.parts.non_local_part`)."""
        s, law, walls = self._shared, self._law, self._walls
        passes: Passes = [(_add_pair_moments, s.moving, law, self._pairs, self._near, stresses)]
        if len(walls.body):
            passes.append((_add_wall_moments, s.moving, law, self._at_walls, walls, stresses))
        begun: Passes = []
        if self._joints.damage is not None:
            begun.append((_add_begun_contacts, s.moving, law, self._pairs, stresses, self._joints.damage.log))
        return Part({"prepare": passes, "hand_over": begun}, renewed=lambda: self.moments(stresses))

    def _record(self, history: HistoryRows) -> Passes:
        moving, law, energies = self._shared.moving, self._law, self._energies
        passes: Passes = [(_sum_pair_energies, moving, law, self._pairs, energies)]
        if self._face_pairs is not None:
            passes.append((_sum_face_energies, moving, law, self._pairs, self._face_pairs, energies))
        if len(self._walls.body):
            passes.append((_sum_wall_energies, moving, law, self._at_walls, self._walls, energies))
            passes.append((_write_walls, self._walls, self._gauges, history))
        if self._rolled is not None:
            passes.append((_sum_rolling, law, self._pairs, self._rolled, energies))
            passes.append((_sum_rolling_at_walls, law, self._at_walls, self._rolled_walls, energies))
        if self._beyond > 0.0:
            passes.append((_sum_adhesion, moving, law, self._pairs, energies))
            passes.append((_sum_adhesion_at_walls, moving, law, self._at_walls, self._walls, energies))
        return [*passes, (_write_contact_energy, energies, history)]

    def _keep(self) -> None:
        """Write the memory of contacts into the state, and check them."""
        pairs, at_walls = self._pairs, self._at_walls
        chosen = None if self._face_pairs is None else self._face_pairs.chosen
        rolled = None if self._rolled is None else (self._rolled.rolled, self._rolled_walls.rolled)
        self._search.keep(pairs, at_walls, self._whole, chosen, rolled)
        self._deepest = max(self._deepest, float(self._travel.portion[:, 2].max(initial=0.0)))
        listed = ListedContacts(
            pairs.first, pairs.second, pairs.bond, pairs.joined, at_walls.element, self._velocity_of_walls(),
            self._deepest,
        )  # fmt: skip
        self._check.look(listed, self._state.motion, self._state.time)

    def _velocity_of_walls(self) -> Floats:
        """Return the velocity of the wall at the element of each contact with one [m/s], (b, 3)."""
        at, walls = self._at_walls, self._walls
        row, about = wall_rows(walls.body)[at.wall], named_rows("WallShape", walls.shape)["about"][at.wall]
        arm = self._state.pose[at.element, :3] - about - row["displacement"]
        return row["velocity"] + np.cross(row["spin"], arm)

    def _renewed(self) -> Part | None:
        """Return the part with a new list, or None if a centre is not a number."""
        found = self._search.find(self._state.step)
        if found is None:
            return None
        self._list(found)
        return self.part()
