"""Passes that Python calls, of `core/passes/packing/relaxation.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.packing_tables import Near, PackingWalls, Relaxing, Spheres


def relax_spheres(spheres: Spheres, packing_walls: PackingWalls, near: Near, relaxing: Relaxing) -> Call:
    """Minimises the overlap energy, as far as the neighbour lists are valid."""
    return Call("relax_spheres", (spheres, packing_walls, near, relaxing))
