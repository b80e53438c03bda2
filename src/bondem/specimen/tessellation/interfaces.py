"""Interfaces between pieces of cells: common parts of faces that lie in one plane.

Two pieces that face each other across a plane share the common part of their faces; a part that no other piece covers
is free. Both are patches, again convex polygons.
"""

from typing import NamedTuple

import numpy as np

from bondem._core import run_pass
from bondem._passes import calls
from bondem._tables.tessellation_tables import FaceGroups, Solids
from bondem._types import Floats, Ints, PerElement3
from bondem.specimen.tessellation.polygon_buffer import (
    KIND,
    TAG,
    buffer_corners,
    first_corners,
    new_buffer,
    polygon_buffer,
    polygon_count,
    roomier_buffer,
)
from bondem.specimen.tessellation.solids import SPLIT, polygon_measures, ranges, solid_of_face


class Patches(NamedTuple):
    """Convex polygons, each a face of a piece or part of such a face, in no particular order.

    Attributes:
        piece: piece to which each patch belongs, shape (p,).
        other: piece on the other side, or -1, shape (p,).
        element: element whose whole cell is on the other side, or -1, shape (p,).
        normal: normals away from `piece` [-], shape (p, 3).
        corner: corners of polygon q are corner[q] … corner[q + 1] - 1, shape (p + 1,).
        vertex: corners [m], shape (v, 3).
        area: areas [m²], shape (p,).
        centroid: centroids [m], shape (p, 3).
        moment: second moments of area about the centroid [m⁴], shape (p, 3, 3).
        expected: elements whose cells should lie behind patches without a neighbour: a wall lies there, or those
            cells ended too early.
    """

    piece: Ints
    other: Ints
    element: Ints
    normal: Floats
    corner: Ints
    vertex: Floats
    area: Floats
    centroid: Floats
    moment: Floats
    expected: Ints


def _match(solids: Solids, groups: FaceGroups) -> tuple[Ints, Ints, Ints, Floats]:
    """Return the patches of all groups: own face, face on the other side or -1, first corner, and all corners."""
    rest, left, pile = new_buffer(64, 512), new_buffer(64, 512), new_buffer(1024, 8192)
    while (ended := run_pass(calls.match_faces(solids, groups, rest, left, pile))) != "all_matched":
        if ended == "patches_full":
            pile = roomier_buffer(pile)
        else:
            rest, left = roomier_buffer(rest), roomier_buffer(left)
    count = polygon_count(pile)
    return pile.what[:count, KIND].copy(), pile.what[:count, TAG].copy(), first_corners(pile), buffer_corners(pile)


def _grouped(pieces: Solids, of_face: Ints, inner: Ints, position: PerElement3, tolerance: float) -> FaceGroups:
    """Group the faces `inner` of pieces by their plane, between two cells or between pieces of the same cell."""
    n, tag, own = len(position), pieces.tag[inner], pieces.cell[of_face[inner]]
    split = tag <= SPLIT
    number = np.unique(np.where(split, (SPLIT - tag) // 2, 0), return_inverse=True)[1]
    low = np.where(split, own, np.minimum(own, tag))
    high = np.where(split, n + number, np.maximum(own, tag))
    forth = np.where(split, (SPLIT - tag) % 2 == 0, own < tag)
    key = low * (n + int(number.max(initial=0)) + 1) + high
    _, one, group = np.unique(key, return_index=True, return_inverse=True)
    plus, minus = (inner[side][np.argsort(group[side], kind="stable")] for side in (forth, ~forth))
    first, second = (np.searchsorted(np.sort(group[side]), np.arange(len(one) + 1)) for side in (forth, ~forth))
    between = ~split[one]
    shift = np.zeros((len(one), 3))
    shift[between] = position[high[one][between]] - position[low[one][between]]
    work, other = polygon_buffer(), polygon_buffer()
    return FaceGroups(of_face, plus, first, minus, second, shift, tolerance, work, other, np.zeros(1, np.int64))


def patches(pieces: Solids, position: PerElement3, tolerance: float) -> Patches:
    """Find the patches where pieces of cells meet each other, whole cells, or nothing.

    Args:
        pieces: pieces inside the shape, of all cells cut by walls.
        position: centres of all elements [m], shape (n, 3).
        tolerance: area below which patches are left out [m²].
    """
    of_face = solid_of_face(pieces)
    cell, tag = pieces.cell[of_face], pieces.tag
    is_cut = np.zeros(len(position), dtype=bool)
    is_cut[pieces.cell] = True
    inner = (tag <= SPLIT) | ((tag >= 0) & is_cut[np.maximum(tag, 0)])
    groups = _grouped(pieces, of_face, np.flatnonzero(inner), position, tolerance)
    face, opposite, corner, vertex = _match(pieces, groups)
    expected = np.unique(tag[face[(opposite < 0) & (tag[face] >= 0)]])
    plain = np.flatnonzero(~inner & (polygon_measures(pieces.corner, pieces.vertex)[0] > tolerance))
    corners, begin = ranges(pieces.corner, plain)
    element = np.concatenate([np.full(len(face), -1), np.maximum(tag[plain], -1)])
    face = np.concatenate([face, plain])
    opposite = np.concatenate([opposite, np.full(len(plain), -1)])
    corner = np.concatenate([corner, corner[-1] + begin[1:]])
    vertex = np.concatenate([vertex, pieces.vertex[corners]])
    vertex = vertex + np.repeat(position[cell[face]], np.diff(corner), axis=0)
    other = np.where(opposite >= 0, of_face[opposite], -1)
    return Patches(
        of_face[face], other, element, pieces.plane[face, :3], corner, vertex, *polygon_measures(corner, vertex),
        expected,
    )  # fmt: skip
