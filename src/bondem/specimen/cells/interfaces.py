"""Interfaces between pieces of cells: faces in one plane, laid over each other.

Two pieces that face each other across a plane share the common part of their faces; a part that no other piece covers
is free. Both are patches, again convex polygons.
"""

from typing import NamedTuple

import numpy as np

from bondem._compile import kernel, loop
from bondem._types import Floats, Ints, PerElement3
from bondem.specimen.cells.pile import KIND, SIZE, START, TAG, new_pile, put
from bondem.specimen.cells.polygon import MOST_CORNERS, ROW, area, clip, copy
from bondem.specimen.cells.solids import SPLIT, Solids, polygon_measures, ranges

# What is on the other side of a free patch, as a number that is no literal: see ROW.
_NOTHING = np.int64(-1)


class _Groups(NamedTuple):
    """Faces in one plane: of group g, from one side plus[first[g]] …, and from the other minus[second[g]] …"""

    plus: Ints
    first: Ints
    minus: Ints
    second: Ints
    shift: Floats  #: from the centre that corners of the first are measured from to that of the others, (groups, 3)


class Patches(NamedTuple):
    """Convex polygons, each a face of a piece or part of one, in no order.

    Attributes:
        piece: piece of each face, shape (p,).
        other: piece on the other side, or -1, shape (p,).
        element: element whose whole cell is on the other side, or -1, shape (p,).
        normal: normals away from `piece` [-], shape (p, 3).
        corner: corners of polygon q are corner[q] … corner[q + 1] - 1, shape (p + 1,).
        vertex: corners [m], shape (v, 3).
        area: areas [m²], shape (p,).
        centroid: centroids [m], shape (p, 3).
        moment: second moments about it [m⁴], shape (p, 3, 3).
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


@loop(parallel=False)
def _part(rest, count, solids, of_face, g, x, y, z, tolerance, f, done, patches, corners, work, other):
    """Divide polygons by the piece of face g: parts in its face are added to `done`, the rest is returned.

    Args:
        rest: the polygons.
        count: number of polygons.
        x, y, z: vector from the centre that `rest` is relative to, to that of the piece [m].
        f: face of the polygons; -1 if parts in face g are not required.
    """
    q, left, kept, rows = of_face[g], new_pile(8, 64), ROW, ROW
    for p in range(count):
        start, whole = rest.what[p, START], rest.what[p, SIZE]
        copy(rest.vertex, start, whole, work, ROW)
        size = whole
        for h in range(solids.face[q], solids.face[q + 1]):
            if h != g:
                a, b, c, d = solids.plane[h, 0], solids.plane[h, 1], solids.plane[h, 2], solids.plane[h, 3]
                size = clip(work, ROW, size, other, a, b, c, d + a * x + b * y + c * z)
                copy(other, ROW, size, work, ROW)
                if size == 0:
                    break
        if size == 0 or area(work, ROW, size) <= tolerance:
            copy(rest.vertex, start, whole, work, ROW)
            left = put(left, kept, rows, ROW, ROW, 0.0, 0.0, 0.0, 0.0, work, whole)
            kept, rows = kept + 1, rows + whole
            continue
        if f >= 0:
            done = put(done, patches, corners, f, g, 0.0, 0.0, 0.0, 0.0, work, size)
            patches, corners = patches + 1, corners + size
        copy(rest.vertex, start, whole, work, ROW)
        size = whole
        for h in range(solids.face[q], solids.face[q + 1]):
            if h != g:
                a, b, c, d = solids.plane[h, 0], solids.plane[h, 1], solids.plane[h, 2], solids.plane[h, 3]
                d += a * x + b * y + c * z
                out = clip(work, ROW, size, other, -a, -b, -c, -d)
                if out > 0 and area(other, ROW, out) > tolerance:
                    left = put(left, kept, rows, ROW, ROW, 0.0, 0.0, 0.0, 0.0, other, out)
                    kept, rows = kept + 1, rows + out
                size = clip(work, ROW, size, other, a, b, c, d)
                copy(other, ROW, size, work, ROW)
    return left, kept, done, patches, corners


@kernel(parallel=False)
def _side(solids, of_face, groups, g, sign, tolerance, done, patches, corners, work, other):
    """Lay the faces of one side of a group over those of the other; with `sign` 1 shared parts are also kept."""
    mine, first, theirs, second = groups.plus, groups.first, groups.minus, groups.second
    if sign < 0:
        mine, first, theirs, second = groups.minus, groups.second, groups.plus, groups.first
    x, y, z = sign * groups.shift[g, 0], sign * groups.shift[g, 1], sign * groups.shift[g, 2]
    for k in range(first[g], first[g + 1]):
        f = mine[k]
        size = solids.corner[f + 1] - solids.corner[f]
        copy(solids.vertex, solids.corner[f], size, work, ROW)
        rest, count = put(new_pile(8, 64), ROW, ROW, ROW, ROW, 0.0, 0.0, 0.0, 0.0, work, size), np.int64(1)
        wanted = f if sign > 0 else _NOTHING
        for h in range(second[g], second[g + 1]):
            rest, count, done, patches, corners = _part(
                rest, count, solids, of_face, theirs[h], x, y, z, tolerance, wanted, done, patches, corners, work,
                other,
            )  # fmt: skip
        for p in range(count):
            size = rest.what[p, SIZE]
            copy(rest.vertex, rest.what[p, START], size, work, ROW)
            if area(work, ROW, size) > tolerance:
                done = put(done, patches, corners, f, _NOTHING, 0.0, 0.0, 0.0, 0.0, work, size)
                patches, corners = patches + 1, corners + size
    return done, patches, corners


@kernel(parallel=False)
def _match(solids, of_face, groups, tolerance):
    """Return patches of all groups: the face, that on the other side or -1, where corners begin, and corners."""
    done, patches, corners = new_pile(1024, 8192), ROW, ROW
    work, other = np.empty((MOST_CORNERS, 3)), np.empty((MOST_CORNERS, 3))
    for g in range(groups.first.size - 1):
        for sign in (1, -1):
            done, patches, corners = _side(
                solids, of_face, groups, g, sign, tolerance, done, patches, corners, work, other
            )
    start = np.zeros(patches + 1, np.int64)
    for p in range(patches):
        start[p + 1] = start[p] + done.what[p, SIZE]
    return done.what[:patches, KIND].copy(), done.what[:patches, TAG].copy(), start, done.vertex[:corners]


def _grouped(pieces: Solids, cell: Ints, inner: Ints, position: PerElement3) -> _Groups:
    """Group the faces `inner` of pieces by their planes, between cells or between pieces of one."""
    n, tag, own = len(position), pieces.tag[inner], cell[inner]
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
    return _Groups(plus, first, minus, second, shift)


def patches(pieces: Solids, position: PerElement3, tolerance: float) -> Patches:
    """Find the patches where pieces of cells meet each other, whole cells, or nothing.

    Args:
        pieces: pieces inside the shape, of all cells cut by walls.
        position: centres of all elements [m], shape (n, 3).
        tolerance: area below which patches are left out [m²].
    """
    of_face = pieces.of_face
    cell, tag = pieces.cell[of_face], pieces.tag
    is_cut = np.zeros(len(position), dtype=bool)
    is_cut[pieces.cell] = True
    inner = (tag <= SPLIT) | ((tag >= 0) & is_cut[np.maximum(tag, 0)])
    groups = _grouped(pieces, cell, np.flatnonzero(inner), position)
    face, opposite, corner, vertex = _match(pieces, of_face, groups, tolerance)
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
