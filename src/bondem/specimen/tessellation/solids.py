"""Convex solids with flat faces in flat arrays: plain cells, and the pieces that walls cut them into.

Corners are relative to the centre of the element of the cell, so that no digits are lost far from the origin.
"""

from collections.abc import Sequence

import numpy as np

from bondem._core import run_pass
from bondem._passes import calls
from bondem._tables.tessellation_tables import Bulk, PolygonMeasures, Solids
from bondem._types import Floats, Ints

# Tag of a face: the element behind it, from 0 up, or one of these; from SPLIT down, a plane that divided the cell.
BOX, LOCAL, SPLIT = -1, -7, -16


def solid_count(every: Solids) -> int:
    """Return the number of solids."""
    return len(every.cell)


def solid_of_face(every: Solids) -> Ints:
    """Return the solid to which each face belongs, shape (f,)."""
    return np.repeat(np.arange(solid_count(every)), np.diff(every.face))


def chosen_solids(every: Solids, solids: Ints) -> Solids:
    """Return the solids with the given numbers."""
    faces, face = ranges(every.face, solids)
    corners, corner = ranges(every.corner, faces)
    return Solids(every.cell[solids], face, every.tag[faces], every.plane[faces], corner, every.vertex[corners])


def ranges(start: Ints, chosen: Ints) -> tuple[Ints, Ints]:
    """Return rows start[c] … start[c + 1] - 1 of all `chosen` c, one after another, and the start of each c."""
    size = start[chosen + 1] - start[chosen]
    begin = np.concatenate([[0], np.cumsum(size)])
    return np.arange(begin[-1]) + np.repeat(start[chosen] - begin[:-1], size), begin


def joined(parts: Sequence[Solids]) -> Solids:
    """Concatenate lists of solids."""
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


def polygon_measures(corner: Ints, vertex: Floats) -> tuple[Floats, Floats, Floats]:
    """Return area [m²], (f,), centroid [m], (f, 3), and second moments about it [m⁴], (f, 3, 3), of f polygons."""
    count = len(corner) - 1
    measures = PolygonMeasures(corner, vertex, np.empty(count), np.empty((count, 3)), np.empty((count, 3, 3)))
    run_pass(calls.measure_polygons(measures))
    return measures[2:]


def chosen_bulk(every: Bulk, solids: Ints) -> Bulk:
    """Return volumes and moments of the solids with the given numbers."""
    return Bulk(*(values[solids] for values in every))


def bulk(solids: Solids) -> Bulk:
    """Compute volumes and moments of solids."""
    k = solid_count(solids)
    found = Bulk(np.empty(k), np.empty((k, 3)), np.empty((k, 3, 3)), np.empty((k, 3)), np.empty(k), np.empty(k))
    run_pass(calls.measure_solids(solids, found))
    return found
