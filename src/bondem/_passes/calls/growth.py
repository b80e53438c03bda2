"""Passes that Python calls, of `core/passes/packing/growth.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.packing_tables import Flight, Growing, Near, PackingWalls, Spheres


def fly_and_grow(spheres: Spheres, packing_walls: PackingWalls, near: Near, growing: Growing, flight: Flight) -> Call:
    """Advances spheres that fly and grow to the end of a duration, or until neighbour lists are out of date or the
    collisions are too many; all end at the same time.
    """
    return Call("fly_and_grow", (spheres, packing_walls, near, growing, flight))
