"""Cells cut by walls: split by the planes of all wall triangles inside them, until none is inside.

Each piece carries the wall triangles within it, cut to the piece. It is split by the plane of the largest one, and
so are its other triangles (a binary partition of space). A piece without triangles lies on one side of every wall.
"""

from typing import NamedTuple

import numpy as np

from bondem._core import Pass, room_for
from bondem._types import Floats, Ints, PerElement3
from bondem.specimen.tessellation.polygon_buffer import TAG, Pile, new_pile, polygon_buffer
from bondem.specimen.tessellation.shape_walls import WallTree
from bondem.specimen.tessellation.solids import Solids


class Splitting(NamedTuple):
    """Data of the splitting of solids, and room for the pieces."""

    position: PerElement3  #: centres of all elements [m], (n, 3)
    tolerance: float  #: what reaches in less than this splits nothing [m]
    found: Ints  #: walls near a cell, (room,)
    below: Ints  #: where each piece on the stack begins, (room,)
    lid: Floats  #: polygons, (MOST_CORNERS, 3)
    work: Floats
    other: Floats
    cell: Ints  #: of which element's cell each piece is part, (pieces,)
    end: Ints  #: polygons up to the end of each piece, (pieces,)
    done: Ints  #: solids split, pieces made, (2,)

    @classmethod
    def of(cls, position: PerElement3, tolerance: float) -> "Splitting":
        """The beginning of it."""
        found, below, cell, end = (np.empty(64, np.int64) for _ in range(4))
        lid, work, other = (polygon_buffer() for _ in range(3))
        return cls(position, tolerance, found, below, lid, work, other, cell, end, np.zeros(2, np.int64))

    def with_more_scratch(self) -> "Splitting":
        """Return a copy with longer lists."""
        found, below = (room_for(values, 2 * len(values)) for values in (self.found, self.below))
        return self._replace(found=found, below=below)

    def with_more_pieces(self) -> "Splitting":
        """Return a copy with room for more pieces."""
        cell, end = (room_for(values, 2 * len(values)) for values in (self.cell, self.end))
        return self._replace(cell=cell, end=end)


_split = Pass("split_by_walls", Solids, WallTree, Splitting, Pile, Pile, Pile)


def trimmed(solids: Solids, position: PerElement3, walls: WallTree, tolerance: float) -> Solids:
    """Return the pieces of cells between walls, those inside and those outside.

    Args:
        solids: cells.
        position: centres of all elements [m], shape (n, 3).
        walls: the walls.
        tolerance: depth of a wall in a cell below which it does not split the cell [m].
    """
    splitting = Splitting.of(position, tolerance)
    stack, piece, pile = new_pile(256, 2048), new_pile(256, 2048), new_pile(1024, 8192)
    while (ended := _split(solids, walls, splitting, stack, piece, pile)) != "all_split":
        if ended == "pieces_full":
            splitting, pile = splitting.with_more_pieces(), pile.roomier()
        else:
            splitting, stack, piece = splitting.with_more_scratch(), stack.roomier(), piece.roomier()
    faces, pieces = pile.size, int(splitting.done[1])
    return Solids(
        splitting.cell[:pieces], np.append(0, splitting.end[:pieces]), pile.what[:faces, TAG].copy(),
        pile.plane[:faces], pile.corner, pile.corners,
    )  # fmt: skip
