"""Passes that Python calls, of `core/passes/contacts/candidates.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.contact_tables import FoundPairs, FoundWalls, PairSources, Walls, WallSources
from bondem._tables.packing_tables import SphereGrid
from bondem._tables.step_tables import Poses


def count_wall_contacts(poses: Poses, walls: Walls, wall_sources: WallSources) -> Call:
    """Counts walls within the skin of each element."""
    return Call("count_wall_contacts", (poses, walls, wall_sources))


def list_pairs(sphere_grid: SphereGrid, pair_sources: PairSources, found_pairs: FoundPairs) -> Call:
    """Lists near spheres of a sorted grid that no bond joins, and wanted pairs of bonds, with the memory of pairs
    that touch.
    """
    return Call("list_pairs", (sphere_grid, pair_sources, found_pairs))


def list_wall_contacts(poses: Poses, walls: Walls, wall_sources: WallSources, found_walls: FoundWalls) -> Call:
    """Lists elements near walls in their order, with the memory of those that touch."""
    return Call("list_wall_contacts", (poses, walls, wall_sources, found_walls))
