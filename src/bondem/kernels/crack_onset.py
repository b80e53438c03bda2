"""What the stresses of cells lead to as a step begins: cells yield, and facets begin to crack.

They are found with the elements where they have come to, so that no bit depends on where a run pauses. Each cell and
each facet is on its own, whatever thread it is on.
"""

import numpy as np

from bondem._compile import device, loop, prange
from bondem.kernels.cell_stress import cell_stresses, pair_stress, surface_stresses
from bondem.kernels.cell_yield import book_loads, stretch_cells, stretch_grips, yield_cells
from bondem.kernels.crack_energy import bending_opening, bending_traction
from bondem.kernels.single_facets import column, orientation, present_normal, resistance
from bondem.kernels.stress_index import by_address, cool_cells, reaches
from bondem.laws.cell_energy import scalar, turned_by
from bondem.laws.plasticity import below
from bondem.laws.softening import left_on_plane, plus

# Below this many cells launching threads costs more than the loop.
_SERIAL = 1000
# Cells of one portion of work.
_PORTION = 500
# What is done to a portion.
_STRESSES, _YIELDING, _FACETS, _PLANES = range(4)


@device
def agreed_stress(s, n, t):
    """Mean tensor of two cells made to agree with the traction t of their facet [Pa]."""
    x = t[0] - (s[0] * n[0] + s[3] * n[1] + s[4] * n[2])
    y = t[1] - (s[3] * n[0] + s[1] * n[1] + s[5] * n[2])
    z = t[2] - (s[4] * n[0] + s[5] * n[1] + s[2] * n[2])
    along = x * n[0] + y * n[1] + z * n[2]
    return (
        s[0] + 2.0 * x * n[0] - along * n[0] * n[0],
        s[1] + 2.0 * y * n[1] - along * n[1] * n[1],
        s[2] + 2.0 * z * n[2] - along * n[2] * n[2],
        s[3] + x * n[1] + y * n[0] - along * n[0] * n[1],
        s[4] + x * n[2] + z * n[0] - along * n[0] * n[2],
        s[5] + y * n[2] + z * n[1] - along * n[1] * n[2],
    )


@device
def sheared_off(t, across, strength):
    """Whether the traction t of a pressed facet has a principal stress beyond `strength` by itself."""
    return scalar(t, t) - across * across >= strength * (strength - across)


@device
def pulled_by_bending(t, across, n, bent):
    """A traction, and how much of it is along n, with what bending adds to it [Pa]."""
    if bent > 0.0:
        pulled = max(across, 0.0) + bent
        return plus(t, pulled - across, n), pulled
    return t, across


@loop(parallel=False)
def _begin_facets(pose, bonds, cells, stress, onset, plane, first, last):
    """Mark facets that begin to crack: they are pulled or sheared, and σ* reaches the strength of the criterion.

    Bending adds to the traction that pulls (`bondem.laws.softening`). The strength is f_t for the largest principal
    stress, or 1 for the index of another criterion, of which no facet cracks that is not pulled.
    """
    at_i, at_j, hotter, marked, listed = bonds.i, bonds.j, onset.hotter, onset.marked, onset.listed
    force, normal, tensor, area, strength = cells.force, cells.normal, stress.tensor, onset.area, onset.strength
    matrix = np.empty((3, 3))
    for k in range(first, last):
        i, j = at_i[k], at_j[k]
        marked[k] = 0
        hot = max(hotter[i], hotter[j])
        if hot == 0 or listed[k] != 0:
            continue
        if hot == 2:
            marked[k] = 2
            continue
        if plane[k] != 0:
            continue
        n = turned_by(orientation(pose, i), column(normal, k))
        f, A = column(force, k), area[k]
        t = f[0] / A, f[1] / A, f[2] / A
        mean = pair_stress(tensor, i, j)
        p, q = orientation(pose, i), orientation(pose, j)
        bent = bending_opening(p, q, cells.bends[k], resistance(cells, 1.0, k), mean)
        across = scalar(t, n)
        t, across = pulled_by_bending(t, across, n, bent)
        if across <= 0.0 and (onset.judge != 0 or not sheared_off(t, across, strength[k])):
            continue
        s = agreed_stress(mean, n, t)
        if onset.judge == 0:
            if not below(s, strength[k]):
                marked[k] = 1
        elif reaches(by_address, onset, s, onset.tension / strength[k], matrix):
            marked[k] = 1


