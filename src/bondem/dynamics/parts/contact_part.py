"""Part of a step for contacts: forces between elements and at walls, motion of walls, energies, and lists."""

import numpy as np

from bondem._cache_lines import exact_sums, lines
from bondem._passes import steps
from bondem._tables.columns import ELEMENTS_OF_PORTION, WallSum
from bondem._tables.contact_tables import (
    AdheringPairs,
    ContactConstants,
    ContactPairs,
    ContactSums,
    NearPairs,
    RolledPairs,
    RolledWalls,
    Travel,
    WallContacts,
    WallMotions,
)
from bondem._tables.crack_tables import PartedReach
from bondem._tables.step_tables import Gauges, HistoryRows, LaggedStresses
from bondem._types import Floats
from bondem.boundary.wall_rows import named_rows, no_rows, wall_rows
from bondem.damage.cracked_faces import CrackedFaces
from bondem.damage.damage_part import Joints
from bondem.dynamics.contact_check import ContactCheck, ListedContacts
from bondem.dynamics.neighbour_list import ContactSearch, FoundContacts
from bondem.dynamics.parts.shared_tables import SharedTables
from bondem.interactions.contact.contact_model import ContactModel
from bondem.interactions.contact.contact_search import keep_wall_places, walls_at
from bondem.interactions.step_part import Part, Passes
from bondem.model.model import Model
from bondem.model.state import State

# Share of the reach of the list by which an element may move before the distances of all pairs are computed anew.
_FRESH = 0.1


