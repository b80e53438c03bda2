"""The non-local law in a step: extra forces of the stresses found a step before, then the stresses of this one.

What a bond stores, in the frame of its element i, (7, m): gap δ [m], extra force e [N], and the work that its extra
force has taken up [J]. The stress of an element is stored in the element's own frame. Stored like that neither
changes when all turns together.

A step finds the forces of all bonds, WIDTH at a time (`bondem.kernels.lanes`), and then the stresses of all elements
(`bondem.kernels.lagged_stress`); then the loop over blocks (`bondem.kernels.sweep`) adds forces up as those of other
bonds. What bonds do to an element is added in the order of the bonds, so that no bit depends on threads.

A pass with a time step of 0 finds the forces of a state again: extra forces stay what they are, and gaps and
stresses come out as they were.
"""

import math

import numpy as np

from bondem._compile import device, kernel, loop, prange
from bondem.kernels.bond_pass import ahead, apart, branch, group, groups
from bondem.kernels.lagged_stress import (
    add_touches,
    back,
    element_stresses,
    gather_moments,
    lever_moments,
    mean_of,
    pair_mean,
    turn_stresses,
)
from bondem.kernels.lane_memory import add_loads, add_rows, places, put_side, row, side
from bondem.kernels.lanes import where_positive
from bondem.kernels.single_facets import column
from bondem.laws.cell_energy import cross, opened, scalar, turned_by
from bondem.laws.non_local import extra_force

# Rows of what a bond stores: the first of three each, and the work.
GAP, EXTRA, TAKEN, STORED = 0, 3, 6, 7
# Rows of what bonds do: force on i, torque on i, minus torque on j.
FORCE, TORQUE_I, TORQUE_J, OUTPUT_ROWS = 0, 3, 6, 9
# What is done one after the other in a step.
_TURN, _FORCES, _GATHER, _STRESSES, _STAGES = range(5)
# Keeps 0 / 0 away where an element has turned right round, and changes no other number.
_NOTHING = 1e-200


@device
def _rows(table, first):
    """Three rows of a table, taken once outside of a loop."""
    return table[first], table[first + 1], table[first + 2]


@device
def _triple(rows, k):
    return side(rows[0], k), side(rows[1], k), side(rows[2], k)


@device
def _put_triple(rows, k, a, known):
    put_side(rows[0], k, a[0], known)
    put_side(rows[1], k, a[1], known)
    put_side(rows[2], k, a[2], known)


@device
def _where_positive(s, a, b):
    return where_positive(s, a[0], b[0]), where_positive(s, a[1], b[1]), where_positive(s, a[2], b[2])


@device
def _normal(p, q, n):
    """A unit normal now: that of the reference, turned with both elements and averaged."""
    one, other = turned_by(p, n), turned_by(q, n)
    x, y, z = one[0] + other[0], one[1] + other[1], one[2] + other[2]
    inverse = 1.0 / math.sqrt(x * x + y * y + z * z + _NOTHING)
    return inverse * x, inverse * y, inverse * z


@device
def _spring(gap, n, kn, kt):
    """kn δ_n n + kt δ_t."""
    along = (kn - kt) * scalar(gap, n)
    return kt * gap[0] + along * n[0], kt * gap[1] + along * n[1], kt * gap[2] + along * n[2]


@device
def _slip(gap, n, kt):
    """kt δ_t."""
    along = scalar(gap, n)
    return kt * (gap[0] - along * n[0]), kt * (gap[1] - along * n[1]), kt * (gap[2] - along * n[2])


@loop(parallel=False)
def load_bonds(pose, bonds, table, dt, first, last):
    """Force and torques of the bonds first … last now, into `table.output`; what they store goes on by dt.

    Both forces act at one point, between the two faces of the bond, so that they make no moment together. What they
    do to the stresses of both elements is added to `table.moment`. What broken bonds store stays what it is.
    """
    stored, extra, taken = _rows(table.history, GAP), _rows(table.history, EXTRA), table.history[TAKEN]
    force, on_i, on_j = _rows(table.output, FORCE), _rows(table.output, TORQUE_I), _rows(table.output, TORQUE_J)
    normal, lever_i, lever_j = _rows(table.normal, 0), _rows(table.lever_i, 0), _rows(table.lever_j, 0)
    for g in range(groups(first, last)):
        k, known = group(first, last, g)
        ahead(bonds, pose, k, last)
        i, j = places(bonds.i, k), places(bonds.j, k)
        u, v, s = row(pose, i), row(pose, j), side(bonds.integrity, k)
        p, q = (u[4], u[5], u[6], u[7]), (v[4], v[5], v[6], v[7])
        n, kn, kt = _normal(p, q, _triple(normal, k)), side(table.kn, k), side(table.kt, k)
        before, e0 = _triple(stored, k), _triple(extra, k)
        e = turned_by(p, e0)
        if dt > 0.0:
            mean = mean_of(row(table.space, i), row(table.space, j))
            e = extra_force(mean, n, side(table.area, k), table.nu, _slip(turned_by(p, before), n, kt), table.limited)
        a, b = turned_by(p, _triple(lever_i, k)), turned_by(q, _triple(lever_j, k))
        gap = opened(apart(u, v, bonds.period), a, b)
        own, e1 = back(p, gap), back(p, e)
        if dt > 0.0:
            work = (
                (e0[0] + e1[0]) * (own[0] - before[0]) + (e0[1] + e1[1]) * (own[1] - before[1])
                + (e0[2] + e1[2]) * (own[2] - before[2])
            )  # fmt: skip
            put_side(taken, k, side(taken, k) + 0.5 * s * work, known)
        _put_triple(stored, k, _where_positive(s, own, before), known)
        _put_triple(extra, k, _where_positive(s, e1, e0), known)
        f = _spring(gap, n, kn, kt)
        f = s * (f[0] + e[0]), s * (f[1] + e[1]), s * (f[2] + e[2])
        add_rows(table.moment, places(table.to_i, k), j, lever_moments(a, f, 1.0), lever_moments(b, f, -1.0), known)
        a = a[0] + 0.5 * gap[0], a[1] + 0.5 * gap[1], a[2] + 0.5 * gap[2]
        b = b[0] - 0.5 * gap[0], b[1] - 0.5 * gap[1], b[2] - 0.5 * gap[2]
        _put_triple(force, k, f, known)
        _put_triple(on_i, k, cross(a, f), known)
        _put_triple(on_j, k, cross(b, f), known)


