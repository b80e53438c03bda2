"""Search for contacts by the core: pairs and elements at walls that may touch before the next search.

`core/tables/contact_tables.hpp` declares types and shapes of the tables.
"""

from typing import NamedTuple

import numpy as np

from bondem._core import Pass
from bondem._types import Floats, Ints
from bondem.boundary.wall_rows import named_rows, no_rows, wall_rows
from bondem.boundary.wall_table import WallTable
from bondem.geometry.neighbours import SphereGrid
from bondem.geometry.rotations import turned_vectors
from bondem.interactions.beams.beam_tables import Poses

#: How elements touch: as spheres; by faces of cells, or not at all as these faces lie between them; not yet, though
#: inside their spheres. `core/passes/contacts/pairs.hpp`
APART, TOUCHING, JUST_PARTED, FACING, LATE = range(5)


class Walls(NamedTuple):
    """Walls, w of them."""

    shape: Floats  #: rows of `WallShape`, (w, 12)
    body: Floats  #: positions, velocities and loads of the walls, as `State.walls`, (w, 27)
    inertia: Floats  #: rows of `WallInertia`, (w, 8)
    listed: Floats  #: where the walls were when the list was made, rows of `WallListed`, (w, 8)

    @classmethod
    def of(cls, table: WallTable, body: Floats) -> "Walls":
        """Return the walls of a model at their places in `body`, (w, 27), which they share."""
        return cls(table.shape, body, table.inertia, no_rows("WallListed", len(body)))

    def keep_places(self, position: Floats, turning: Ints) -> None:
        """Note where walls are when a list is made.

        Args:
            position: centres of the elements [m], (n, 3).
            turning: numbers of the walls that may turn; only these need the distance of the farthest element.
        """
        shape, row = named_rows("WallShape", self.shape), wall_rows(self.body)
        listed = named_rows("WallListed", self.listed)
        arm = turned_vectors(row["orientation"], shape["point"] - shape["about"])
        listed["point"] = shape["about"] + row["displacement"] + arm
        listed["axis"] = turned_vectors(row["orientation"], shape["axis"])
        listed["growth"] = row["growth"]
        for k in turning:
            listed["farthest"][k] = np.sqrt(((position - listed["point"][k]) ** 2).sum(axis=1).max())


class PairSources(NamedTuple):
    """Bonds and memories of contacts, of which the list of pairs is made."""

    bond_start: Ints  #: start of the bonds of each later element, (n + 1,)
    bond_first: np.ndarray  #: their earlier elements, uint32
    wanted: np.ndarray  #: whether the pair of a bond is listed, however far apart, uint8, (m,)
    rest_start: Ints  #: start of the pairs of each later element that overlap in the reference, (n + 1,)
    rest_first: np.ndarray  #: uint32
    rest_gap: Floats  #: [m]
    kept_start: Ints  #: start of the pairs of each later element that touch, (n + 1,)
    kept_first: np.ndarray  #: uint32
    kept_memory: Floats  #: (…, 8)


class FoundPairs(NamedTuple):
    """The list of pairs, c of them, sorted by the later element, then by the earlier one."""

    first: np.ndarray  #: uint32, (c,)
    second: np.ndarray  #: uint32, (c,)
    bond: Ints  #: the bond of each pair, or -1, (c,)
    start: Ints  #: start of the pairs of each later element, (n + 1,)
    gap: Floats  #: gap from which the overlap counts, at most 0 [m], (c,)
    memory: Floats  #: as `State.stretch`, (c, 8)
    touch: np.ndarray  #: uint8, (c,)


class WallSources(NamedTuple):
    """Memories of contacts with walls, of which their list is made."""

    radius: Floats  #: radii of the elements [m], (n,)
    rest_start: Ints  #: start of the contacts of each element that overlap in the reference, (n + 1,)
    rest_wall: np.ndarray  #: uint32
    rest_gap: Floats  #: [m]
    kept_start: Ints  #: start of the contacts of each element that touch, (n + 1,)
    kept_wall: np.ndarray  #: uint32
    kept_memory: Floats  #: (…, 6)
    skin: float  #: largest gap [m]
    start: Ints  #: start of the found contacts of each element, (n + 1,)

    @classmethod
    def without_memory(cls, radius: Floats, skin: float) -> "WallSources":
        """Return the sources of a first search, in the reference."""
        none = np.zeros(len(radius) + 1, dtype=np.int64), np.zeros(0, dtype=np.uint32)
        return cls(radius, *none, np.zeros(0), *none, np.zeros((0, 6)), skin, np.empty_like(none[0]))


class FoundWalls(NamedTuple):
    """The list of contacts with walls, b of them, sorted by element, then by wall."""

    element: np.ndarray  #: uint32, (b,)
    wall: np.ndarray  #: uint32, (b,)
    gap: Floats  #: gap from which the overlap counts, at most 0 [m], (b,)
    now: Floats  #: present gap [m], (b,)
    memory: Floats  #: tangential stretch [m] and force of the dashpots [N], (b, 6)
    touch: np.ndarray  #: uint8, (b,)


_list_pairs = Pass("list_pairs", SphereGrid, PairSources, FoundPairs)
_count_wall_contacts = Pass("count_wall_contacts", Poses, Walls, WallSources)
_list_wall_contacts = Pass("list_wall_contacts", Poses, Walls, WallSources, FoundWalls)


def found_pairs(grid: SphereGrid, sources: PairSources) -> FoundPairs:
    """Return near spheres that no bond joins and the wanted pairs of bonds, with the memory of those that touch."""
    room = 4 * len(grid.sphere) + int(sources.wanted.sum())
    while True:
        found = FoundPairs(
            np.empty(room, np.uint32), np.empty(room, np.uint32), np.empty(room, np.int64),
            np.empty_like(sources.bond_start), np.empty(room), np.empty((room, 8)), np.empty(room, np.uint8),
        )  # fmt: skip
        if _list_pairs(grid, sources, found) == "all_listed":
            break
        room *= 2
    count = found.start[-1]
    return FoundPairs(
        found.first[:count], found.second[:count], found.bond[:count], found.start, found.gap[:count],
        found.memory[:count], found.touch[:count],
    )  # fmt: skip


def found_walls(pose: Floats, walls: Walls, sources: WallSources) -> FoundWalls:
    """Return the walls within the skin of each element, in their order, with the memory of those that touch."""
    _count_wall_contacts(Poses(pose), walls, sources)
    count = sources.start[-1]
    found = FoundWalls(
        np.empty(count, np.uint32), np.empty(count, np.uint32), np.empty(count), np.empty(count),
        np.empty((count, 6)), np.empty(count, np.uint8),
    )  # fmt: skip
    _list_wall_contacts(Poses(pose), walls, sources, found)
    return found
