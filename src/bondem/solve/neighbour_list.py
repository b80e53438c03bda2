"""The list of contacts of a run, renewed whenever elements that it does not hold may have come near."""

from dataclasses import dataclass

import numpy as np

from bondem._types import Floats, Ints, PerBond
from bondem.kernels.tables import ContactTable
from bondem.model.contact_search import (
    TOUCHING,
    FoundPairs,
    FoundWalls,
    PairSources,
    Walls,
    WallSources,
    found_pairs,
    found_walls,
)
from bondem.model.contacts import ContactModel, grid_of
from bondem.model.model import Model
from bondem.model.state import State
from bondem.solve.contact_check import ListedContacts

# Gap up to which pairs enter the list, over the mean radius: a longer list is made more seldom. Still elements
# get the short one, and each list that does not last makes the next one longer.
_SKIN_LEAST, _SKIN_MOST, _FACTOR = 0.1, 0.5, 1.4
# Steps a list should last: making one costs about as much as ten steps.
_LASTING = 100


@dataclass(frozen=True, eq=False)
class FoundContacts:
    """Contacts that may form before the next search.

    Attributes:
        pairs: pairs of elements.
        own: normal stiffness of the pairs of bonds, or 0 [N/m], (c,).
        of_bond: the pair of each bond, or -1, (m,).
        walls: contacts with walls.
        wall_start: start of the wall contacts of each element, (n + 1,).
        position: centres [m], (n, 3).
        reach: motion of an element or a wall for which the list is made [m].
    """

    pairs: FoundPairs
    own: Floats
    of_bond: Ints
    walls: FoundWalls
    wall_start: Ints
    position: Floats
    reach: float


class ContactSearch:
    """Search for the contacts of a run, with a skin that grows where lists do not last."""

    def __init__(self, model: Model, contacts: ContactModel, state: State, joints: tuple[PerBond, PerBond]) -> None:
        """Prepare the first search.

        Args:
            model: model of the elements.
            contacts: contacts of the model.
            state: state with the pose of the elements.
            joints: result of `bondem.solve.cracks.joints`; passes write both arrays.
        """
        self._contacts = contacts
        self._state = state
        self._period = model.lattice.particles.period
        self._breaking = model.failure is not None
        self._joined, self._apart = joints
        self._skin = _SKIN_LEAST
        self._made = state.step - _LASTING

    def find(self, step: int) -> FoundContacts | None:
        """Return the contacts of the present places of the elements; None if a centre is not a number."""
        state, contacts, layout, radius = self._state, self._contacts, self._state.layout, self._contacts.radius
        if not np.isfinite(state.pose[:, :3]).all():
            return None
        if step - self._made < _LASTING:
            self._skin = min(_FACTOR * self._skin, _SKIN_MOST)
        self._made = step
        skin = self._skin * float(radius.mean())
        position = state.pose[:, :3].copy()
        n = len(position)
        grid = grid_of(position, radius, self._period, skin)
        pairs = found_pairs(grid, PairSources(
            layout.in_start, layout.i, self._listed(position, skin),
            contacts.pairs.start, contacts.pairs.partner, contacts.pairs.gap,
            _starts(state.touching[:, 1], n), state.touching[:, 0].astype(np.uint32), state.stretch,
        ))  # fmt: skip
        own = np.zeros(len(pairs.first))
        if contacts.law.parallel:
            pairs.bond[:] = -1  # pairs as any others
        bonded = np.flatnonzero(pairs.bond >= 0)
        of_bond = np.full(len(layout.i), -1)
        of_bond[pairs.bond[bonded]] = bonded
        if contacts.own is not None:
            own[bonded] = contacts.own[pairs.bond[bonded]]
            pairs.gap[bonded] = self._apart[pairs.bond[bonded]] - (
                radius[pairs.first[bonded]] + radius[pairs.second[bonded]]
            )
        rest, kept = contacts.at_walls, state.wall_touching
        walls = Walls(contacts.walls.shape, state.walls, contacts.walls.friction, np.zeros((len(state.walls), 4)))
        at_walls = WallSources(
            radius, rest.start, rest.partner, rest.gap, _starts(kept[:, 0], n), kept[:, 1].astype(np.uint32),
            state.wall_stretch, skin, np.empty(n + 1, dtype=np.int64),
        )  # fmt: skip
        found = found_walls(state.pose, walls, at_walls)
        return FoundContacts(pairs, own, of_bond, found, at_walls.start, position, 0.5 * skin)

    def _listed(self, position: Floats, skin: float) -> np.ndarray:
        """Return a mask of the bonds whose pairs are listed, (m,): breakable ones, and broken ones with near ends.

        If contacts act beside bonds, these are all bonds with near ends.
        """
        layout, radius = self._state.layout, self._contacts.radius
        broken = (self._joined[: len(layout.i)] <= 0.0) | self._contacts.law.parallel
        listed = ~broken if self._breaking else np.zeros(len(broken), dtype=bool)
        e = np.flatnonzero(broken)
        i, j = layout.i[e], layout.j[e]
        apart = position[j] - position[i]
        if self._period is not None:
            apart -= self._period * np.rint(apart / self._period)
        reach = np.maximum(radius[i] + radius[j], self._apart[e]) + skin
        listed[e] = np.einsum("ek,ek->e", apart, apart) < reach**2
        return listed.astype(np.uint8)

    def keep(
        self, first: Ints, second: Ints, touch: np.ndarray, memory: Floats, element: Ints, wall: Ints,
        wall_touch: np.ndarray, wall_memory: Floats,
    ) -> None:  # fmt: skip
        """Write the memory of touching pairs, and of elements that touch walls, into the state."""
        state = self._state
        touching, at_wall = touch == TOUCHING, wall_touch == TOUCHING
        state.touching = np.column_stack([first[touching], second[touching]]).astype(np.int64)
        state.stretch = memory[touching, :6]
        state.wall_touching = np.column_stack([element[at_wall], wall[at_wall]]).astype(np.int64)
        state.wall_stretch = wall_memory[at_wall]