@loop(parallel=False)
def _stage(stage, elements, bonds, table, dt, contacts, cut, d):
    """What domain d does in a stage of a step: turn stresses, find forces, find stresses."""
    count, n, shared = len(cut.domain) - 1, len(table.inverse), len(cut.shared)
    first, last = n * d // count, n * (d + 1) // count
    if stage == _TURN:
        turn_stresses(elements.pose, table, first, last)
    elif stage == _FORCES:
        load_bonds(elements.pose, bonds, table, dt, cut.bond[cut.domain[d]], cut.bond[cut.domain[d + 1]])
    elif stage == _GATHER:
        gather_moments(table.moment, cut.shared, n, cut.part, shared * d // count, shared * (d + 1) // count)
    else:
        if contacts is not None:  # decided when compiled
            add_touches(elements.pose, bonds.period, contacts, table.moment, first, last)
        element_stresses(elements.pose, table, first, last)


@loop(parallel=True)
def _stages(elements, bonds, table, dt, contacts, cut):
    """All stages, each domain on a thread of its own."""
    for stage in range(_STAGES):
        for d in prange(len(cut.domain) - 1):
            _stage(stage, elements, bonds, table, dt, contacts, cut, np.int64(d))


@loop(parallel=False)
def non_local_forces(elements, bonds, table, dt, contacts, cut):
    """Forces of all bonds now, and the stresses that they and the contacts make."""
    if len(cut.domain) > 2:
        _stages(elements, bonds, table, dt, contacts, cut)
    else:
        for stage in range(_STAGES):
            _stage(stage, elements, bonds, table, dt, contacts, cut, 0)


@loop(parallel=False)
def non_local_loads(table, sums, row_i, row_j, first, last):
    """Add force and torques of the bonds first … last to the rows of their elements, in their order."""
    force, on_i, on_j = _rows(table.output, FORCE), _rows(table.output, TORQUE_I), _rows(table.output, TORQUE_J)
    for g in range(groups(first, last)):
        k, known = group(first, last, g)
        f, t, u = _triple(force, k), _triple(on_i, k), _triple(on_j, k)
        f = -f[0], -f[1], -f[2]
        u = -u[0], -u[1], -u[2]
        add_loads(sums, places(row_i, k), places(row_j, k), f, t, u, known)


@device
def normal_gap(pose, bonds, table, k):
    """Normal part of the gap of a bond [m], square of its tangential part [m²], and where it is [m]."""
    i, j = bonds.i[k], bonds.j[k]
    p, q = (pose[i, 4], pose[i, 5], pose[i, 6], pose[i, 7]), (pose[j, 4], pose[j, 5], pose[j, 6], pose[j, 7])
    n = _normal(p, q, column(table.normal, k))
    a, b = turned_by(p, column(table.lever_i, k)), turned_by(q, column(table.lever_j, k))
    gap = opened(branch(pose, i, j, bonds.period), a, b)
    along = scalar(gap, n)
    place = pose[i, 0] + a[0] + 0.5 * gap[0], pose[i, 1] + a[1] + 0.5 * gap[1], pose[i, 2] + a[2] + 0.5 * gap[2]
    return along, scalar(gap, gap) - along * along, place


@loop(parallel=False)
def non_local_energies(pose, bonds, table):
    """Normal and shear energy of the springs, and the work that extra forces have taken up [J]."""
    normal = slip = taken = 0.0
    for k in range(bonds.m):
        s = bonds.integrity[k]
        if s > 0.0:
            along, across, _ = normal_gap(pose, bonds, table, k)
            normal += 0.5 * s * table.kn[k] * along * along
            slip += 0.5 * s * table.kt[k] * across
        taken += table.history[TAKEN, k]
    return normal, slip, taken


@kernel(parallel=False)
def small_extra_forces(pairs, area, kt, nu, limited, normal, stress, gap, force):
    """Extra forces at small strain from the stresses (n, 6) and gaps (m, 3) of the iteration before, into (m, 3)."""
    for k in range(len(pairs)):
        i, j = pairs[k, 0], pairs[k, 1]
        n = normal[k, 0], normal[k, 1], normal[k, 2]
        g = gap[k, 0], gap[k, 1], gap[k, 2]
        e = extra_force(pair_mean(stress, i, j), n, area[k], nu, _slip(g, n, kt[k]), limited)
        force[k, 0], force[k, 1], force[k, 2] = e
