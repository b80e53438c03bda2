"""Neighbour list of a run: contacts that may form, renewed before any other pair may touch."""

from dataclasses import dataclass

import numpy as np

from bondem._indices import group_starts
from bondem._tables.columns import TouchState
from bondem._tables.contact_tables import ContactPairs, FoundPairs, FoundWalls, PairSources, WallContacts, WallSources
from bondem._types import Floats, Ints, PerBond, PerElement
from bondem.interactions.contact.contact_columns import BETWEEN, FACES, KIND, LINE_COLUMNS, NOT_YET, START
from bondem.interactions.contact.contact_model import ContactModel, grid_of
from bondem.interactions.contact.contact_search import found_pairs, found_walls, walls_at
from bondem.model.model import Model
from bondem.model.state import State

# Gap up to which pairs enter the list, over the mean radius: the least, the largest, and the factor by which it grows
# after each list that did not last. A longer list is renewed less often.
_SKIN_LEAST, _SKIN_MOST, _FACTOR = 0.1, 0.5, 1.4
# Steps a list should last: making one costs about as much as ten steps.
_LASTING = 100


@dataclass(frozen=True, eq=False)
class FoundContacts:
    """Contacts that may form before the next search.

    Attributes:
        pairs: pairs of elements.
        whole: distance at which pairs touch as spheres [m], (c,).
        least: distance at which each pair touches [m], (c,): `whole`, or a smaller one where a bond or faces parted.
        faces: faces by which pairs touch, as one number, 0 for none, (c,).
        own: normal stiffness of the pairs of bonds, or 0 [N/m], (c,).
        of_bond: place of the pair of each bond in the list, or -1, (m,).
        walls: contacts with walls.
        wall_start: start of the wall contacts of each element, (n + 1,).
        position: centres [m], (n, 3).
        reach: motion of an element or a wall up to which the list is complete [m].
        rolled: rotation that each pair stores, as `State.rolled` [m], (c, 3).
        wall_rolled: rotation that each contact with a wall stores [m], (b, 3).
    """

    pairs: FoundPairs
    whole: Floats
    least: Floats
    faces: Floats
    own: Floats
    of_bond: Ints
    walls: FoundWalls
    wall_start: Ints
    position: Floats
    reach: float
    rolled: Floats
    wall_rolled: Floats


