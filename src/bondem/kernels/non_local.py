"""The non-local law in a step: extra forces of the stresses found a step before, then the stresses of this one.

What a bond stores, in the frame of its element i, (7, m): gap δ [m], extra force e [N], and the work that its extra
force has taken up [J]. The stress of an element is stored in the element's own frame. Stored like that neither
changes when all turns together.

A pass with a time step of 0 finds the forces of a state again: extra forces stay what they are, and gaps and
stresses come out as they were.
"""

import numpy as np

from bondem._compile import device, kernel, loop
from bondem.kernels.bond_pass import branch
from bondem.laws.cell_energy import cross, scalar, turned_by
from bondem.laws.non_local import extra_force
from bondem.laws.rotations import rotate

# Rows of what a bond stores: the first of three each, and the work.
GAP, EXTRA, TAKEN, STORED = 0, 3, 6, 7


@device
def _column(columns, first, k):
    return columns[first, k], columns[first + 1, k], columns[first + 2, k]


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
def _add_virial(sums, p, sign, lever, f):
    """Add the symmetric part of ± l ⊗ F."""
    sums[p, 0] += sign * lever[0] * f[0]
    sums[p, 1] += sign * lever[1] * f[1]
    sums[p, 2] += sign * lever[2] * f[2]
    sums[p, 3] += sign * 0.5 * (lever[0] * f[1] + lever[1] * f[0])
    sums[p, 4] += sign * 0.5 * (lever[0] * f[2] + lever[2] * f[0])
    sums[p, 5] += sign * 0.5 * (lever[1] * f[2] + lever[2] * f[1])


@device
def _renewed(table, i, j, p, q, n, k):
    """The extra force that the stresses and the gap of the last step ask for."""
    mean = _mean(_turned_stress(table.stress, i, p), _turned_stress(table.stress, j, q))
    old = turned_by(p, _column(table.history, GAP, k))
    along, kt = scalar(old, n), table.kt[k]
    slip = kt * (old[0] - along * n[0]), kt * (old[1] - along * n[1]), kt * (old[2] - along * n[2])
    return extra_force(mean, n, table.area[k], table.nu, slip, table.limited)


@loop(parallel=False)
def non_local_loads(pose, bonds, table, dt, sums, row_i, row_j, first, last):
    """Add force and torques of the bonds first … last to the rows of their elements in `sums`, and their stresses.

    Both forces act at one point, between the two faces of the bond, so that they make no moment together. One by one
    and in order: what an element gets does not depend on how a step is cut.
    """
    history = table.history
    for k in range(first, last):
        i, j = bonds.i[k], bonds.j[k]
        s = bonds.integrity[k]
        p, q = (pose[i, 4], pose[i, 5], pose[i, 6], pose[i, 7]), (pose[j, 4], pose[j, 5], pose[j, 6], pose[j, 7])
        n = _normal(table, p, q, k)
        before = _column(history, GAP, k)
        e0 = _column(history, EXTRA, k)
        e = turned_by(p, e0)
        if dt > 0.0:
            e = _renewed(table, i, j, p, q, n, k)
        here, there = _column(table.lever_i, 0, k), _column(table.lever_j, 0, k)
        a, b = turned_by(p, here), turned_by(q, there)
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
        _add_virial(table.sums, i, 1.0, here, _back(p, f))
        _add_virial(table.sums, j, -1.0, there, _back(q, f))
        a = a[0] + 0.5 * gap[0], a[1] + 0.5 * gap[1], a[2] + 0.5 * gap[2]
        b = b[0] - 0.5 * gap[0], b[1] - 0.5 * gap[1], b[2] - 0.5 * gap[2]
        ti, tj = cross(a, f), cross(b, f)
        for c in range(3):
            sums[row_i[k], c] += f[c]
            sums[row_j[k], c] -= f[c]
            sums[row_i[k], 4 + c] += ti[c]
            sums[row_j[k], 4 + c] -= tj[c]


@loop(parallel=False)
def settle_stress(table):
    """Stresses of the elements from their sums, which are left at zero."""
    for p in range(len(table.inverse)):
        for c in range(6):
            table.stress[p, c] = table.inverse[p] * table.sums[p, c]
            table.sums[p, c] = 0.0


@loop(parallel=False)
def non_local_energies(pose, bonds, table):
    """Normal and shear energy of the springs, and the work that extra forces have taken up [J]."""
    normal = slip = taken = 0.0
    for k in range(bonds.m):
        i, j = bonds.i[k], bonds.j[k]
        p, q = (pose[i, 4], pose[i, 5], pose[i, 6], pose[i, 7]), (pose[j, 4], pose[j, 5], pose[j, 6], pose[j, 7])
        n = _normal(table, p, q, k)
        a, b = turned_by(p, _column(table.lever_i, 0, k)), turned_by(q, _column(table.lever_j, 0, k))
        d = branch(pose, i, j, bonds.period)
        gap = d[0] + b[0] - a[0], d[1] + b[1] - a[1], d[2] + b[2] - a[2]
        along = scalar(gap, n)
        s = bonds.integrity[k]
        normal += 0.5 * s * table.kn[k] * along * along
        slip += 0.5 * s * table.kt[k] * (scalar(gap, gap) - along * along)
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