class ContactList:
    """Contacts of a state, in the form that the kernels require.

    Attributes:
        arrays: the present list; the state has its memory only after `keep`.
    """

    arrays: ContactTable

    def __init__(
        self, model: Model, contacts: ContactModel, state: State, joints: tuple[PerBond, PerBond]
    ) -> None:
        """Make the first list.

        Args:
            model: model of the elements.
            contacts: contacts of the model.
            state: state with the pose of the elements.
            joints: result of `bondem.solve.cracks.joints`; kernels write both arrays.
        """
        self._search = ContactSearch(model, contacts, state, joints)
        self._contacts = contacts
        self._state = state
        self._load = np.zeros((len(contacts.radius), 6))
        self._joined, self._apart = joints
        self._depth = 0.0
        self.renew(state.step)

    def renew(self, step: int) -> bool:
        """Make the list for the present places of the elements; return False if a centre is not a number."""
        found = self._search.find(step)
        if found is None:
            return False
        state, walls, pairs, at_walls = self._state, self._contacts.walls, found.pairs, found.walls
        n, c = len(found.position), len(pairs.first)
        out_pair = np.argsort(pairs.first, kind="stable")
        self._load[:] = 0.0
        self.arrays = ContactTable(
            law=self._contacts.law.parameters, radius=self._contacts.radius, load=self._load, listed=found.position,
            reach=found.reach,
            first=pairs.first, second=pairs.second, gap=pairs.gap, bond=pairs.bond, joined=self._joined,
            apart=self._apart, own=found.own, of_bond=found.of_bond,
            slack=np.zeros(c), measured=np.full((n, 3), np.inf), far=np.array([np.inf, np.inf, self._depth]),
            near=np.zeros(c, dtype=np.int64), nears=np.zeros(2, dtype=np.int64),
            close=np.zeros(c + 1, dtype=np.uint32),
            stretch=pairs.memory, touch=pairs.touch, output=np.zeros((c, 8)),
            in_start=pairs.start, out_start=_starts(pairs.first, n), out_pair=out_pair.astype(np.uint32),
            sums=np.zeros((n, 8)), hit=np.zeros(n, dtype=np.int64), hits=np.zeros(1, dtype=np.int64),
            met=np.zeros(n, dtype=np.uint8),
            wall_start=found.wall_start, wall=at_walls.wall, wall_gap=at_walls.gap, wall_stretch=at_walls.memory,
            wall_touch=at_walls.touch, wall_output=np.zeros((len(at_walls.wall), 4)),
            shape=walls.shape, walls=state.walls, wall_listed=state.walls[:, :4].copy(), wall_friction=walls.friction,
            times=walls.times, values=walls.values, start=walls.start, drive_wall=walls.drive_wall,
            drive_component=walls.drive_component, drive_schedule=walls.drive_schedule, drive_rate=walls.drive_rate,
            servo_wall=walls.servo_wall, servo_schedule=walls.servo_schedule, servo_speed=walls.servo_speed,
            servo_mass=walls.servo_mass, free_wall=walls.free_wall, free_mass=walls.free_mass,
            free_force=walls.free_force,
        )  # fmt: skip
        return True

    @property
    def listed(self) -> ListedContacts:
        """The list in the form of its checks."""
        c = self.arrays
        return ListedContacts(
            c.first, c.second, c.bond, c.joined, self._elements_at_walls, c.wall, c.walls, float(c.far[2])
        )

    @property
    def _elements_at_walls(self) -> Ints:
        return np.repeat(np.arange(len(self.arrays.radius)), np.diff(self.arrays.wall_start))

    def keep(self) -> None:
        """Write the memory of touching pairs into the state."""
        c = self.arrays
        self._depth = float(c.far[2])
        self._search.keep(
            c.first, c.second, c.touch, c.stretch, self._elements_at_walls, c.wall, c.wall_touch, c.wall_stretch
        )


def _starts(later: Ints, n: int) -> Ints:
    return np.concatenate([[0], np.cumsum(np.bincount(later, minlength=n))]).astype(np.int64)
