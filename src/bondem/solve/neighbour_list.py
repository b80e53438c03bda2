"""The list of contacts of a run, renewed whenever elements that it does not hold may have come near."""

import numpy as np

from bondem._types import Floats, Ints, PerBond
from bondem.kernels.contact_list import pair_candidates, wall_candidates
from bondem.kernels.contact_pairs import TOUCHING
from bondem.kernels.tables import ContactTable
from bondem.model.contacts import ContactModel, near
from bondem.model.model import Model
from bondem.model.state import State

# Gap up to which pairs enter the list, over the mean radius: a longer list is made more seldom. Still elements
# get the short one, and each list that does not last makes the next one longer.
_SKIN_LEAST, _SKIN_MOST, _FACTOR = 0.1, 0.5, 1.4
# Steps a list should last: making one costs about as much as ten steps.
_LASTING = 100


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
        self._contacts = contacts
        self._state = state
        self._radius = contacts.radius
        self._period = model.lattice.particles.period
        self._load = np.zeros((len(self._radius), 6))
        self._breaking = model.failure is not None
        self._joined, self._apart = joints
        self._own = contacts.own
        self._depth = 0.0
        self._skin = _SKIN_LEAST
        self._made = state.step - _LASTING
        self.renew(state.step)

    def renew(self, step: int) -> bool:
        """Make the list for the present places of the elements; return False if a centre is not a number."""
        state, contacts, layout = self._state, self._contacts, self._state.layout
        if not np.isfinite(state.pose[:, :3]).all():
            return False
        if step - self._made < _LASTING:
            self._skin = min(_FACTOR * self._skin, _SKIN_MOST)
        self._made = step
        skin = self._skin * float(self._radius.mean())
        position = state.pose[:, :3].copy()
        n, walls = len(position), contacts.walls
        first, second, bond, in_start, gap, stretch, touch, out_start, out_pair = pair_candidates(
            *near(position, self._radius, self._period, skin), layout.in_start, layout.i,
            self._listed(position, skin),
            contacts.pairs.start, contacts.pairs.partner, contacts.pairs.gap,
            _starts(state.touching[:, 1], n), state.touching[:, 0].astype(np.uint32), state.stretch,
        )  # fmt: skip
        own = np.zeros(len(first))
        if contacts.law.parallel:
            bond[:] = -1  # pairs as any others
        bonded = np.flatnonzero(bond >= 0)
        of_bond = np.full(len(layout.i), -1)
        of_bond[bond[bonded]] = bonded
        if self._own is not None:
            own[bonded] = self._own[bond[bonded]]
            touching = self._radius[first[bonded]] + self._radius[second[bonded]]
            gap[bonded] = self._apart[bond[bonded]] - touching
        self._load[:] = 0.0
        wall_start, wall, wall_gap, wall_stretch, wall_touch, _ = wall_candidates(
            state.pose, self._radius, walls.shape, state.walls, skin,
            contacts.at_walls.start, contacts.at_walls.partner, contacts.at_walls.gap,
            _starts(state.wall_touching[:, 0], n), state.wall_touching[:, 1].astype(np.uint32), state.wall_stretch,
        )  # fmt: skip
        self.arrays = ContactTable(
            law=contacts.law.parameters, radius=self._radius, load=self._load, listed=position, reach=0.5 * skin,
            first=first, second=second, gap=gap, bond=bond, joined=self._joined, apart=self._apart,
            own=own, of_bond=of_bond,
            slack=np.zeros(len(first)), measured=np.full((n, 3), np.inf), far=np.array([np.inf, np.inf, self._depth]),
            near=np.zeros(len(first), dtype=np.int64), nears=np.zeros(2, dtype=np.int64),
            close=np.zeros(len(first) + 1, dtype=np.uint32),
            stretch=stretch, touch=touch, output=np.zeros((len(first), 8)),
            in_start=in_start, out_start=out_start, out_pair=out_pair,
            sums=np.zeros((n, 8)), hit=np.zeros(n, dtype=np.int64), hits=np.zeros(1, dtype=np.int64),
            met=np.zeros(n, dtype=np.uint8),
            wall_start=wall_start, wall=wall, wall_gap=wall_gap, wall_stretch=wall_stretch, wall_touch=wall_touch,
            wall_output=np.zeros((len(wall), 4)),
            shape=walls.shape, walls=state.walls, wall_listed=state.walls[:, :4].copy(), wall_friction=walls.friction,
            times=walls.times, values=walls.values, start=walls.start, drive_wall=walls.drive_wall,
            drive_component=walls.drive_component, drive_schedule=walls.drive_schedule, drive_rate=walls.drive_rate,
            servo_wall=walls.servo_wall, servo_schedule=walls.servo_schedule, servo_speed=walls.servo_speed,
            servo_mass=walls.servo_mass, free_wall=walls.free_wall, free_mass=walls.free_mass,
            free_force=walls.free_force,
        )  # fmt: skip
        return True

    def _listed(self, position: Floats, skin: float) -> np.ndarray:
        """Return a mask of the bonds whose pairs are listed, (m,): breakable ones, and broken ones with near ends.

        If contacts act beside bonds, these are all bonds with near ends.
        """
        layout = self._state.layout
        broken = (self._joined[: len(layout.i)] <= 0.0) | self._contacts.law.parallel
        listed = ~broken if self._breaking else np.zeros(len(broken), dtype=bool)
        e = np.flatnonzero(broken)
        i, j = layout.i[e], layout.j[e]
        apart = position[j] - position[i]
        if self._period is not None:
            apart -= self._period * np.rint(apart / self._period)
        reach = np.maximum(self._radius[i] + self._radius[j], self._apart[e]) + skin
        listed[e] = np.einsum("ek,ek->e", apart, apart) < reach**2
        return listed.astype(np.uint8)

    def keep(self) -> None:
        """Write the memory of touching pairs into the state."""
        c, state = self.arrays, self._state
        self._depth = float(c.far[2])
        touching = c.touch == TOUCHING
        state.touching = np.column_stack([c.first[touching], c.second[touching]]).astype(np.int64)
        state.stretch = c.stretch[touching, :6]
        at_wall = c.wall_touch == TOUCHING
        element = np.repeat(np.arange(len(c.radius)), np.diff(c.wall_start))
        state.wall_touching = np.column_stack([element[at_wall], c.wall[at_wall]]).astype(np.int64)
        state.wall_stretch = c.wall_stretch[at_wall]


def _starts(later: Ints, n: int) -> Ints:
    return np.concatenate([[0], np.cumsum(np.bincount(later, minlength=n))]).astype(np.int64)
