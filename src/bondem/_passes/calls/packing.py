"""Passes that Python calls, of `core/passes/packing`; written by `python -m tests.core.passes`."""

from bondem._passes import Call
from bondem._tables.packing_tables import (
    Flight,
    Growing,
    Near,
    NeighbourLists,
    PackingWalls,
    Relaxing,
    SphereGrid,
    Spheres,
)


def fly_and_grow(spheres: Spheres, packing_walls: PackingWalls, near: Near, growing: Growing, flight: Flight) -> Call:
    """Lets spheres fly and grow, as far as the neighbour lists are valid; all are advanced to the end."""
    return Call("fly_and_grow", (spheres, packing_walls, near, growing, flight))


def list_neighbours(sphere_grid: SphereGrid, neighbour_lists: NeighbourLists) -> Call:
    """Lists the neighbours of spheres that are sorted and counted, (start[n],)."""
    return Call("list_neighbours", (sphere_grid, neighbour_lists))


def relax_spheres(spheres: Spheres, packing_walls: PackingWalls, near: Near, relaxing: Relaxing) -> Call:
    """Minimises the overlap energy, as far as the neighbour lists are valid."""
    return Call("relax_spheres", (spheres, packing_walls, near, relaxing))


def sort_and_count_neighbours(sphere_grid: SphereGrid) -> Call:
    """Sorts spheres into the cells of their grid, and counts the neighbours of each, whose surfaces are at most
    `skin` apart: fills `start`, too.
    """
    return Call("sort_and_count_neighbours", (sphere_grid,))


def sort_into_cells(sphere_grid: SphereGrid) -> Call:
    """Sorts spheres into the cells of their grid: fills `cell`, `first`, `member` and `place`."""
    return Call("sort_into_cells", (sphere_grid,))
