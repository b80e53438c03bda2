"""Stresses of elements of the non-local law, from the forces of their bonds and contacts, eq (1).

The stress of an element is kept in its own frame, where it does not change when all turns together, and in space,
where bonds take the mean of both ends. What contacts with others and with walls do counts, with the lever from the
centre to where they touch; forces of dashpots of bonds do not.
"""

import math

import numpy as np

from bondem._compile import device, loop
from bondem.kernels.bond_pass import branch
from bondem.kernels.lane_memory import clear_row, entry, number_in, places_from, put_entry, put_row, row
from bondem.kernels.lanes import WIDTH, zero_of
from bondem.kernels.single_facets import column
from bondem.kernels.walls import wall_gap
from bondem.laws.cell_energy import turned_by
from bondem.laws.rotations import rotate

#: Columns of a stress in space that hold bounds of its largest and its least principal stress.
LARGEST, LEAST = 6, 7
# 2 cos(arccos(r) / 3) is a polynomial of √((1 + r) / 2), to 4e-7 (interpolated at Chebyshev's points).
_TRISECTED = (
    1.0000003719387707, 1.1546638041491451, -0.22161094179544857, 0.10294952669157148, -0.052799498696539826,
    0.021003507189659234, -0.004206982020150463,
)  # fmt: skip
# What that and rounding may take off a principal stress, over the size of the stress.
_MARGIN = 1e-6
# Keeps 0 / 0 away [Pa³]: no stress that matters changes.
_NOTHING = 1e-200


@device
def back(q, a):
    """Triple a turned by the inverse of the unit quaternion q."""
    return rotate(q[0], -q[1], -q[2], -q[3], a[0], a[1], a[2])


@device
def _turned(s, q):
    """A stress xx, yy, zz, xy, xz, yz turned by q."""
    x, y, z = turned_by(q, (s[0], s[3], s[4])), turned_by(q, (s[3], s[1], s[5])), turned_by(q, (s[4], s[5], s[2]))
    a = turned_by(q, (x[0], y[0], z[0]))
    b = turned_by(q, (x[1], y[1], z[1]))
    c = turned_by(q, (x[2], y[2], z[2]))
    return a[0], b[1], c[2], a[1], a[2], b[2]


@device
def mean_of(one, other):
    """Mean of two stresses, eq (5) [Pa]."""
    return (
        0.5 * (one[0] + other[0]), 0.5 * (one[1] + other[1]), 0.5 * (one[2] + other[2]),
        0.5 * (one[3] + other[3]), 0.5 * (one[4] + other[4]), 0.5 * (one[5] + other[5]),
    )  # fmt: skip


@device
def pair_mean(space, i, j):
    """That of elements i and j of a table."""
    return mean_of(
        (space[i, 0], space[i, 1], space[i, 2], space[i, 3], space[i, 4], space[i, 5]),
        (space[j, 0], space[j, 1], space[j, 2], space[j, 3], space[j, 4], space[j, 5]),
    )


@device
def lever_moments(l, f, sign):
    """± l ⊗ F, symmetric part, as a row: xx, yy, zz, xy, xz, yz, and two zeros [N·m]."""
    half, none = 0.5 * sign, zero_of(f[0])
    return (
        sign * l[0] * f[0], sign * l[1] * f[1], sign * l[2] * f[2], half * (l[0] * f[1] + l[1] * f[0]),
        half * (l[0] * f[2] + l[2] * f[0]), half * (l[1] * f[2] + l[2] * f[1]), none, none,
    )  # fmt: skip


