"""The non-local law in a step: extra forces of the stresses found a step before, then the stresses of this one.

What a bond stores, in the frame of its element i, (7, m): gap δ [m], extra force e [N], and the work that its extra
force has taken up [J]. The stress of an element is stored in the element's own frame. Stored like that neither
changes when all turns together.

A step finds the forces of all bonds, each by itself, and then the stresses of all elements, each by itself and from
its bonds in their order; then the loop over blocks (`bondem.kernels.sweep`) adds forces up as those of other bonds.
So no bit depends on threads. What contacts with others and with walls do counts in the stress, as eq (1) has it: with
the lever from the centre to where they touch. Forces of dashpots of bonds do not.

A pass with a time step of 0 finds the forces of a state again: extra forces stay what they are, and gaps and
stresses come out as they were.
"""

import math

import numpy as np

from bondem._compile import device, kernel, loop, prange
from bondem.kernels.bond_pass import branch
from bondem.kernels.walls import wall_gap
from bondem.laws.cell_energy import cross, scalar, turned_by
from bondem.laws.non_local import extra_force
from bondem.laws.rotations import rotate

# Rows of what a bond stores: the first of three each, and the work.
GAP, EXTRA, TAKEN, STORED = 0, 3, 6, 7
# Columns of what a bond does: force on i, torque on i, minus torque on j.
FORCE, TORQUE_I, TORQUE_J, OUTPUT_COLUMNS = 0, 3, 6, 9
# What is done one after the other in a step.
_TURN, _FORCES, _STRESSES, _STAGES = range(4)
# What rounding may take off a principal stress, over the size of the stress.
_ROUNDING = 1e-6


@device
def _column(columns, first, k):
    return columns[first, k], columns[first + 1, k], columns[first + 2, k]


@device
def _column_of(rows, k):
    """The first three columns of a row."""
    return rows[k, 0], rows[k, 1], rows[k, 2]


@device
def _back(q, a):
    """Triple a turned by the inverse of the unit quaternion q."""
    return rotate(q[0], -q[1], -q[2], -q[3], a[0], a[1], a[2])


@device
def _turned_stress(stress, p, q):
    """Stress of element p, turned by q: xx, yy, zz, xy, xz, yz."""
    s = stress[p, 0], stress[p, 1], stress[p, 2], stress[p, 3], stress[p, 4], stress[p, 5]
    x, y, z = turned_by(q, (s[0], s[3], s[4])), turned_by(q, (s[3], s[1], s[5])), turned_by(q, (s[4], s[5], s[2]))
    a = turned_by(q, (x[0], y[0], z[0]))
    b = turned_by(q, (x[1], y[1], z[1]))
    c = turned_by(q, (x[2], y[2], z[2]))
    return a[0], b[1], c[2], a[1], a[2], b[2]


@device
def _mean(one, other):
    return (
        0.5 * (one[0] + other[0]), 0.5 * (one[1] + other[1]), 0.5 * (one[2] + other[2]),
        0.5 * (one[3] + other[3]), 0.5 * (one[4] + other[4]), 0.5 * (one[5] + other[5]),
    )  # fmt: skip


@device
def _normal(table, p, q, k):
    """Unit normal of bond k now: that of the reference, turned with both elements and averaged."""
    n = _column(table.normal, 0, k)
    one, other = turned_by(p, n), turned_by(q, n)
    x, y, z = one[0] + other[0], one[1] + other[1], one[2] + other[2]
    inverse = 1.0 / np.sqrt(x * x + y * y + z * z)
    return inverse * x, inverse * y, inverse * z


@device
def _spring(gap, n, kn, kt):
    """kn δ_n n + kt δ_t."""
    along = (kn - kt) * scalar(gap, n)
    return kt * gap[0] + along * n[0], kt * gap[1] + along * n[1], kt * gap[2] + along * n[2]


@device
def pair_mean(space, i, j):
    """Mean of the stresses of two elements, eq (5) [Pa]."""
    return _mean(
        (space[i, 0], space[i, 1], space[i, 2], space[i, 3], space[i, 4], space[i, 5]),
        (space[j, 0], space[j, 1], space[j, 2], space[j, 3], space[j, 4], space[j, 5]),
    )


@device
def _renewed(table, i, j, p, n, k):
    """The extra force that the stresses and the gap of the last step ask for."""
    old = turned_by(p, _column(table.history, GAP, k))
    along, kt = scalar(old, n), table.kt[k]
    slip = kt * (old[0] - along * n[0]), kt * (old[1] - along * n[1]), kt * (old[2] - along * n[2])
    return extra_force(pair_mean(table.space, i, j), n, table.area[k], table.nu, slip, table.limited)


