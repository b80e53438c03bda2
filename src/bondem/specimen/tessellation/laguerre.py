"""Plain Laguerre cells: the points x for which one sphere has the least power |x - c|² - R² (centre c, radius R).

A cell begins as a box and is cut by the radical plane of one neighbour after another, in the order of their distance.
Every face is a polygon of its own, cut by planes, without any record of connections. Degenerate cases are therefore
harmless, and volumes and areas are exact to rounding. Let ρ be the distance of the farthest corner and R_max the
largest radius. A neighbour at distance L cuts only if ½ (L - (R_max² - R²) / L) < ρ, so that the search ends beyond.
It ends earlier where small spheres are far from large ones, as no radius there is above B + L / 2, with a bound B.
"""

import math

import numpy as np
from scipy.spatial import KDTree

from bondem._core import run_pass
from bondem._indices import group_starts
from bondem._passes import calls
from bondem._tables.tessellation_tables import Bins, CellRequest, CellRoom, Solids
from bondem._types import Floats, Ints, Vector
from bondem.errors import InputError
from bondem.specimen.particles import Particles
from bondem.specimen.tessellation.polygon_buffer import (
    MOST_CORNERS,
    new_buffer,
    polygon_buffer,
    roomier_buffer,
    solids_in,
)

# Largest number of faces of a cell.
_FACES = 400
# Number of elements in a box from which neighbours are first searched within less than the usual distance.
_CROWD = 8.0
# κ: slope at which bounds of the radii fall with the distance from large spheres.
_SLOPE = 0.5
# Least depth of a plane that cuts, over the spacing of the centres, and over the largest coordinate, for rounding.
_SHALLOW, _ROUNDING = 1e-12, 4e-15


def usual_reach(particles: Particles) -> float:
    """Return the distance within which most elements have all their neighbours [m], about twice that of the nearest.

    Raises:
        InputError: Centres coincide.
    """
    x, n = particles.position, len(particles)
    tree = KDTree(x, boxsize=particles.period)
    some = np.linspace(0, n - 1, min(n, 500)).astype(int)
    near = np.asarray(tree.query(x[some], k=min(n, 13))[0]).reshape(len(some), -1)
    reach = 1.5 * float(np.median(near[:, -1]))
    if n == 1:
        reach = max(4.0 * particles.mean_radius, particles.envelope.volume ** (1.0 / 3.0))
    pair = tree.query_pairs(1e-9 * reach, output_type="ndarray")
    if reach <= 0.0 or len(pair):
        name = f"elements {pair[0, 0]} and {pair[0, 1]}" if len(pair) else "elements"
        raise InputError(f"centres of {name} coincide, so that no plane separates their cells; remove one of them")
    return reach


def bins(particles: Particles, lower: Vector, upper: Vector, reach: float) -> Bins:
    """Sort the centres of elements into a grid of equal boxes, for the search of neighbours.

    The grid fills the box with the corners `lower` and `upper` [m], (3,) each; `usual_reach` returns `reach` [m].
    """
    x, n = particles.position, len(particles)
    lower, upper = np.array(lower, dtype=float), np.array(upper, dtype=float)
    extent = upper - lower
    most = max(1, round(2.0 * n ** (1.0 / 3.0)) + 1)
    count = np.clip((extent / (0.5 * reach)).astype(np.int64), 1, 4 * most)
    while count.prod() > 8 * n + 8:
        count = np.maximum(1, count // 2)
    at = np.clip(((x - lower) / extent * count).astype(np.int64), 0, count - 1)
    box = (at[:, 0] * count[1] + at[:, 1]) * count[2] + at[:, 2]
    member = np.argsort(box, kind="stable")
    start = group_starts(box, int(count.prod()))
    period = np.zeros(3) if particles.period is None else np.array(particles.period)
    size = reach / 3.0
    tolerance = max(_SHALLOW * size, _ROUNDING * float(np.abs([lower, upper]).max()))
    first = reach * np.minimum(1.0, np.cbrt(_CROWD / np.diff(start)[box]))
    bound = np.full(n, particles.radius.max())
    if particles.period is None:
        bound = np.minimum(bound, _bounds(particles.radius, box, count, extent / count))
    return Bins(x, particles.radius, lower, upper, period, count, start, member, bound, first, reach, tolerance)


def _bounds(radius: Floats, box: Ints, count: Ints, width: Vector) -> Floats:
    """Return bounds at elements [m], (n,): at a distance L, no radius is above the bound + L / 2."""
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


def new_cell_request(chosen: Ints, half: Floats) -> CellRequest:
    """Return a request for the cells of chosen elements (k,), in boxes of half widths (k,) [m]; none is made yet."""
    return CellRequest(chosen, half, *_lists(256), np.zeros(len(chosen) + 1, np.int64), np.zeros(2, np.int64))


def roomier_request(request: CellRequest) -> CellRequest:
    """Return a copy of a request for cells, with longer lists of neighbours."""
    return CellRequest(*request[:2], *_lists(2 * len(request.found)), *request[5:])


def _lists(room: int) -> tuple[Ints, Floats, Ints]:
    return np.empty(room, np.int64), np.empty((room, 4)), np.empty(room, np.int64)


def new_cell_room() -> CellRoom:
    """Return work arrays for the largest possible cell."""
    faces = _FACES + 2
    return CellRoom(
        np.empty((faces, 4)), np.empty(faces, np.int64), np.empty(faces, np.int64),
        np.empty((faces * MOST_CORNERS, 3)), polygon_buffer(), polygon_buffer(),
    )  # fmt: skip


def plain_cells(centres: Bins, chosen: Ints, half: Floats) -> Solids:
    """Compute Laguerre cells of some elements, within boxes around their centres and the box around all.

    Args:
        centres: all elements.
        chosen: elements of the cells, (k,).
        half: half the widths of their boxes [m], (k,); faces that remain on these have the `Solids.tag` -7.

    Raises:
        InputError: A cell has no volume or too many faces, or reaches half a period.
    """
    request, room = new_cell_request(chosen, half), new_cell_room()
    pile = new_buffer(20 * len(chosen) + 20, 100 * len(chosen) + 100)
    while (ended := run_pass(calls.make_cells(centres, request, room, pile))) in ("lists_full", "pile_full"):
        if ended == "lists_full":
            request = roomier_request(request)
        else:
            pile = roomier_buffer(pile)
    where = request.done[1]
    faults = {
        "swallowed": "no volume: larger spheres enclose it; remove it, or make radii more alike",
        "narrow": "a neighbour half a period away; enlarge the periodic cell, with more elements",
        "crowded": f"more than {_FACES} faces; make radii more alike",
    }
    if ended in faults:
        raise InputError(f"the cell of element {where} has {faults[ended]}")
    return solids_in(pile, chosen, request.end)
