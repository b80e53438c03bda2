"""Division among elements of pieces that a wall separates from the centre of their cell."""

import math
from typing import Any

import numpy as np

from bondem._compile import kernel, loop
from bondem._types import Floats, Ints
from bondem.specimen.cells.pile import SIZE, START, TAG, new_pile, put
from bondem.specimen.cells.polygon import MOST_CORNERS, ROW, copy, height, roomy_list
from bondem.specimen.cells.solids import SPLIT, Solids
from bondem.specimen.cells.trim import FACE, lower_part, section

# Splits of a cell by the plane between elements a < b have the number a n + b beyond this; walls make fewer.
_FIRST = 10_000_000
# No wall polygon splits here.
_NONE = np.int64(-1)


@kernel(parallel=False)
def _plane(sphere, x, a, b):
    """Return the radical plane of elements a and b, away from a, relative to x: normal and distance."""
    p, q, r = sphere[b, 0] - sphere[a, 0], sphere[b, 1] - sphere[a, 1], sphere[b, 2] - sphere[a, 2]
    length = math.sqrt(p * p + q * q + r * r)
    p, q, r = p / length, q / length, r / length
    d = p * (sphere[a, 0] - x[0]) + q * (sphere[a, 1] - x[1]) + r * (sphere[a, 2] - x[2])
    return p, q, r, d + 0.5 * (length + (sphere[a, 3] ** 2 - sphere[b, 3] ** 2) / length)


@loop(parallel=False)
def _share(solids, s, sphere, near, own, tolerance, pile, spare, lid, work):
    """Return the part of solid s nearer to `own` than to others of `near`: a list, its sizes, a spare list."""
    x = sphere[solids.cell[s]]
    faces, corners = ROW, ROW
    for f in range(solids.face[s], solids.face[s + 1]):
        size = solids.corner[f + 1] - solids.corner[f]
        copy(solids.vertex, solids.corner[f], size, work, ROW)
        p, q, r, d = solids.plane[f, 0], solids.plane[f, 1], solids.plane[f, 2], solids.plane[f, 3]
        pile = put(pile, faces, corners, FACE, solids.tag[f], p, q, r, d, work, size)
        faces, corners = faces + 1, corners + size
    for other in near:
        if other == own:
            continue
        p, q, r, d = _plane(sphere, x, own, other)
        low, high = np.inf, -np.inf
        for f in range(faces):
            below, above = height(pile.vertex, pile.what[f, START], pile.what[f, SIZE], p, q, r, d)
            low, high = min(low, below), max(high, above)
        if high <= tolerance:
            continue
        if low >= -tolerance:
            return pile, ROW, ROW, spare
        size = section(pile, faces, p, q, r, d, tolerance, lid, work)
        spare, faces, corners = lower_part(pile, faces, _NONE, p, q, r, d, tolerance, spare, ROW, ROW, work)
        if size > 0:
            pair = min(own, other) * sphere.shape[0] + max(own, other)
            tag = SPLIT - 2 * (_FIRST + pair) - (1 if own > other else 0)
            spare = put(spare, faces, corners, FACE, tag, p, q, r, d, lid, size)
            faces, corners = faces + 1, corners + size
        pile, spare = spare, pile
    return pile, faces, corners, spare


@kernel(parallel=False)
def _divided(solids, sphere, near, start, tolerance) -> Any:
    """Divide solids; see `divided`. Returns the arrays of `Solids`, and owners."""
    out_cell, out_face = np.empty(64, np.int64), np.zeros(65, np.int64)
    owner, out_solids = np.empty(64, np.int64), 0
    done, all_faces, all_corners = new_pile(1024, 8192), ROW, ROW
    pile, spare = new_pile(256, 2048), new_pile(256, 2048)
    lid, work = np.empty((MOST_CORNERS, 3)), np.empty((MOST_CORNERS, 3))
    for s in range(solids.cell.size):
        some = near[start[s] : start[s + 1]]
        for own in some:
            pile, faces, _, spare = _share(solids, s, sphere, some, own, tolerance, pile, spare, lid, work)
            if faces < 4:
                continue
            for f in range(faces):
                size = pile.what[f, SIZE]
                copy(pile.vertex, pile.what[f, START], size, work, ROW)
                p, q, r, d = pile.plane[f, 0], pile.plane[f, 1], pile.plane[f, 2], pile.plane[f, 3]
                done = put(done, all_faces, all_corners, FACE, pile.what[f, TAG], p, q, r, d, work, size)
                all_faces, all_corners = all_faces + 1, all_corners + size
            out_cell, out_face = roomy_list(out_cell, out_solids + 1), roomy_list(out_face, out_solids + 2)
            owner = roomy_list(owner, out_solids + 1)
            out_cell[out_solids], owner[out_solids] = solids.cell[s], own
            out_solids += 1
            out_face[out_solids] = all_faces
    out_corner = np.zeros(all_faces + 1, np.int64)
    for f in range(all_faces):
        out_corner[f + 1] = out_corner[f] + done.what[f, SIZE]
    return (
        out_cell[:out_solids], out_face[: out_solids + 1], done.what[:all_faces, TAG].copy(), done.plane[:all_faces],
        out_corner, done.vertex[:all_corners], owner[:out_solids],
    )  # fmt: skip


def divided(solids: Solids, sphere: Floats, near: Ints, start: Ints, tolerance: float) -> tuple[Solids, Ints]:
    """Divide solids among elements, each point to the one with the least power x² - R².

    Args:
        solids: k solids.
        sphere: centres and radii of all elements [m], shape (n, 4).
        near: elements that solid s is divided among, near[start[s]] … near[start[s + 1] - 1].
        start: start of these, shape (k + 1,).
        tolerance: depth of a plane in a solid below which it does not divide the solid [m].

    Returns:
        The parts, and the element that each belongs to; the planes between them are splits of the cells.
    """
    cell, face, tag, plane, corner, vertex, owner = _divided(solids, sphere, near, start, tolerance)
    return Solids(cell, face, tag, plane, corner, vertex), owner
