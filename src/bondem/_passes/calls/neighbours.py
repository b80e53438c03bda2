"""Passes that Python calls, of `core/passes/packing/neighbours.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.packing_tables import NeighbourLists, SphereGrid


def list_neighbours(sphere_grid: SphereGrid, neighbour_lists: NeighbourLists) -> Call:
    """Lists the neighbours of spheres that are sorted and counted, start[n] numbers in all."""
    return Call("list_neighbours", (sphere_grid, neighbour_lists))


def sort_and_count_neighbours(sphere_grid: SphereGrid) -> Call:
    """Sorts spheres into the cells of their grid, and sets `start` to running sums of their numbers of neighbours."""
    return Call("sort_and_count_neighbours", (sphere_grid,))


def sort_into_cells(sphere_grid: SphereGrid) -> Call:
    """Sorts spheres into the cells of their grid: fills `cell`, `first`, `member` and `place`."""
    return Call("sort_into_cells", (sphere_grid,))