@loop(parallel=False)
def turn_stresses(pose, table, first, last):
    """Stresses of a step ago of the elements first … last, turned as these are now."""
    end = np.uint64(last)
    for g in range((last - first + WIDTH - 1) // WIDTH):
        p = places_from(np.uint64(first) + np.uint64(WIDTH) * np.uint64(g), end)
        x = row(pose, p)
        s = _turned(_own(table.stress, p), (x[4], x[5], x[6], x[7]))
        put_row(table.space, p, (s[0], s[1], s[2], s[3], s[4], s[5], zero_of(s[0]), zero_of(s[0])))


@device
def _own(stress, p):
    return (
        entry(stress, p, 0), entry(stress, p, 1), entry(stress, p, 2), entry(stress, p, 3), entry(stress, p, 4),
        entry(stress, p, 5),
    )  # fmt: skip


@loop(parallel=False)
def gather_moments(moment, shared, n, part, first, last):
    """Add to the shared elements first … last of a list what bonds of other domains have left for them."""
    for e in range(first, last):
        for q in range(n + part[e], n + part[e + 1]):
            for c in range(6):
                moment[shared[e], c] += moment[q, c]
                moment[q, c] = 0.0


@device
def _add_moment(moment, p, l, sign, f):
    m = lever_moments(l, f, sign)
    for c in range(6):
        moment[p, c] += m[c]


@loop(parallel=False)
def add_touches(pose, period, contacts, moment, first, last):
    """Add what other elements and walls do to the elements first … last where they touch them."""
    c = contacts
    for p in range(first, last):
        for k in range(c.in_start[p], c.in_start[p + 1]):
            if c.touch[k] != 0:
                a, f = c.first[k], (c.output[k, 0], c.output[k, 1], c.output[k, 2])
                d, share = branch(pose, a, p, period), -c.radius[p] / (c.radius[a] + c.radius[p])
                _add_moment(moment, p, (share * d[0], share * d[1], share * d[2]), 1.0, f)
        for e in range(c.out_start[p], c.out_start[p + 1]):
            k = c.out_pair[e]
            if c.touch[k] != 0:
                b, f = c.second[k], (c.output[k, 0], c.output[k, 1], c.output[k, 2])
                d, share = branch(pose, p, b, period), c.radius[p] / (c.radius[p] + c.radius[b])
                _add_moment(moment, p, (share * d[0], share * d[1], share * d[2]), -1.0, f)
        for e in range(c.wall_start[p], c.wall_start[p + 1]):
            if c.wall_touch[e] != 0:
                r, f = c.radius[p], (c.wall_output[e, 0], c.wall_output[e, 1], c.wall_output[e, 2])
                distance, x, y, z = wall_gap(pose[p, 0], pose[p, 1], pose[p, 2], r, c.shape, c.walls, c.wall[e])
                arm = -(r + distance)
                _add_moment(moment, p, (arm * x, arm * y, arm * z), -1.0, f)


@device
def _trisected(r):
    """2 cos(arccos(r) / 3), within 4e-7."""
    x = math.sqrt(0.5 * (1.0 + min(max(r, -1.0), 1.0)))
    c = _TRISECTED
    return c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * (c[4] + x * (c[5] + x * c[6])))))


@device
def principal_bounds(s):
    """Bounds of the largest and the least principal stress, close to them and never inside.

    σ = p ± 2 √(J2/3) cos(angle): the largest with arccos(r)/3, the least with arccos(-r)/3.
    """
    mean = (s[0] + s[1] + s[2]) / 3.0
    a, b, c, x, y, z = s[0] - mean, s[1] - mean, s[2] - mean, s[3], s[4], s[5]
    size = math.sqrt((a * a + b * b + c * c + 2.0 * (x * x + y * y + z * z)) / 6.0)
    third = a * (b * c - z * z) - x * (x * c - z * y) + y * (x * z - b * y)
    r = 0.5 * third / (size * size * size + _NOTHING)
    margin = _MARGIN * (size + math.fabs(mean))
    return mean + size * _trisected(r) + margin, mean - size * _trisected(-r) - margin


@loop(parallel=False)
def element_stresses(pose, table, first, last):
    """Stresses of the elements first … last from `table.moment`, in their own frames and in space; it is cleared."""
    moment, stress, end = table.moment, table.stress, np.uint64(last)
    for g in range((last - first + WIDTH - 1) // WIDTH):
        p = places_from(np.uint64(first) + np.uint64(WIDTH) * np.uint64(g), end)
        x, m, one = row(pose, p), row(moment, p), number_in(table.inverse, p)
        clear_row(moment, p)
        s = one * m[0], one * m[1], one * m[2], one * m[3], one * m[4], one * m[5]
        high, low = principal_bounds(s)
        put_row(table.space, p, (s[0], s[1], s[2], s[3], s[4], s[5], high, low))
        own = _turned(s, (x[4], -x[5], -x[6], -x[7]))
        put_entry(stress, p, 0, own[0])
        put_entry(stress, p, 1, own[1])
        put_entry(stress, p, 2, own[2])
        put_entry(stress, p, 3, own[3])
        put_entry(stress, p, 4, own[4])
        put_entry(stress, p, 5, own[5])


@device
def add_stress(pose, table, p, l, sign, f):
    """Add what ± a force f at the lever l, in the element's own frame, does to the stress of element p."""
    x, y, z = back((pose[p, 4], pose[p, 5], pose[p, 6], pose[p, 7]), f)
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
    f = column(table.output, k)
    add_stress(pose, table, i, column(table.lever_i, k), -1.0, f)
    add_stress(pose, table, j, column(table.lever_j, k), 1.0, f)
    if contacts is not None:  # decided when compiled
        e = contacts.of_bond[k]
        if e >= 0:
            if contacts.touch[e] != 0:
                a, b = np.int64(contacts.first[e]), np.int64(contacts.second[e])
                d = branch(pose, a, b, period)
                f = contacts.output[e, 0], contacts.output[e, 1], contacts.output[e, 2]
                of_a = contacts.radius[a] / (contacts.radius[a] + contacts.radius[b])
                for end in range(2):
                    p, share = (a, of_a) if end == 0 else (b, of_a - 1.0)
                    q = pose[p, 4], pose[p, 5], pose[p, 6], pose[p, 7]
                    l = back(q, (share * d[0], share * d[1], share * d[2]))
                    add_stress(pose, table, p, l, -1.0 if end == 0 else 1.0, f)
