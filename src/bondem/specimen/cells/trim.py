"""Cells cut by walls: split by the planes of all wall triangles inside them, until none is inside.

Each piece carries the wall triangles within it, cut to the piece. It is split by the plane of the largest one, and
so are its other triangles (a binary partition of space). A piece without triangles lies on one side of every wall.
"""

import math
from typing import Any

import numpy as np

from bondem._compile import kernel, loop
from bondem._types import PerElement3
from bondem.specimen.cells.pile import KIND, SIZE, START, TAG, Pile, new_pile, put
from bondem.specimen.cells.polygon import (
    MOST_CORNERS,
    ROW,
    SQUARE,
    TRIANGLE,
    area,
    clip,
    copy,
    height,
    reverse,
    roomy,
    roomy_list,
    square,
)
from bondem.specimen.cells.solids import SPLIT, Solids
from bondem.specimen.cells.walls import WallTree

#: What polygons of a piece are: its faces, and the wall triangles within it.
FACE, _WALL = np.int64(0), np.int64(1)


@loop(parallel=False)
def _near(vertex, begin, end, x, walls, found):
    """List the triangles whose boxes meet the box around corners `begin` to `end` about the centre x (3,)."""
    low, high = np.empty(3), np.empty(3)
    for c in range(3):
        low[c], high[c] = np.inf, -np.inf
        for v in range(begin, end):
            low[c], high[c] = min(low[c], vertex[v, c]), max(high[c], vertex[v, c])
        low[c], high[c] = low[c] + x[c], high[c] + x[c]
    waiting = np.empty(128, np.int64)
    waiting[0], count, listed = 1, 1, 0
    while count > 0:
        count -= 1
        box = waiting[count]
        apart = False
        for c in range(3):
            apart = apart or walls.lower[box, c] > high[c] or walls.upper[box, c] < low[c]
        if apart:
            continue
        if box >= walls.owner.size:
            if listed == found.size:
                found = roomy_list(found, listed + 1)
            found[listed] = walls.owner[box - walls.owner.size]
            listed += 1
            continue
        waiting[count], waiting[count + 1] = 2 * box, 2 * box + 1
        count += 2
    return listed, found


@kernel(parallel=False)
def _whole(solids, s, x, walls, tolerance, pile, found, work, other):
    """Put a cell and the wall parts within it on the empty list; returns the list and its content."""
    polygons, corners, first, last = ROW, ROW, solids.face[s], solids.face[s + 1]
    for f in range(first, last):
        size = solids.corner[f + 1] - solids.corner[f]
        copy(solids.vertex, solids.corner[f], size, work, ROW)
        a, b, c, d = solids.plane[f, 0], solids.plane[f, 1], solids.plane[f, 2], solids.plane[f, 3]
        pile = put(pile, polygons, corners, FACE, solids.tag[f], a, b, c, d, work, size)
        polygons, corners = polygons + 1, corners + size
    listed, found = _near(solids.vertex, solids.corner[first], solids.corner[last], x, walls, found)
    for w in range(listed):
        t, size = found[w], TRIANGLE
        for k in range(3):
            for q in range(3):
                work[k, q] = walls.corner[t, k, q] - x[q]
        for f in range(first, last):
            # what lies in a face of the cell splits nothing
            a, b, c, d = solids.plane[f, 0], solids.plane[f, 1], solids.plane[f, 2], solids.plane[f, 3] - tolerance
            size = clip(work, ROW, size, other, a, b, c, d)
            copy(other, ROW, size, work, ROW)
            if size == 0:
                break
        if size > 0:
            a, b, c = walls.plane[t, 0], walls.plane[t, 1], walls.plane[t, 2]
            d = 0.0
            for q in range(3):
                d += walls.plane[t, q] * (walls.corner[t, 0, q] - x[q])
            pile = put(pile, polygons, corners, _WALL, t, a, b, c, d, work, size)
            polygons, corners = polygons + 1, corners + size
    return pile, polygons, corners, found


@loop(parallel=False)
def _largest(pile, polygons):
    """Return the wall polygon with the largest area, or -1 if there is none."""
    best, most = -1, 0.0
    for p in range(polygons):
        if pile.what[p, KIND] == _WALL:
            size = area(pile.vertex, pile.what[p, START], pile.what[p, SIZE])
            if size > most:
                best, most = p, size
    return best


@loop(parallel=False)
def section(pile, polygons, a, b, c, d, tolerance, work, other):
    """Compute the section of a piece by a plane, in `work`; returns its number of corners."""
    far = 0.0
    for p in range(polygons):
        for v in range(pile.what[p, START], pile.what[p, START] + pile.what[p, SIZE]):
            far = max(far, pile.vertex[v, 0] ** 2 + pile.vertex[v, 1] ** 2 + pile.vertex[v, 2] ** 2)
    square(a, b, c, d, 1.01 * math.sqrt(far), work)
    size = SQUARE
    for p in range(polygons):
        if pile.what[p, KIND] == FACE:
            low, high = height(pile.vertex, pile.what[p, START], pile.what[p, SIZE], a, b, c, d)
            if low <= tolerance and high >= -tolerance:
                e, f, g, h = pile.plane[p, 0], pile.plane[p, 1], pile.plane[p, 2], pile.plane[p, 3]
                size = clip(work, ROW, size, other, e, f, g, h)
                copy(other, ROW, size, work, ROW)
    return size


