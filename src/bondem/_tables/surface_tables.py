"""Tables of `core/tables/surface_tables.hpp`, written by `python -m tests.core.tables` from the header."""

from typing import NamedTuple

from bondem._types import Floats, Ints


class TriangleTree(NamedTuple):
    """Triangles, and a tree of boxes around p pieces of them.

    Box 1 contains all pieces, box b contains boxes 2 b and 2 b + 1, and each of the last p boxes contains one piece.
    """

    lower: Floats  #: lower corners of the boxes [m], (boxes, 3)
    upper: Floats  #: upper corners of the boxes [m], (boxes, 3)
    owner: Ints  #: triangle that each piece belongs to, (pieces,)
    corner: Floats  #: corners of the triangles [m], (triangles, 3, 3)
    side: Floats  #: from each corner to the next [m], (triangles, 3, 3)
    normal: Floats  #: unit normals, 0 where there is none, (triangles, 3)


class Nearest(NamedTuple):
    """Points, and the triangle nearest to each."""

    points: Floats  #: [m], (points, 3)
    triangle: Ints  #: number of the nearest triangle, (points,)
