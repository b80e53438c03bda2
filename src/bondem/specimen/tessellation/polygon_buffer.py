"""Growing lists of polygons, to which the passes that cut cells append."""

from typing import NamedTuple

import numpy as np

from bondem._core import room_for
from bondem._types import Floats, Ints

#: Columns of the integers of a polygon.
KIND, TAG, START, SIZE = 0, 1, 2, 3
#: Most corners of one polygon, and so the rows of a buffer for one.
MOST_CORNERS = 512


class Pile(NamedTuple):
    """A list of polygons with room for more; `core/tables/tessellation_tables.hpp` declares it.

    A pass that finds it full ends, and continues from there when there is more room.
    """

    what: Ints  #: kind, tag, first corner, number of corners, shape (p, 4)
    plane: Floats  #: shape (p, 4)
    vertex: Floats  #: shape (v, 3)
    used: Ints  #: polygons, corners, 1 where it was full, shape (3,)

    @property
    def size(self) -> int:
        """Number of polygons."""
        return int(self.used[0])

    @property
    def corner(self) -> Ints:
        """First corner of each polygon, and the end of the last one, shape (size + 1,)."""
        return np.append(self.what[: self.size, START], self.used[1])

    @property
    def corners(self) -> Floats:
        """Corners of all polygons [m], shape (v, 3)."""
        return self.vertex[: self.used[1]]

    def roomier(self) -> "Pile":
        """Return a copy with twice the room."""
        used = np.array([*self.used[:2], 0])
        what, plane, vertex = (room_for(values, 2 * len(values)) for values in self[:3])
        return Pile(what, plane, vertex, used)


def new_pile(polygons: int, corners: int) -> Pile:
    """An empty pile with room for some polygons and corners."""
    what, used = np.empty((polygons, 4), np.int64), np.zeros(3, np.int64)
    return Pile(what, np.empty((polygons, 4)), np.empty((corners, 3)), used)


def polygon_buffer() -> Floats:
    """Room for one polygon, shape (MOST_CORNERS, 3)."""
    return np.empty((MOST_CORNERS, 3))