@loop(parallel=False)
def lower_part(piece, polygons, split, a, b, c, d, tolerance, stack, on, corners, work):
    """Push the part of a piece below a plane onto a stack, without its new face; `split` is the wall that splits."""
    for p in range(polygons):
        kind, start, size = piece.what[p, KIND], piece.what[p, START], piece.what[p, SIZE]
        low, _ = height(piece.vertex, start, size, a, b, c, d)
        if p == split or low >= (-tolerance if kind == _WALL else 0.0):
            continue
        left = clip(piece.vertex, start, size, work, a, b, c, d)
        if left > 0:
            e, f, g, h = piece.plane[p, 0], piece.plane[p, 1], piece.plane[p, 2], piece.plane[p, 3]
            stack = put(stack, on, corners, kind, piece.what[p, TAG], e, f, g, h, work, left)
            on, corners = on + 1, corners + left
    return stack, on, corners


@loop(parallel=False)
def _taken(stack, first, on, piece):
    """Copy the uppermost piece of a stack, its polygons from `first` on."""
    begin = stack.what[first, START]
    end = stack.what[on - 1, START] + stack.what[on - 1, SIZE]
    piece = Pile(roomy(piece.what, on - first), roomy(piece.plane, on - first), roomy(piece.vertex, end - begin))
    for p in range(on - first):
        for q in range(4):
            piece.what[p, q], piece.plane[p, q] = stack.what[first + p, q], stack.plane[first + p, q]
        piece.what[p, START] -= begin
    copy(stack.vertex, begin, end - begin, piece.vertex, ROW)
    return piece


@kernel(parallel=False)
def _pieces(solids, position, walls, tolerance) -> Any:
    """Split cells; see `trimmed`.

    Returns:
        The arrays of `Solids`.
    """
    out_cell, out_face, out_solids = np.empty(64, np.int64), np.zeros(65, np.int64), 0
    done, faces, corners = new_pile(1024, 8192), ROW, ROW
    stack, piece = new_pile(256, 2048), new_pile(256, 2048)
    below = np.empty(64, np.int64)  # where each piece on the stack begins
    found, lid = np.empty(64, np.int64), np.empty((MOST_CORNERS, 3))
    work, other = np.empty((MOST_CORNERS, 3)), np.empty((MOST_CORNERS, 3))
    for s in range(solids.cell.size):
        x = position[solids.cell[s]]
        stack, on, top, found = _whole(solids, s, x, walls, tolerance, stack, found, work, other)
        below[0], waiting, splits = 0, 1, 0
        while waiting > 0:
            waiting -= 1
            first = below[waiting]
            piece = _taken(stack, first, on, piece)
            count, top = on - first, stack.what[first, START]
            on = first
            wall = _largest(piece, count)
            if wall < 0:
                out_cell, out_face = roomy_list(out_cell, out_solids + 1), roomy_list(out_face, out_solids + 2)
                for p in range(count):
                    if piece.what[p, KIND] == FACE:
                        size = piece.what[p, SIZE]
                        copy(piece.vertex, piece.what[p, START], size, work, ROW)
                        a, b, c, d = piece.plane[p, 0], piece.plane[p, 1], piece.plane[p, 2], piece.plane[p, 3]
                        done = put(done, faces, corners, FACE, piece.what[p, TAG], a, b, c, d, work, size)
                        faces, corners = faces + 1, corners + size
                out_cell[out_solids] = solids.cell[s]
                out_solids += 1
                out_face[out_solids] = faces
                continue
            a, b, c, d = piece.plane[wall, 0], piece.plane[wall, 1], piece.plane[wall, 2], piece.plane[wall, 3]
            size = section(piece, count, a, b, c, d, tolerance, lid, other)
            for side in range(2):
                if side == 1:
                    a, b, c, d = -a, -b, -c, -d
                    reverse(lid, size)
                begin = on
                stack, on, top = lower_part(
                    piece, count, wall, a, b, c, d, tolerance, stack, on, top, work
                )
                if size > 0:
                    tag = SPLIT - 2 * splits - side
                    stack = put(stack, on, top, FACE, tag, a, b, c, d, lid, size)
                    on, top = on + 1, top + size
                if on > begin:
                    below = roomy_list(below, waiting + 1)
                    below[waiting] = begin
                    waiting += 1
            splits += 1
    out_corner = np.zeros(faces + 1, np.int64)
    for f in range(faces):
        out_corner[f + 1] = out_corner[f] + done.what[f, SIZE]
    return (
        out_cell[:out_solids], out_face[: out_solids + 1], done.what[:faces, TAG].copy(), done.plane[:faces],
        out_corner, done.vertex[:corners],
    )  # fmt: skip


def trimmed(solids: Solids, position: PerElement3, walls: WallTree, tolerance: float) -> Solids:
    """Return the pieces of cells between walls, those inside and those outside.

    Args:
        solids: cells.
        position: centres of all elements [m], shape (n, 3).
        walls: the walls.
        tolerance: depth of a wall in a cell below which it does not split the cell [m].
    """
    cell, face, tag, plane, corner, vertex = _pieces(solids, position, walls, tolerance)
    return Solids(cell, face, tag, plane, corner, vertex)
