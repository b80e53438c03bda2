"""Growing buffers of polygons, to which the compiled passes that cut cells append."""

import numpy as np

from bondem._core import with_room
from bondem._tables.tessellation_tables import PolygonBuffer, Solids
from bondem._types import Floats, Ints

#: Columns of `PolygonBuffer.what`, the integers of each polygon.
KIND, TAG, START, SIZE = 0, 1, 2, 3
#: Largest number of corners of a polygon.
MOST_CORNERS = 512


def polygon_count(pile: PolygonBuffer) -> int:
    """Return the number of polygons in a buffer."""
    return int(pile.used[0])


def first_corners(pile: PolygonBuffer) -> Ints:
    """Return the first corner of each polygon, and the end of the last one, shape (count + 1,)."""
    return np.append(pile.what[: polygon_count(pile), START], pile.used[1])


def buffer_corners(pile: PolygonBuffer) -> Floats:
    """Return the corners of all polygons [m], shape (v, 3)."""
    return pile.vertex[: pile.used[1]]


def solids_in(pile: PolygonBuffer, cell: Ints, face: Ints) -> Solids:
    """Return the solids whose faces a buffer contains; `face` is the first face of each, and the end, (k + 1,)."""
    faces = polygon_count(pile)
    return Solids(
        cell, face, pile.what[:faces, TAG].copy(), pile.plane[:faces], first_corners(pile), buffer_corners(pile)
    )


def roomier_buffer(pile: PolygonBuffer) -> PolygonBuffer:
    """Return a copy of a buffer, with room for twice as many polygons and corners."""
    return with_room(pile._replace(used=np.array([*pile.used[:2], 0])), "what", "plane", "vertex")


def new_buffer(polygons: int, corners: int) -> PolygonBuffer:
    """Return an empty buffer with room for given numbers of polygons and corners."""
    what, used = np.empty((polygons, 4), np.int64), np.zeros(3, np.int64)
    return PolygonBuffer(what, np.empty((polygons, 4)), np.empty((corners, 3)), used)


def polygon_buffer() -> Floats:
    """Return a work array for the corners of one polygon, shape (512, 3)."""
    return np.empty((MOST_CORNERS, 3))