@loop(parallel=False)
def turn_stresses(pose, table, first, last):
    """Stresses of a step ago of the elements first … last, turned as these are now."""
    for p in range(first, last):
        s = _turned_stress(table.stress, p, (pose[p, 4], pose[p, 5], pose[p, 6], pose[p, 7]))
        for c in range(6):
            table.space[p, c] = s[c]


@loop(parallel=False)
def load_bonds(pose, bonds, table, dt, first, last):
    """Force and torques of the bonds first … last now, into `table.output`; what they store goes on by dt.

    Both forces act at one point, between the two faces of the bond, so that they make no moment together.
    """
    history, output = table.history, table.output
    for k in range(first, last):
        i, j = bonds.i[k], bonds.j[k]
        s = bonds.integrity[k]
        if s <= 0.0:
            for c in range(9):
                output[k, c] = 0.0
            continue
        p, q = (pose[i, 4], pose[i, 5], pose[i, 6], pose[i, 7]), (pose[j, 4], pose[j, 5], pose[j, 6], pose[j, 7])
        n = _normal(table, p, q, k)
        before = _column(history, GAP, k)
        e0 = _column(history, EXTRA, k)
        e = turned_by(p, e0)
        if dt > 0.0:
            e = _renewed(table, i, j, p, n, k)
        a, b = turned_by(p, _column(table.lever_i, 0, k)), turned_by(q, _column(table.lever_j, 0, k))
        d = branch(pose, i, j, bonds.period)
        gap = d[0] + b[0] - a[0], d[1] + b[1] - a[1], d[2] + b[2] - a[2]
        own, e1 = _back(p, gap), _back(p, e)
        if dt > 0.0:
            history[TAKEN, k] += 0.5 * s * (
                (e0[0] + e1[0]) * (own[0] - before[0]) + (e0[1] + e1[1]) * (own[1] - before[1])
                + (e0[2] + e1[2]) * (own[2] - before[2])
            )  # fmt: skip
        for c in range(3):
            history[GAP + c, k] = own[c]
            history[EXTRA + c, k] = e1[c]
        f = _spring(gap, n, table.kn[k], table.kt[k])
        f = s * (f[0] + e[0]), s * (f[1] + e[1]), s * (f[2] + e[2])
        a = a[0] + 0.5 * gap[0], a[1] + 0.5 * gap[1], a[2] + 0.5 * gap[2]
        b = b[0] - 0.5 * gap[0], b[1] - 0.5 * gap[1], b[2] - 0.5 * gap[2]
        ti, tj = cross(a, f), cross(b, f)
        for c in range(3):
            output[k, FORCE + c], output[k, TORQUE_I + c], output[k, TORQUE_J + c] = f[c], ti[c], tj[c]


@device
def _plus(m, l, sign, f):
    """Add ± l ⊗ F to a matrix, by rows."""
    x, y, z = sign * f[0], sign * f[1], sign * f[2]
    return (
        m[0] + l[0] * x, m[1] + l[0] * y, m[2] + l[0] * z, m[3] + l[1] * x, m[4] + l[1] * y, m[5] + l[1] * z,
        m[6] + l[2] * x, m[7] + l[2] * y, m[8] + l[2] * z,
    )  # fmt: skip


@device
def _touched(pose, period, contacts, p, q, m):
    """The same with what other elements and walls do to element p where they touch it, levers in its own frame."""
    c = contacts
    for k in range(c.in_start[p], c.in_start[p + 1]):
        if c.touch[k] != 0:
            a, f = c.first[k], (c.output[k, 0], c.output[k, 1], c.output[k, 2])
            d, share = branch(pose, a, p, period), -c.radius[p] / (c.radius[a] + c.radius[p])
            m = _plus(m, _back(q, (share * d[0], share * d[1], share * d[2])), 1.0, f)
    for e in range(c.out_start[p], c.out_start[p + 1]):
        k = c.out_pair[e]
        if c.touch[k] != 0:
            b, f = c.second[k], (c.output[k, 0], c.output[k, 1], c.output[k, 2])
            d, share = branch(pose, p, b, period), c.radius[p] / (c.radius[p] + c.radius[b])
            m = _plus(m, _back(q, (share * d[0], share * d[1], share * d[2])), -1.0, f)
    for e in range(c.wall_start[p], c.wall_start[p + 1]):
        if c.wall_touch[e] != 0:
            r, f = c.radius[p], (c.wall_output[e, 0], c.wall_output[e, 1], c.wall_output[e, 2])
            distance, x, y, z = wall_gap(pose[p, 0], pose[p, 1], pose[p, 2], r, c.shape, c.walls, c.wall[e])
            arm = -(r + distance)
            m = _plus(m, _back(q, (arm * x, arm * y, arm * z)), -1.0, f)
    return m


