"""Passes that Python calls, of `core/passes/tessellation/clip_to_shape.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.tessellation_tables import PolygonBuffer, Solids, Splitting, WallTree


def split_by_walls(
    solids: Solids, walls: WallTree, splitting: Splitting, stack: PolygonBuffer, piece: PolygonBuffer, pile:
    PolygonBuffer
) -> Call:
    """Splits cells by walls: the faces of their pieces go to the pile."""
    return Call("split_by_walls", (solids, walls, splitting, stack, piece, pile))
