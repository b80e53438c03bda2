"""Plain Laguerre cells: the points nearer to one sphere than to all others, in the power x² - R².

A cell begins as a box and is cut by the radical plane of one neighbour after another, in the order of their distance.
Every face is a polygon of its own, cut by planes, without any record of connections. Degenerate cases are therefore
harmless, and volumes and areas are exact to rounding. With ρ the distance of the farthest corner, a neighbour at
distance L cuts only if ½ (L - (R_max² - R²) / L) < ρ: there the search ends. It ends earlier where small spheres are
far from large ones: no radius is above B + κ L, with B a bound around each element.
"""

import math
from typing import Any, NamedTuple

import numpy as np
from scipy.spatial import KDTree

from bondem._compile import kernel, loop
from bondem._types import Floats, Ints, Vector
from bondem.errors import InputError
from bondem.specimen.cells.polygon import MOST_CORNERS, ROW, SQUARE, clip, copy, height, roomy, roomy_list, square
from bondem.specimen.cells.solids import BOX, LOCAL, Solids
from bondem.specimen.particles import Particles

# Most faces of one cell.
_FACES = 400
# How it ended: all well, too many faces, a neighbour half a period away, nothing left of a cell.
_WELL, _CROWDED, _NARROW, _EMPTY = 0, 1, 2, 3
# Elements of a box among which neighbours are nearer than usual.
_CROWD = 8.0
# κ: slope at which bounds of the radii fall with the distance from large spheres.
_SLOPE = 0.5
# A plane that reaches less deep does not cut, over the spacing of the centres; rounding of coordinates, over extents.
_SHALLOW, _ROUNDING = 1e-12, 4e-15


class Bins(NamedTuple):
    """Centres sorted into boxes, for the search of neighbours.

    Attributes:
        position: centres [m], shape (n, 3).
        radius: radii [m], shape (n,).
        lower, upper: the box around all cells [m], (3,).
        period: edge lengths of the periodic cell, or 0 [m], (3,).
        boxes: number of boxes along each axis, (3,).
        start: start of the members of each box, (boxes + 1,).
        member: elements, box by box, (n,).
        bound: B of each element: no sphere at distance L has a radius above B + κ L [m], (n,).
        first: initial search distance of neighbours, less in crowded boxes [m], (n,).
        reach: usual distance of the farthest neighbour [m].
        tolerance: depth to which planes do not cut [m].
    """

    position: Floats
    radius: Floats
    lower: Vector
    upper: Vector
    period: Vector
    boxes: Ints
    start: Ints
    member: Ints
    bound: Floats
    first: Floats
    reach: float
    tolerance: float


def usual_reach(particles: Particles) -> float:
    """Return the distance within which most elements have all their neighbours [m], about twice that of two of these.

    Raises:
        InputError: Centres coincide.
    """
    x, n = particles.position, len(particles)
    tree = KDTree(x, boxsize=particles.period)
    some = np.linspace(0, n - 1, min(n, 500)).astype(int)
    near = np.asarray(tree.query(x[some], k=min(n, 13))[0]).reshape(len(some), -1)
    reach = 1.5 * float(np.median(near[:, -1]))
    if n == 1:
        reach = 4.0 * particles.mean_radius
    pair = tree.query_pairs(1e-9 * reach, output_type="ndarray")
    if reach <= 0.0 or len(pair):
        name = f"elements {pair[0, 0]} and {pair[0, 1]}" if len(pair) else "elements"
        raise InputError(f"centres of {name} coincide, so that no plane separates their cells; remove one of them")
    return reach


