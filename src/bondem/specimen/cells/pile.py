"""A growing list of polygons."""

from typing import NamedTuple

import numpy as np

from bondem._compile import loop
from bondem._types import Floats, Ints
from bondem.specimen.cells.polygon import copy, roomy

#: Columns of the integers of a polygon.
KIND, TAG, START, SIZE = 0, 1, 2, 3


class Pile(NamedTuple):
    """A list of polygons."""

    what: Ints  #: kind, tag, first corner, number of corners, shape (p, 4)
    plane: Floats  #: shape (p, 4)
    vertex: Floats  #: shape (v, 3)


@loop(parallel=False)
def new_pile(polygons, corners):
    """Return an empty list with room for some polygons and corners."""
    return Pile(np.empty((polygons, 4), np.int64), np.empty((polygons, 4)), np.empty((corners, 3)))


@loop(parallel=False)
def put(pile, polygons, corners, kind, tag, a, b, c, d, work, size):
    """Append a polygon to a list; returns the list, which may have grown."""
    pile = Pile(roomy(pile.what, polygons + 1), roomy(pile.plane, polygons + 1), roomy(pile.vertex, corners + size))
    pile.what[polygons, KIND], pile.what[polygons, TAG] = kind, tag
    pile.what[polygons, START], pile.what[polygons, SIZE] = corners, size
    pile.plane[polygons, 0], pile.plane[polygons, 1] = a, b
    pile.plane[polygons, 2], pile.plane[polygons, 3] = c, d
    copy(work, 0, size, pile.vertex, corners)
    return pile