@loop(parallel=False)
def element_stresses(pose, bonds, table, contacts, first, last):
    """Stresses of the elements first … last from the forces of this step, in their own frames and in space."""
    output, stress, space = table.output, table.stress, table.space
    for p in range(first, last):
        q = pose[p, 4], pose[p, 5], pose[p, 6], pose[p, 7]
        m = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
        for k in range(table.in_start[p], table.in_start[p + 1]):
            m = _plus(m, _column(table.lever_j, 0, k), -1.0, (output[k, 0], output[k, 1], output[k, 2]))
        for e in range(table.out_start[p], table.out_start[p + 1]):
            k = table.out_bond[e]
            m = _plus(m, _column(table.lever_i, 0, k), 1.0, (output[k, 0], output[k, 1], output[k, 2]))
        if contacts is not None:  # decided when compiled
            m = _touched(pose, bonds.period, contacts, p, q, m)
        one = table.inverse[p]
        # forces into the frame of the levers
        x, y, z = _back(q, (m[0], m[1], m[2])), _back(q, (m[3], m[4], m[5])), _back(q, (m[6], m[7], m[8]))
        stress[p, 0], stress[p, 1], stress[p, 2] = one * x[0], one * y[1], one * z[2]
        stress[p, 3] = 0.5 * one * (x[1] + y[0])
        stress[p, 4] = 0.5 * one * (x[2] + z[0])
        stress[p, 5] = 0.5 * one * (y[2] + z[1])
        # levers into that of the forces
        x, y, z = turned_by(q, (m[0], m[3], m[6])), turned_by(q, (m[1], m[4], m[7])), turned_by(q, (m[2], m[5], m[8]))
        space[p, 0], space[p, 1], space[p, 2] = one * x[0], one * y[1], one * z[2]
        space[p, 3] = 0.5 * one * (x[1] + y[0])
        space[p, 4] = 0.5 * one * (x[2] + z[0])
        space[p, 5] = 0.5 * one * (y[2] + z[1])


@device
def add_stress(pose, table, p, l, sign, f):
    """Add what ± a force f at the lever l, in the element's own frame, does to the stress of element p."""
    x, y, z = _back((pose[p, 4], pose[p, 5], pose[p, 6], pose[p, 7]), f)
    one, stress = sign * table.inverse[p], table.stress
    stress[p, 0] += one * l[0] * x
    stress[p, 1] += one * l[1] * y
    stress[p, 2] += one * l[2] * z
    stress[p, 3] += 0.5 * one * (l[0] * y + l[1] * x)
    stress[p, 4] += 0.5 * one * (l[0] * z + l[2] * x)
    stress[p, 5] += 0.5 * one * (l[1] * z + l[2] * y)


@loop(parallel=False)
def replace_force(pose, period, table, contacts, k, i, j):
    """Take the force of bond k out of the stresses of its ends, and put in that of the contact that follows it.

    Nothing of any other element is looked at, as those may have moved on.
    """
    f = _column_of(table.output, k)
    add_stress(pose, table, i, _column(table.lever_i, 0, k), -1.0, f)
    add_stress(pose, table, j, _column(table.lever_j, 0, k), 1.0, f)
    if contacts is not None:  # decided when compiled
        e = contacts.of_bond[k]
        if e >= 0:
            if contacts.touch[e] != 0:
                a, b = np.int64(contacts.first[e]), np.int64(contacts.second[e])
                d, f = branch(pose, a, b, period), _column_of(contacts.output, e)
                of_a = contacts.radius[a] / (contacts.radius[a] + contacts.radius[b])
                for end in range(2):
                    p, share = (a, of_a) if end == 0 else (b, of_a - 1.0)
                    q = pose[p, 4], pose[p, 5], pose[p, 6], pose[p, 7]
                    l = _back(q, (share * d[0], share * d[1], share * d[2]))
                    add_stress(pose, table, p, l, -1.0 if end == 0 else 1.0, f)