def bins(particles: Particles, lower: Vector, upper: Vector, reach: float) -> Bins:
    """Sort the centres of particles that fill the box from `lower` to `upper` [m]; see `usual_reach`."""
    x, n = particles.position, len(particles)
    extent = upper - lower
    most = max(1, round(2.0 * n ** (1.0 / 3.0)) + 1)
    count = np.clip((extent / (0.5 * reach)).astype(np.int64), 1, 4 * most)
    while count.prod() > 8 * n + 8:
        count = np.maximum(1, count // 2)
    at = np.clip(((x - lower) / extent * count).astype(np.int64), 0, count - 1)
    box = (at[:, 0] * count[1] + at[:, 1]) * count[2] + at[:, 2]
    member = np.argsort(box, kind="stable")
    start = np.concatenate([[0], np.cumsum(np.bincount(box, minlength=int(count.prod())))])
    period = np.zeros(3) if particles.period is None else np.array(particles.period)
    size = reach / 3.0
    tolerance = max(_SHALLOW * size, _ROUNDING * float(np.abs([lower, upper]).max()))
    first = reach * np.minimum(1.0, np.cbrt(_CROWD / np.diff(start)[box]))
    bound = np.full(n, particles.radius.max())
    if particles.period is None:
        bound = np.minimum(bound, _bounds(particles.radius, box, count, extent / count))
    return Bins(x, particles.radius, lower, upper, period, count, start, member, bound, first, reach, tolerance)


def _bounds(radius: Floats, box: Ints, count: Ints, width: Vector) -> Floats:
    """Return B of elements in boxes of some widths: the largest radius of near boxes, and less of far ones, (n,)."""
    most = np.zeros(int(count.prod()))
    np.maximum.at(most, box, radius)
    most = most.reshape(tuple(count))
    for axis in range(3):
        most = np.moveaxis(most, axis, 0)
        near = most.copy()
        near[1:] = np.maximum(near[1:], most[:-1])
        near[:-1] = np.maximum(near[:-1], most[1:])
        # a distance is at least the mean of its parts along the axes, times √3
        fall = _SLOPE / math.sqrt(3.0) * width[axis] * np.arange(len(near))[:, None, None]
        up = np.maximum.accumulate(near + fall) - fall
        down = np.maximum.accumulate((near - fall)[::-1])[::-1] + fall
        most = np.moveaxis(np.maximum(up, down), 0, axis)
    return most.ravel()[box]


class _Room(NamedTuple):
    """A cell under construction: face f has size[f] corners, from row f · MOST_CORNERS on."""

    plane: Floats
    tag: Ints
    size: Ints
    vertex: Floats
    work: Floats
    other: Floats


@kernel(parallel=False)
def _gather(centres, i, near, far, found, offset):
    """List the elements at distances from `near` up to `far` from element i [m], images included."""
    position, period, count = centres.position, centres.period, centres.boxes
    listed = 0
    low, high = np.empty(3, np.int64), np.empty(3, np.int64)
    for c in range(3):
        width = (centres.upper[c] - centres.lower[c]) / count[c]
        low[c] = math.floor((position[i, c] - far - centres.lower[c]) / width)
        high[c] = math.floor((position[i, c] + far - centres.lower[c]) / width)
        if period[c] == 0.0:
            low[c], high[c] = max(low[c], 0), min(high[c], count[c] - 1)
    for a in range(low[0], high[0] + 1):
        wa = a % count[0]
        sa = (a - wa) // count[0] * period[0]
        for b in range(low[1], high[1] + 1):
            wb = b % count[1]
            sb = (b - wb) // count[1] * period[1]
            for c in range(low[2], high[2] + 1):
                wc = c % count[2]
                sc = (c - wc) // count[2] * period[2]
                box = (wa * count[1] + wb) * count[2] + wc
                for k in range(centres.start[box], centres.start[box + 1]):
                    j = centres.member[k]
                    dx = position[j, 0] + sa - position[i, 0]
                    dy = position[j, 1] + sb - position[i, 1]
                    dz = position[j, 2] + sc - position[i, 2]
                    d2 = dx * dx + dy * dy + dz * dz
                    if d2 >= far * far or d2 < near * near or d2 == 0.0:
                        continue
                    if listed == found.size:
                        found, offset = roomy_list(found, listed + 1), roomy(offset, listed + 1)
                    found[listed] = j
                    offset[listed, 0], offset[listed, 1], offset[listed, 2] = dx, dy, dz
                    offset[listed, 3] = math.sqrt(d2)
                    listed += 1
    return listed, found, offset


@loop(parallel=False)
def _sort(offset, listed, order):
    """Return the order of the listed elements, the nearest first (Shell's method)."""
    for p in range(listed):
        order[p] = p
    gap = 1
    while 3 * gap + 1 < listed:
        gap = 3 * gap + 1
    while gap > 0:
        for p in range(gap, listed):
            o, q = order[p], p
            while q >= gap and offset[order[q - gap], 3] > offset[o, 3]:
                order[q] = order[q - gap]
                q -= gap
            order[q] = o
        gap //= 3


@loop(parallel=False)
def _begin(centres, i, half, room):
    """Make the cell a box around its centre, within the box around all cells; return its number of faces."""
    plane = room.plane
    for f in range(6):
        c, far = f // 2, f % 2 == 1
        at = centres.position[i, c]
        plane[f, 0], plane[f, 1], plane[f, 2] = 0.0, 0.0, 0.0
        plane[f, c] = 1.0 if far else -1.0
        wall = np.inf
        if centres.period[c] == 0.0:
            wall = centres.upper[c] - at if far else at - centres.lower[c]
        plane[f, 3] = min(wall, half)
        room.tag[f] = BOX - f if wall <= half else LOCAL
    for f in range(6):
        square(plane[f, 0], plane[f, 1], plane[f, 2], plane[f, 3], 2.0 * half, room.work)
        left = SQUARE
        for g in range(6):
            if g // 2 != f // 2:
                a, b, c, d = plane[g, 0], plane[g, 1], plane[g, 2], plane[g, 3]
                left = clip(room.work, ROW, left, room.other, a, b, c, d)
                copy(room.other, ROW, left, room.work, ROW)
        room.size[f] = left
        copy(room.work, ROW, left, room.vertex, f * MOST_CORNERS)
    return np.int64(6)


@kernel(parallel=False)
def _cut(room, faces, a, b, c, d, behind, farthest, tolerance):
    """Cut a cell of `faces` faces by a plane with the element `behind`; return its faces, -1 if it is not reached."""
    plane, tag, size, vertex, work, other = room
    deepest = -np.inf
    for f in range(faces):
        deepest = max(deepest, height(vertex, f * MOST_CORNERS, size[f], a, b, c, d)[1])
    if deepest <= tolerance:
        return -1
    square(a, b, c, d, 1.01 * farthest, other)
    lid, kept = SQUARE, 0
    for f in range(faces):
        here, there = f * MOST_CORNERS, kept * MOST_CORNERS
        low, high = height(vertex, here, size[f], a, b, c, d)
        if low <= tolerance and high >= -tolerance:  # also what meets the plane at an edge bounds the new face
            lid = clip(other, ROW, lid, work, plane[f, 0], plane[f, 1], plane[f, 2], plane[f, 3])
            copy(work, ROW, lid, other, ROW)
        if high > 0.0:
            left = clip(vertex, here, size[f], work, a, b, c, d)
            if left == 0:
                continue
            copy(work, ROW, left, vertex, there)
            size[kept] = left
        elif kept < f:
            copy(vertex, here, size[f], vertex, there)
            size[kept] = size[f]
        for q in range(4):
            plane[kept, q] = plane[f, q]
        tag[kept] = tag[f]
        kept += 1
    if lid > 0:
        plane[kept, 0], plane[kept, 1], plane[kept, 2], plane[kept, 3] = a, b, c, d
        tag[kept], size[kept] = behind, lid
        copy(other, ROW, lid, vertex, kept * MOST_CORNERS)
        kept += 1
    return kept if kept >= 4 else 0


@kernel(parallel=False)
def _radius(room, faces):
    """Return the distance of the farthest corner from the centre [m]."""
    far, vertex = 0.0, room.vertex
    for f in range(faces):
        for k in range(f * MOST_CORNERS, f * MOST_CORNERS + room.size[f]):
            far = max(far, vertex[k, 0] ** 2 + vertex[k, 1] ** 2 + vertex[k, 2] ** 2)
    return math.sqrt(far)


@loop(parallel=False)
def _narrow(centres, i, room, faces):
    """Return True if a neighbour lies half a period away, because its other image may be a neighbour, too."""
    for f in range(faces):
        j, d = room.tag[f], room.plane[f, 3]
        if j >= 0:
            length = d + math.sqrt(d * d - centres.radius[i] ** 2 + centres.radius[j] ** 2)
            for c in range(3):
                period = centres.period[c]
                if period > 0.0 and abs(room.plane[f, c]) * length > 0.4999999 * period:
                    return True
    return False


@loop(parallel=False)
def _ends(length, own, bound, farthest):
    """Return True if no plane of elements at a distance or beyond cuts, by B."""
    return (1.0 - _SLOPE**2) * length - 2.0 * _SLOPE * bound - (bound**2 - own) / length >= 2.0 * farthest


@loop(parallel=False)
def _needed(own, bound, largest, farthest):
    """Return the distance beyond which no plane cuts: the lesser of those by the largest radius of all and by B."""
    ahead, left = _SLOPE * bound + farthest, 1.0 - _SLOPE**2
    near = (ahead + math.sqrt(ahead * ahead + left * (bound * bound - own))) / left
    return min(near, farthest + math.sqrt(farthest * farthest + largest * largest - own))


@loop(parallel=False)
def _shaped(centres, i, half, largest, room, found, offset, order):
    """Cut the cell of element i out of its box; return its status, its faces, and the lists, which may have grown."""
    faces = _begin(centres, i, half, room)
    farthest, own = _radius(room, faces), centres.radius[i] ** 2
    surplus, bound = largest * largest - own, centres.bound[i]
    near, far = 0.0, centres.first[i]
    while True:
        listed, found, offset = _gather(centres, i, near, far, found, offset)
        if listed > order.size:
            order = roomy_list(order, listed)
        _sort(offset, listed, order)
        for p in range(listed):
            o = order[p]
            length, j = offset[o, 3], found[o]
            if 0.5 * (length - surplus / length) >= farthest or _ends(length, own, bound, farthest):
                break
            d = 0.5 * (length + (own - centres.radius[j] ** 2) / length)
            if d >= farthest:
                continue
            a, b, c = offset[o, 0] / length, offset[o, 1] / length, offset[o, 2] / length
            cut = _cut(room, faces, a, b, c, d, j, farthest, centres.tolerance)
            if cut == 0 or cut > _FACES:
                return _EMPTY if cut == 0 else _CROWDED, faces, found, offset, order
            if cut > 0:
                faces, farthest = cut, _radius(room, cut)
        needed = _needed(own, bound, largest, farthest)
        if far >= needed:
            break
        near, far = far, min(needed, 2.0 * far)
    return _NARROW if _narrow(centres, i, room, faces) else _WELL, faces, found, offset, order


@kernel(parallel=False)
def _cells(centres, chosen, half) -> Any:
    """Compute cells of the chosen elements; see `plain_cells`.

    Returns:
        Status, element, and the arrays face, tag, plane, corner, vertex of `Solids`.
    """
    k = chosen.size
    out_face = np.zeros(k + 1, np.int64)
    out_tag, out_plane = np.empty(20 * k + 20, np.int64), np.empty((20 * k + 20, 4))
    out_corner, out_vertex = np.zeros(20 * k + 21, np.int64), np.empty((100 * k + 100, 3))
    room = _Room(
        np.empty((_FACES + 2, 4)), np.empty(_FACES + 2, np.int64), np.empty(_FACES + 2, np.int64),
        np.empty(((_FACES + 2) * MOST_CORNERS, 3)), np.empty((MOST_CORNERS, 3)), np.empty((MOST_CORNERS, 3)),
    )  # fmt: skip
    found, offset, order = np.empty(256, np.int64), np.empty((256, 4)), np.empty(256, np.int64)
    largest = 0.0
    for i in range(centres.radius.size):
        largest = max(largest, centres.radius[i])
    all_faces, all_corners, status, where = 0, 0, _WELL, -1
    for q in range(k):
        status, faces, found, offset, order = _shaped(
            centres, chosen[q], half[q], largest, room, found, offset, order
        )
        if status != _WELL:
            where = chosen[q]
            break
        out_tag, out_plane = roomy_list(out_tag, all_faces + faces), roomy(out_plane, all_faces + faces)
        out_corner = roomy_list(out_corner, all_faces + faces + 1)
        for f in range(faces):
            out_tag[all_faces] = room.tag[f]
            for c in range(4):
                out_plane[all_faces, c] = room.plane[f, c]
            out_vertex = roomy(out_vertex, all_corners + room.size[f])
            copy(room.vertex, f * MOST_CORNERS, room.size[f], out_vertex, all_corners)
            all_corners += room.size[f]
            all_faces += 1
            out_corner[all_faces] = all_corners
        out_face[q + 1] = all_faces
    return (
        status, where, out_face, out_tag[:all_faces], out_plane[:all_faces], out_corner[: all_faces + 1],
        out_vertex[:all_corners],
    )  # fmt: skip


def plain_cells(centres: Bins, chosen: Ints, half: Floats) -> Solids:
    """Compute Laguerre cells of some elements, within boxes around their centres and the box around all.

    Args:
        centres: all elements.
        chosen: elements of the cells, (k,).
        half: half the widths of their boxes [m], (k,); remaining sides of these have the tag LOCAL.

    Raises:
        InputError: A cell has no volume, or reaches half a period.
    """
    status, where, face, tag, plane, corner, vertex = _cells(centres, chosen, half)
    if status == _EMPTY:
        raise InputError(
            f"the cell of element {where} has no volume: larger spheres enclose it; remove it, or make radii"
            " more alike"
        )
    if status == _NARROW:
        raise InputError(
            f"the cell of element {where} has a neighbour half a period away; enlarge the periodic cell, with more"
            " elements"
        )
    if status == _CROWDED:
        raise InputError(f"the cell of element {where} has more than {_FACES} faces; make radii more alike")
    return Solids(chosen, face, tag, plane, corner, vertex)