class ContactTables:
    """Tables of the contacts of a run, with their present list.

    Args:
        model: model of the elements.
        contacts: contacts of the model.
        state: state of the run; its arrays are shared.
        shared: tables of all parts.
        gauges: gauges of the run.
        joints: bonds as joints, whose elements touch only after the bond has failed.
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
        n = len(state.pose)
        self._portions = -(-n // ELEMENTS_OF_PORTION)
        laws = contacts.laws
        kind = np.ascontiguousarray(laws.kind[model.layout.order])
        self._law = ContactConstants(*laws.rows, kind, laws.hertzian, contacts.radius)
        self._rolls, self._beyond = laws.rolls, laws.beyond
        self._sums = ContactSums(lines(n))
        walls = contacts.walls
        self._walls, self._turning = walls_at(walls, state.walls), walls.turning
        self._motions = WallMotions(**{name: getattr(walls, name) for name in WallMotions._fields})
        self._deepest = 0.0
        found = self._search.find(state.step)
        if found is not None:
            self._list(found)

    def _list(self, found: FoundContacts) -> None:
        """Make the tables of a new neighbour list."""
        pairs, at_walls = found.pairs, found.walls
        c, portions = len(pairs.first), self._portions
        self._pairs = ContactPairs(
            pairs.first, pairs.second, pairs.start, found.least, found.whole, found.own, pairs.memory, pairs.touch,
            pairs.bond, self._joints.integrity, found.of_bond, self._period,
        )  # fmt: skip
        faces = self._faces
        self._face_pairs = None if faces is None else faces.pairs(self._pairs, found.faces, portions)
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
            no_rows("WallLoad", len(at_walls.wall)), exact_sums(WallSum.COUNT * len(self._walls.body)),
        )  # fmt: skip
        self._rolled = RolledPairs(found.rolled, np.zeros((c, 4))) if self._rolls else None
        self._rolled_walls = RolledWalls(found.wall_rolled)
        self._adhering = AdheringPairs(np.zeros((c, 3)))
        keep_wall_places(self._walls, found.position, self._turning)

    def part(self) -> Part:
        """Return the part of a step for the contacts of the present neighbour list."""
        s, law, walls, faces = self._shared, self._law, self._walls, self._face_pairs
        walled = len(walls.body) > 0
        travel = [steps.measure_travel(s.moving, self._travel), steps.check_travel(self._travel, walls, s.ledger)]
        add = steps.add_pair_loads(law, self._pairs, self._near, self._sums)
        examined = s.moving, law, self._pairs, self._near, self._travel
        contacts: Passes = [steps.press_pairs(*examined), add]
        if faces is not None:
            contacts = [
                steps.press_pairs_and_faces(*examined, faces), add,
                steps.add_face_loads(self._pairs, faces, self._sums),
            ]  # fmt: skip
        if self._rolled is not None:
            contacts += [
                steps.roll_pairs(s.moving, law, self._pairs, self._near, self._rolled),
                steps.add_rolling_loads(self._pairs, self._near, self._rolled, self._sums),
            ]
        if self._beyond > 0.0:
            contacts += [
                steps.adhere_pairs(s.moving, law, self._pairs, self._near, self._adhering),
                steps.add_adhesion_loads(self._pairs, self._near, self._adhering, self._sums),
            ]
        guard: Passes = []
        if walled:
            travel.insert(0, steps.move_walls(self._motions, walls))
            contacts += [
                steps.press_walls(s.moving, law, self._at_walls, walls, self._sums),
                *self._beside_pressure_at_walls(),
                steps.measure_wall_overlaps(s.moving, law, self._at_walls, walls, self._near, self._travel),
                steps.load_walls(self._at_walls, self._motions, walls),
            ]
            guard.append(steps.count_wall_work(walls, s.ledger))
        contacts.append(steps.keep_measures(self._near, self._travel))
        loads: Passes = [steps.add_contact_loads(s.moving, s.blocks, self._sums)]
        stages = {**self._after_failure(), "travel": travel, "contacts": contacts, "add": loads, "guard": guard}
        return Part(stages, record=self._record, keep=self._keep, renewed=self._renewed)

    def _beside_pressure_at_walls(self) -> Passes:
        at, passes = (self._shared.moving, self._law, self._at_walls, self._walls), Passes()
        if self._rolled is not None:
            passes.append(steps.roll_at_walls(*at, self._rolled_walls, self._sums))
        if self._beyond > 0.0:
            passes.append(steps.adhere_at_walls(*at, self._sums))
        return passes

    def _after_failure(self) -> dict[str, Passes]:
        """Return the passes that begin contact where bonds have failed."""
        moving, law, pairs, near, joints = self._shared.moving, self._law, self._pairs, self._near, self._joints
        if joints.cracks is not None:
            cracks, lists, reach = joints.cracks.cracks, joints.cracks.lists, PartedReach(joints.apart)
            begin: Passes = [steps.touch_parted_faces(moving, pairs, near, cracks, lists, reach)]
            if (faces := self._face_pairs) is not None:
                begin.append(steps.begin_face_contacts(moving, pairs, near, faces, lists, joints.cracks.log))
            return {"constrain": begin}
        if joints.damage is None:
            return {}
        log = joints.damage.log
        if joints.pressed is None:
            return {"hand_over": [steps.begin_contacts(moving, law, pairs, near, log, joints.damage.postponed)]}
        return {
            "loads": [
                steps.release_pressure(log, joints.pressed),
                steps.begin_softened_contacts(moving, law, pairs, near, log, self._sums),
            ]
        }

    def moments(self, stresses: LaggedStresses) -> Part:
        """Return the part that adds contact forces to the stresses of elements of a non-local law."""
        s, law, walls = self._shared, self._law, self._walls
        passes: Passes = [steps.add_pair_moments(s.moving, law, self._pairs, self._near, stresses)]
        if len(walls.body):
            passes.append(steps.add_wall_moments(s.moving, law, self._at_walls, walls, stresses))
        added: Passes = []
        if self._joints.damage is not None:
            added.append(steps.add_new_contacts(s.moving, law, self._pairs, stresses, self._joints.damage.log))
        return Part({"prepare": passes, "hand_over": added}, renewed=lambda: self.moments(stresses))

    def _record(self, history: HistoryRows) -> Passes:
        moving, law, ledger = self._shared.moving, self._law, self._shared.ledger
        passes: Passes = [steps.sum_pair_energies(moving, law, self._pairs, ledger)]
        if self._face_pairs is not None:
            passes.append(steps.sum_face_energies(moving, law, self._pairs, self._face_pairs, ledger))
        if len(self._walls.body):
            passes.append(steps.sum_wall_energies(moving, law, self._at_walls, self._walls, ledger))
            passes.append(steps.write_walls(self._walls, self._gauges, ledger, history))
        if self._rolled is not None:
            passes.append(steps.sum_rolling_energies(law, self._pairs, self._rolled, ledger))
            passes.append(steps.sum_rolling_at_walls(law, self._at_walls, self._rolled_walls, ledger))
        if self._beyond > 0.0:
            passes.append(steps.sum_adhesion_energies(moving, law, self._pairs, ledger))
            passes.append(steps.sum_adhesion_at_walls(moving, law, self._at_walls, self._walls, ledger))
        return passes

    def _keep(self) -> None:
        """Store the variables of contacts in the state, and warn about contacts out of range."""
        pairs, at_walls = self._pairs, self._at_walls
        chosen = None if self._face_pairs is None else self._face_pairs.chosen
        rolled = None if self._rolled is None else (self._rolled.rolled, self._rolled_walls.rolled)
        self._search.keep(pairs, at_walls, chosen, rolled)
        self._deepest = max(self._deepest, float(self._travel.portion[:, 2].max(initial=0.0)))
        listed = ListedContacts(
            pairs.first, pairs.second, pairs.bond, pairs.joined, at_walls.element, self._velocity_of_walls(),
            self._deepest,
        )  # fmt: skip
        self._check.examine(listed, self._state.motion, self._state.time)

    def _velocity_of_walls(self) -> Floats:
        """Return the velocity of the wall at the element of each contact with a wall [m/s], (b, 3)."""
        at, walls = self._at_walls, self._walls
        row, about = wall_rows(walls.body)[at.wall], named_rows("WallShape", walls.shape)["about"][at.wall]
        arm = self._state.pose[at.element, :3] - about - row["displacement"]
        return row["velocity"] + np.cross(row["spin"], arm)

    def _renewed(self) -> Part | None:
        """Return the part of a step for a new neighbour list, or None if a centre is not finite."""
        found = self._search.find(self._state.step)
        if found is None:
            return None
        self._list(found)
        return self.part()