@loop(parallel=False)
def bound_stresses(table, first, last):
    """Bounds of the largest and the least principal stress of the elements first … last, not off by rounding.

    σ = p ± 2 √(J2/3) cos(angle): the largest with arccos(r)/3, the least with arccos(-r)/3.
    """
    space = table.space
    for e in range(first, last):
        mean = (space[e, 0] + space[e, 1] + space[e, 2]) / 3.0
        a, b, c = space[e, 0] - mean, space[e, 1] - mean, space[e, 2] - mean
        x, y, z = space[e, 3], space[e, 4], space[e, 5]
        size = math.sqrt((a * a + b * b + c * c + 2.0 * (x * x + y * y + z * z)) / 6.0)
        high = low = 0.0
        if size > 0.0:
            third = 0.5 * (a * (b * c - z * z) - x * (x * c - z * y) + y * (x * z - b * y)) / (size * size * size)
            angle = math.acos(min(max(third, -1.0), 1.0)) / 3.0
            high, low = 2.0 * math.cos(angle), -2.0 * math.cos(math.pi / 3.0 - angle)
        margin = _ROUNDING * (size + math.fabs(mean))
        table.bound[e, 0] = mean + size * high + margin
        table.bound[e, 1] = mean + size * low - margin


@loop(parallel=False)
def _stage(stage, elements, bonds, table, dt, contacts, breaks, cut, d):
    """What domain d does in a stage of a step: turn stresses, find forces, find stresses."""
    count, n = len(cut.domain) - 1, len(table.inverse)
    first, last = n * d // count, n * (d + 1) // count
    if stage == _TURN:
        turn_stresses(elements.pose, table, first, last)
    elif stage == _FORCES:
        end = min(cut.bond[cut.domain[d + 1]], bonds.m)
        load_bonds(elements.pose, bonds, table, dt, cut.bond[cut.domain[d]], end)
    else:
        element_stresses(elements.pose, bonds, table, contacts, first, last)
        if breaks is not None:  # decided when compiled
            bound_stresses(table, first, last)


@loop(parallel=True)
def _stages(elements, bonds, table, dt, contacts, breaks, cut):
    """All stages, each domain on a thread of its own."""
    for stage in range(_STAGES):
        for d in prange(len(cut.domain) - 1):
            _stage(stage, elements, bonds, table, dt, contacts, breaks, cut, np.int64(d))


@loop(parallel=False)
def non_local_forces(elements, bonds, table, dt, contacts, breaks, cut):
    """Forces of all bonds now, and the stresses that they and the contacts make."""
    if len(cut.domain) > 2:
        _stages(elements, bonds, table, dt, contacts, breaks, cut)
    else:
        for stage in range(_STAGES):
            _stage(stage, elements, bonds, table, dt, contacts, breaks, cut, 0)


@loop(parallel=False)
def non_local_loads(table, sums, row_i, row_j, first, last):
    """Add force and torques of the bonds first … last to the rows of their elements, in their order."""
    output = table.output
    for k in range(first, last):
        i, j = row_i[k], row_j[k]
        for c in range(3):
            sums[i, c] += output[k, FORCE + c]
            sums[j, c] -= output[k, FORCE + c]
            sums[i, 4 + c] += output[k, TORQUE_I + c]
            sums[j, 4 + c] -= output[k, TORQUE_J + c]


@device
def normal_gap(pose, bonds, table, k):
    """Normal part of the gap of a bond [m], square of its tangential part [m²], and where it is [m]."""
    i, j = bonds.i[k], bonds.j[k]
    p, q = (pose[i, 4], pose[i, 5], pose[i, 6], pose[i, 7]), (pose[j, 4], pose[j, 5], pose[j, 6], pose[j, 7])
    n = _normal(table, p, q, k)
    a, b = turned_by(p, _column(table.lever_i, 0, k)), turned_by(q, _column(table.lever_j, 0, k))
    d = branch(pose, i, j, bonds.period)
    gap = d[0] + b[0] - a[0], d[1] + b[1] - a[1], d[2] + b[2] - a[2]
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
        along = scalar(g, n)
        slip = kt[k] * (g[0] - along * n[0]), kt[k] * (g[1] - along * n[1]), kt[k] * (g[2] - along * n[2])
        mean = _mean(
            (stress[i, 0], stress[i, 1], stress[i, 2], stress[i, 3], stress[i, 4], stress[i, 5]),
            (stress[j, 0], stress[j, 1], stress[j, 2], stress[j, 3], stress[j, 4], stress[j, 5]),
        )
        e = extra_force(mean, n, area[k], nu, slip, limited)
        force[k, 0], force[k, 1], force[k, 2] = e
