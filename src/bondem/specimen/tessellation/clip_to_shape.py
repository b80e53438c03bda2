"""Cells cut by walls: split by the planes of all wall triangles inside them, until none is inside.

Each piece has a list of the wall triangles within it, cut to the piece. The plane of the largest triangle splits the
piece and its other triangles (binary space partition). A piece without triangles lies on one side of every wall.
"""

import numpy as np

from bondem._core import run_pass, with_room
from bondem._passes import calls
from bondem._tables.tessellation_tables import Solids, Splitting, WallTree
from bondem._types import PerElement3
from bondem.specimen.tessellation.polygon_buffer import new_buffer, polygon_buffer, roomier_buffer, solids_in


def trimmed(solids: Solids, position: PerElement3, walls: WallTree, tolerance: float) -> Solids:
    """Split cells by walls; return all pieces, inside and outside the shape.

    Args:
        solids: cells.
        position: centres of all elements [m], shape (n, 3).
        walls: search tree of the triangles of the walls.
        tolerance: depth of a wall in a cell below which it does not split the cell [m].
    """
    found, below, cell, end = (np.empty(64, np.int64) for _ in range(4))
    lid, work, other = (polygon_buffer() for _ in range(3))
    splitting = Splitting(position, tolerance, found, below, lid, work, other, cell, end, np.zeros(2, np.int64))
    stack, piece, pile = new_buffer(256, 2048), new_buffer(256, 2048), new_buffer(1024, 8192)
    while (ended := run_pass(calls.split_by_walls(solids, walls, splitting, stack, piece, pile))) != "all_split":
        if ended == "pieces_full":
            splitting, pile = with_room(splitting, "cell", "end"), roomier_buffer(pile)
        else:
            splitting = with_room(splitting, "found", "below")
            stack, piece = roomier_buffer(stack), roomier_buffer(piece)
    pieces = int(splitting.done[1])
    return solids_in(pile, splitting.cell[:pieces], np.append(0, splitting.end[:pieces]))
