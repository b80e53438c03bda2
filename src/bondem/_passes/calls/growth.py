"""Passes that Python calls, of `core/passes/packing/growth.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.packing_tables import Flight, Growing, Near, PackingWalls, Spheres


def fly_and_grow(spheres: Spheres, packing_walls: PackingWalls, near: Near, growing: Growing, flight: Flight) -> Call:
    """Advances spheres that fly and grow while the neighbour lists are valid, all to the same time."""
    return Call("fly_and_grow", (spheres, packing_walls, near, growing, flight))