@loop(parallel=False)
def _begin_planes(pose, bonds, cells, onset, cracks, first, last):
    """Mark those of the facets first … last of material planes that begin to crack by their own traction."""
    listed, marked, area, force = onset.listed, onset.marked, onset.area, cells.force
    for e in range(first, last):
        k = onset.plane[e]
        if listed[k] != 0 or marked[k] != 0:
            continue
        f, A, p, q = column(force, k), area[k], orientation(pose, bonds.i[k]), orientation(pose, bonds.j[k])
        bent = bending_traction(p, q, cells.bends[k], resistance(cells, 1.0, k))
        t, n = (f[0] / A, f[1] / A, f[2] / A), present_normal(pose, bonds, cells, k)
        left = left_on_plane(
            1.0, t, n, bent, onset.strength[k], cracks.last[k], cracks.cohesion[k], cracks.last_slip[k],
            cracks.friction[k], cracks.kink, cracks.steep,
        )  # fmt: skip
        if left < 1.0:
            marked[k] = 1


@loop(parallel=False)
def _portion(kind, pose, bonds, cells, stress, flow, onset, cracks, cell, facet, plane):
    """Do what `kind` says to the cells, facets or planes from the first of a pair of numbers to the second."""
    if kind == _STRESSES:
        cell_stresses(cells.moment, stress, cell[0], cell[1])
    elif kind == _YIELDING:
        yield_cells(pose, stress, flow, onset.hot, onset.cracked, onset.hotter, cell[0], cell[1])
        if onset.judge != 0:
            cool_cells(stress, onset, cell[0], cell[1])
        if flow.yielding:
            stretch_cells(cells, flow, False, cell[0], cell[1])
    elif kind == _FACETS:
        _begin_facets(pose, bonds, cells, stress, onset, cracks.plane, facet[0], facet[1])
    else:
        _begin_planes(pose, bonds, cells, onset, cracks, plane[0], plane[1])


@loop(parallel=True)
def _portions(kind, pose, bonds, cells, stress, flow, onset, cracks, count):
    n, m, planes = len(pose), bonds.m, len(onset.plane)
    for d in prange(count):
        cell, facet = (n * d // count, n * (d + 1) // count), (m * d // count, m * (d + 1) // count)
        plane = planes * d // count, planes * (d + 1) // count
        _portion(kind, pose, bonds, cells, stress, flow, onset, cracks, cell, facet, plane)


@loop(parallel=False)
def judge_body(pose, bonds, body, work, table, threaded):
    """Find the stresses of all cells a step ago, let cells yield, and mark facets that begin to crack.

    Returns:
        Whether any facet begins.
    """
    cells, grips, n = body.cells, body.grips, len(pose)
    stress, flow, onset, cracks = table.stress, table.flow, table.onset, table.facets
    for kind in range(4):  # one call in the code, as everything in it is compiled for each
        if kind == _FACETS and onset.hotter.max() == 0:
            continue
        if kind == _PLANES and len(onset.plane) == 0:
            continue
        if threaded and n >= _SERIAL:
            _portions(kind, pose, bonds, cells, stress, flow, onset, cracks, n // _PORTION)
        else:
            every = (0, n), (0, bonds.m), (0, len(onset.plane))
            _portion(kind, pose, bonds, cells, stress, flow, onset, cracks, every[0], every[1], every[2])
        if kind == _STRESSES:
            surface_stresses(pose, grips, body.presses, stress, flow.pressed)
        elif kind == _YIELDING:
            book_loads(body.presses, flow, work)
            stretch_grips(grips, flow)
    return onset.marked.max() > 0
