"""Convex solids with flat faces in flat arrays: plain cells, and the pieces that walls cut them into.

Corners are relative to the centre of the element of the cell, so that no digits are lost far from the origin.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from bondem._core import Pass
from bondem._types import Floats, Ints

# What is behind a face: an element from 0 up, or one of these; from SPLIT down, a plane that cut the cell.
BOX, LOCAL, SPLIT = -1, -7, -16


class Solids(NamedTuple):
    """Convex solids, k of them, with f faces and v corners.

    Attributes:
        cell: element of the cell that each solid is part of, shape (k,).
        face: faces of solid s are face[s] … face[s + 1] - 1, shape (k + 1,).
        tag: neighbour behind each face, shape (f,): an element; BOX - 0 … BOX - 5, the sides of the box around the
            shape (x_min, x_max, y_min …); LOCAL, an arbitrary end; or SPLIT - 2 s and SPLIT - 2 s - 1, the two sides
            of split s of the cell.
        plane: outward unit normal and distance from the centre, shape (f, 4) [-, m].
        corner: corners of face g are corner[g] … corner[g + 1] - 1, shape (f + 1,).
        vertex: corners relative to the centre of the element [m], shape (v, 3).
    """

    cell: Ints
    face: Ints
    tag: Ints
    plane: Floats
    corner: Ints
    vertex: Floats

    @property
    def number(self) -> int:
        """Number k of solids."""
        return len(self.cell)

    @property
    def of_face(self) -> Ints:
        """Solid of each face, shape (f,)."""
        return np.repeat(np.arange(self.number), np.diff(self.face))

    def chosen(self, solids: Ints) -> "Solids":
        """Return some of the solids, by number."""
        faces, face = ranges(self.face, solids)
        corners, corner = ranges(self.corner, faces)
        return Solids(self.cell[solids], face, self.tag[faces], self.plane[faces], corner, self.vertex[corners])


def ranges(start: Ints, chosen: Ints) -> tuple[Ints, Ints]:
    """Return rows start[c] … start[c + 1] - 1 of all `chosen` c one after another, and where those of each begin."""
    size = start[chosen + 1] - start[chosen]
    begin = np.concatenate([[0], np.cumsum(size)])
    return np.arange(begin[-1]) + np.repeat(start[chosen] - begin[:-1], size), begin


def joined(parts: Sequence[Solids]) -> Solids:
    """Return the solids of several lists in one."""
    none = np.zeros(0, dtype=np.int64)
    faces = np.concatenate([none, *(np.diff(part.face) for part in parts)])
    corners = np.concatenate([none, *(np.diff(part.corner) for part in parts)])
    return Solids(
        np.concatenate([none, *(part.cell for part in parts)]),
        np.append(0, np.cumsum(faces)),
        np.concatenate([none, *(part.tag for part in parts)]),
        np.concatenate([np.zeros((0, 4)), *(part.plane for part in parts)]),
        np.append(0, np.cumsum(corners)),
        np.concatenate([np.zeros((0, 3)), *(part.vertex for part in parts)]),
    )


class PolygonMeasures(NamedTuple):
    """Polygons, f of them, and what is measured of each."""

    corner: Ints  #: corners of polygon q are corner[q] … corner[q + 1] - 1, (f + 1,)
    vertex: Floats  #: corners [m], (v, 3)
    area: Floats  #: [m²], (f,)
    centroid: Floats  #: [m], (f, 3)
    moment: Floats  #: second moments about the centroid [m⁴], (f, 3, 3)


_measure_polygons = Pass("measure_polygons", PolygonMeasures)


def polygon_measures(corner: Ints, vertex: Floats) -> tuple[Floats, Floats, Floats]:
    """Return area [m²], (f,), centroid [m], (f, 3), and second moments about it [m⁴], (f, 3, 3), of polygons."""
    count = len(corner) - 1
    measures = PolygonMeasures(corner, vertex, np.empty(count), np.empty((count, 3)), np.empty((count, 3, 3)))
    _measure_polygons(measures)
    return measures[2:]


class Bulk(NamedTuple):
    """Volumes, surfaces and moments of solids, all about the centre of the element.

    Attributes:
        volume: ∫ dV [m³], shape (k,).
        first: ∫ x dV [m⁴], shape (k, 3).
        second: ∫ x⊗x dV [m⁵], shape (k, 3, 3).
        middle: a point inside, also of a thin solid [m], shape (k, 3).
        farthest: distance of the farthest corner [m], shape (k,).
        beyond: distance of the centre outside the solid, at most 0 if it lies inside [m], shape (k,).
    """

    volume: Floats
    first: Floats
    second: Floats
    middle: Floats
    farthest: Floats
    beyond: Floats

    def chosen(self, solids: Ints) -> "Bulk":
        """Return the values of some solids, by number."""
        return Bulk(*(values[solids] for values in self))


_measure_solids = Pass("measure_solids", Solids, Bulk)


def bulk(solids: Solids) -> Bulk:
    """Compute volumes and moments of solids."""
    k = solids.number
    found = Bulk(np.empty(k), np.empty((k, 3)), np.empty((k, 3, 3)), np.empty((k, 3)), np.empty(k), np.empty(k))
    _measure_solids(solids, found)
    return found