class ContactSearch:
    """Search for the contacts of a run, with a list that includes larger gaps if lists are soon out of date."""

    def __init__(
        self, model: Model, contacts: ContactModel, state: State, joints: tuple[PerBond, PerBond],
        outer: PerElement | None = None,
    ) -> None:  # fmt: skip
        """Prepare the first search.

        Args:
            model: model of the elements.
            contacts: contacts of the model.
            state: state with the pose of the elements.
            joints: integrity of each bond, above 0 while the bond joins its elements, and distance of centres at
                which its elements touch after failure [m]; passes write both arrays.
            outer: reach of the faces of each cell [m], (n,): two cells can touch by faces only if their centres are
                closer than the sum of both. None if cells do not touch by faces.
        """
        self._size = contacts.radius if outer is None else np.maximum(contacts.radius, outer)
        self._contacts = contacts
        self._state = state
        self._particles = model.lattice.particles
        self._breaking = model.fails
        self._joined, self._apart = joints
        self._skin = _SKIN_LEAST
        self._made = state.step - _LASTING

    def find(self, step: int) -> FoundContacts | None:
        """Return the contacts at the present positions; None if a centre is not finite. `step` is the step number."""
        state, contacts, layout, radius = self._state, self._contacts, self._state.layout, self._contacts.radius
        if not np.isfinite(state.pose[:, :3]).all():
            return None
        if step - self._made < _LASTING:
            self._skin = min(_FACTOR * self._skin, _SKIN_MOST)
        self._made = step
        skin = self._skin * float(radius.mean())
        listed = skin + contacts.laws.beyond  # gap up to which contacts enter the list
        position = state.pose[:, :3].copy()
        n = len(position)
        grid = grid_of(position, self._size, self._particles.period, listed)
        pairs = found_pairs(grid, PairSources(
            layout.in_start, layout.i, self._listed(position, listed),
            contacts.pairs.start, contacts.pairs.partner, contacts.pairs.gap,
            group_starts(state.touching[:, 1], n), state.touching[:, 0].astype(np.uint32),
            np.ascontiguousarray(state.stretch[:, :LINE_COLUMNS]),
        ))  # fmt: skip
        own = np.zeros(len(pairs.first))
        if contacts.laws.parallel:
            pairs.bond[:] = -1  # bonded pairs count like any others
        bonded = np.flatnonzero(pairs.bond >= 0)
        of_bond = np.full(len(layout.i), -1)
        of_bond[pairs.bond[bonded]] = bonded
        if contacts.own is not None:
            own[bonded] = contacts.own[pairs.bond[bonded]]
            pairs.gap[bonded] = self._apart[pairs.bond[bonded]] - (
                radius[pairs.first[bonded]] + radius[pairs.second[bonded]]
            )
        whole = radius[pairs.first] + radius[pairs.second] + pairs.gap
        least = _recalled(pairs, whole)
        rest, stored = contacts.at_walls, state.wall_touching
        walls = walls_at(contacts.walls, state.walls)
        at_walls = WallSources(
            radius, rest.start, rest.partner, rest.gap, group_starts(stored[:, 0], n), stored[:, 1].astype(np.uint32),
            state.wall_stretch, listed, np.empty(n + 1, dtype=np.int64),
        )  # fmt: skip
        found = found_walls(state.pose, walls, at_walls)
        return FoundContacts(
            pairs, whole, least, self._faces_of(pairs), own, of_bond, found, at_walls.start, position, 0.5 * skin,
            _matched(state.rolled, state.touching[:, ::-1], pairs.second, pairs.first, n),
            _matched(state.wall_rolled, stored, found.element, found.wall, max(1, len(state.walls))),
        )  # fmt: skip

    def _listed(self, position: Floats, skin: float) -> np.ndarray:
        """Return a mask of the bonds whose pairs are listed, (m,): breakable bonds, and broken bonds with near ends.

        If contacts act in parallel with bonds, all bonds with near ends are listed.
        """
        layout, size = self._state.layout, self._size
        broken = (self._joined[: len(layout.i)] <= 0.0) | self._contacts.laws.parallel
        listed = ~broken if self._breaking else np.zeros(len(broken), dtype=bool)
        e = np.flatnonzero(broken)
        i, j = layout.i[e], layout.j[e]
        apart = self._particles.nearest(position[j] - position[i])
        reach = np.maximum(size[i] + size[j], self._apart[e]) + skin
        listed[e] = np.einsum("ek,ek->e", apart, apart) < reach**2
        return listed.astype(np.uint8)

    def _faces_of(self, pairs: FoundPairs) -> Floats:
        """Return the code of the two faces by which each pair touches, from the state, 0 for none, (c,)."""
        state, n, found = self._state, len(self._state.pose), np.zeros(len(pairs.first))
        known = state.touching[:, 1] * n + state.touching[:, 0]
        stored = np.flatnonzero(pairs.touch != TouchState.SEPARATE)
        key = pairs.second[stored].astype(np.int64) * n + pairs.first[stored]
        found[stored] = state.stretch[np.searchsorted(known, key), FACES]
        return found

    def keep(
        self, pairs: ContactPairs, walls: WallContacts, faces: Floats | None, rolled: tuple[Floats, Floats] | None
    ) -> None:  # fmt: skip
        """Store the variables of contacts, of pairs and with walls, in the state.

        Args:
            pairs: the list of pairs.
            walls: contacts with walls.
            faces: faces by which pairs touch, (c,), or None if pairs do not touch by faces.
            rolled: rotations that pairs and contacts with walls store [m], (c, 3) and (b, 3), or None.
        """
        state, at_wall = self._state, walls.touch == TouchState.TOUCHING
        touch, less = pairs.touch, pairs.reach < pairs.whole
        late = less & ((touch == TouchState.LATE) | (touch == TouchState.PARTED))
        stored = late | (touch == TouchState.TOUCHING) | (touch == TouchState.FACING)
        memory, spheres, less = pairs.memory[stored], touch[stored] != TouchState.FACING, less[stored]
        memory[spheres, START] = np.where(less, pairs.reach[stored], 0.0)[spheres]
        memory[spheres, KIND] = 0.0
        memory[~spheres & ~(memory[:, KIND] > 0.0), KIND] = BETWEEN
        memory[late[stored], KIND] = NOT_YET
        state.touching = np.column_stack([pairs.first[stored], pairs.second[stored]]).astype(np.int64)
        state.stretch = np.column_stack([memory, np.zeros(len(memory)) if faces is None else faces[stored]])
        state.wall_touching = np.column_stack([walls.element[at_wall], walls.wall[at_wall]]).astype(np.int64)
        state.wall_stretch = walls.memory[at_wall]
        if rolled is not None:
            state.rolled, state.wall_rolled = rolled[0][stored], rolled[1][at_wall]


def _recalled(pairs: FoundPairs, whole: Floats) -> Floats:
    """Set the kind of contact of pairs from stored variables; return the distances at which pairs touch [m], (c,)."""
    kind, start = pairs.memory[:, KIND], pairs.memory[:, START]
    stored = pairs.touch == TouchState.TOUCHING
    pairs.touch[stored & ((kind > 0.0) | (kind == BETWEEN))] = TouchState.FACING
    pairs.touch[stored & (kind == NOT_YET)] = TouchState.LATE
    spheres = stored & (pairs.touch != TouchState.FACING)
    reach = np.where(spheres & (start > 0.0), start, whole)
    start[spheres] = 0.0
    np.maximum(kind, 0.0, out=kind)
    return reach


def _matched(
    values: Floats, known: Ints, first: np.ndarray, second: np.ndarray, count: int
) -> Floats:  # fmt: skip
    """Return the rows of stored contacts in the order of a list, (c, 3), zero for contacts that are not stored.

    Args:
        values: rows of the stored contacts, (k, 3) or (0, 3).
        known: both numbers of each stored contact, sorted, (k, 2).
        first: first number of each contact of the list, (c,).
        second: second number, below `count`, (c,).
        count: bound of the second numbers.
    """
    found = np.zeros((len(first), 3))
    if len(values):
        keys, wanted = known @ np.array([count, 1]), first.astype(np.int64) * count + second
        place = np.minimum(np.searchsorted(keys, wanted), len(keys) - 1)
        there = keys[place] == wanted
        found[there] = values[place[there]]
    return found
