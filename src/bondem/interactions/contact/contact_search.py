"""Search for contacts by the core: pairs and elements at walls that may touch before the next search.

`core/tables/contact_tables.hpp` declares types and shapes of the tables.
"""

import numpy as np

from bondem._core import run_pass
from bondem._passes import calls
from bondem._tables.contact_tables import FoundPairs, FoundWalls, PairSources, Walls, WallSources
from bondem._tables.packing_tables import SphereGrid
from bondem._tables.step_tables import Poses
from bondem._types import Floats, Ints
from bondem.boundary.wall_rows import named_rows, no_rows, wall_rows
from bondem.boundary.wall_table import WallTable
from bondem.geometry.rotations import turned_vectors


def walls_at(table: WallTable, body: Floats) -> Walls:
    """Return the table of walls at the places in `body`, (w, 27), whose memory it shares."""
    return Walls(table.shape, body, table.inertia, no_rows("WallListed", len(body)))


def keep_wall_places(walls: Walls, position: Floats, turning: Ints) -> None:
    """Store the present places of walls in `walls.listed`, as those at which a neighbour list is made.

    Args:
        position: centres of the elements [m], (n, 3).
        turning: numbers of the walls that may turn, which also store the distance of the farthest element.
    """
    shape, row = named_rows("WallShape", walls.shape), wall_rows(walls.body)
    listed = named_rows("WallListed", walls.listed)
    arm = turned_vectors(row["orientation"], shape["point"] - shape["about"])
    listed["point"] = shape["about"] + row["displacement"] + arm
    listed["axis"] = turned_vectors(row["orientation"], shape["axis"])
    listed["growth"] = row["growth"]
    for k in turning:
        listed["farthest"][k] = np.sqrt(((position - listed["point"][k]) ** 2).sum(axis=1).max())


def new_wall_sources(radius: Floats, skin: float) -> WallSources:
    """Return the input of a search for walls within `skin` [m] of spheres, without stored contacts and overlaps."""
    none = np.zeros(len(radius) + 1, dtype=np.int64), np.zeros(0, dtype=np.uint32)
    return WallSources(radius, *none, np.zeros(0), *none, np.zeros((0, 6)), skin, np.empty_like(none[0]))


def found_pairs(grid: SphereGrid, sources: PairSources) -> FoundPairs:
    """Return pairs of near spheres without bonds, and of bonds in `sources.wanted`, with the memory of contacts."""
    room = 4 * len(grid.sphere) + int(sources.wanted.sum())
    while True:
        found = FoundPairs(
            np.empty(room, np.uint32), np.empty(room, np.uint32), np.empty(room, np.int64),
            np.empty_like(sources.bond_start), np.empty(room), np.empty((room, 8)), np.empty(room, np.uint8),
        )  # fmt: skip
        if run_pass(calls.list_pairs(grid, sources, found)) == "all_listed":
            break
        room *= 2
    count = found.start[-1]
    return FoundPairs(
        found.first[:count], found.second[:count], found.bond[:count], found.start, found.gap[:count],
        found.memory[:count], found.touch[:count],
    )  # fmt: skip


def found_walls(pose: Floats, walls: Walls, sources: WallSources) -> FoundWalls:
    """Return the walls within the skin of each element, element by element, with the memory of stored contacts."""
    run_pass(calls.count_wall_contacts(Poses(pose), walls, sources))
    count = sources.start[-1]
    found = FoundWalls(
        np.empty(count, np.uint32), np.empty(count, np.uint32), np.empty(count), np.empty(count),
        np.empty((count, 6)), np.empty(count, np.uint8),
    )  # fmt: skip
    run_pass(calls.list_wall_contacts(Poses(pose), walls, sources, found))
    return found
