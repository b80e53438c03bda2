"""Pairs of elements in contact: each that touches writes its force and goes on with its memory.

Most pairs of a list are bonded, or further apart than elements move before distances are measured anew: only the
others are looked at, in the order of the list, and those that touch are taken WIDTH at a time.
"""

import math

import numpy as np

from bondem._calls import picked
from bondem._compile import device, loop, prange
from bondem.kernels.bond_pass import apart, branch
from bondem.kernels.lane_memory import number_in, places_below, places_in, put_row, row
from bondem.kernels.lanes import WIDTH, lane, zero_of
from bondem.laws.contact import FRICTION, HERTZIAN, SOFT, contact_force, pair_spring, spring_energy

# A pair that touches, and one that parted in this step: it still hands in what it lost.
TOUCHING, PARTED = 1, 2
# Pairs of one portion of work.
_PORTION = 250


@loop(parallel=False)
def measure_pairs(pose, period, c, most):
    """How far both elements of each pair may move from here before they touch, by more than rounding.

    Those that may touch before an element has moved by `most` [m] are listed, and those that do. The deepest overlap
    so far, over the smaller radius, is kept in `far`.
    """
    slack, radius, first, second, gap, touch = c.slack, c.radius, c.first, c.second, c.gap, c.touch
    bond, joined, near, count, deepest = c.bond, c.joined, c.near, 0, c.far[2]
    for k in range(len(slack)):
        if bond[k] >= 0 and joined[max(bond[k], 0)] > 0.0:
            continue
        a, b = first[k], second[k]
        x, y, z = branch(pose, a, b, period)
        slack[k] = 0.5 * (math.sqrt(x * x + y * y + z * z) - (1.0 + 1e-9) * (radius[a] + radius[b] + gap[k]))
        near[count] = k
        count += 1 if (slack[k] <= most) | (touch[k] != 0) else 0
        deepest = max(deepest, -2.0 * slack[k] / min(radius[a], radius[b]))
    c.nears[0], c.far[2] = count, deepest
    for p in range(len(pose)):
        for d in range(3):
            c.measured[p, d] = pose[p, d]


@device
def spring_and_dashpot(law, kn, part, beta, before, mass):
    """What `contact_force` takes of springs and dashpots."""
    ks = law[SOFT] * kn
    cn, cs = 2.0 * beta * math.sqrt(kn * mass), 2.0 * beta * math.sqrt(ks * mass)
    return kn, part, ks, law[SOFT] * before, cn, cs


@device
def _at_contact(d, v, spin, reach):
    """Length and direction of a branch d, and the velocity of its second end against the first at the contact.

    The contact point divides the distance as the radii do, so that there is no net moment; `spin` is their angular
    velocities times the radii, `reach` the sum of these.
    """
    length = math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2])
    n = d[0] / length, d[1] / length, d[2] / length
    share = length / reach
    wx, wy, wz = share * spin[0], share * spin[1], share * spin[2]
    u = (
        v[0] - (wy * n[2] - wz * n[1]),
        v[1] - (wz * n[0] - wx * n[2]),
        v[2] - (wx * n[1] - wy * n[0]),
    )
    return length, (n, u)


@device
def _meeting(a, b, ra, rb):
    """Of two rows of motion: velocity of b against a, spins times radii, sum of spins, and the mass that meets."""
    return (
        (b[0] - a[0], b[1] - a[1], b[2] - a[2]),
        (ra * a[4] + rb * b[4], ra * a[5] + rb * b[5], ra * a[6] + rb * b[6]),
        (a[4] + b[4], a[5] + b[5], a[6] + b[6]),
        1.0 / (a[3] + b[3]),
    )  # fmt: skip


@device
def _pair_force(law, own, ra, rb, reach, d, meeting, s, p, dt):
    """Overlap of a pair, its force and memory as `contact_force` has them, and the torque over the radius."""
    v, spin, both, mass = meeting
    length, now = _at_contact(d, v, spin, ra + rb)
    was, last = _at_contact((d[0] - dt * v[0], d[1] - dt * v[1], d[2] - dt * v[2]), v, spin, ra + rb)
    n, overlap = now[0], picked(reach - length, reach - length, 0.0)
    twist = 0.5 * (both[0] * n[0] + both[1] * n[1] + both[2] * n[2])
    kn, part, beta = pair_spring(law, own, ra, rb, overlap)
    before = kn
    if law[HERTZIAN] != 0.0:
        softer = pair_spring(law, 0.0 * own, ra, rb, picked(reach - was, reach - was, 0.0))[0]
        before = picked(own, kn, softer)
    spring = spring_and_dashpot(law, kn, part, beta, before, mass)
    found = contact_force(spring, law[FRICTION], overlap, now, last, twist, s, p, dt)
    share, f = length / (ra + rb), found[0]
    torque = (
        -share * (n[1] * f[2] - n[2] * f[1]), -share * (n[2] * f[0] - n[0] * f[2]),
        -share * (n[0] * f[1] - n[1] * f[0]),
    )  # fmt: skip
    return overlap, found, torque


@loop(parallel=False)
def some_pairs(elements, period, c, listed, moved, dt, begin, end):
    """Forces and memory of the pairs begin … end of a list that touch or have just parted.

    They stand in `c.close` from `begin` on, up to what is returned.
    """
    pose, joined, bond = elements.pose, c.joined, c.bond
    slack, touch, first, second, gap, radius = c.slack, c.touch, c.first, c.second, c.gap, c.radius
    close, count = c.close, begin
    for e in range(begin, end):
        # without branches, as these would be guessed wrong every other time
        k = listed[e]
        bonded = (bond[k] >= 0) & (joined[max(bond[k], 0)] > 0.0)
        off = (slack[k] > moved) & (touch[k] == 0)
        close[count] = k
        count += 0 if bonded | off else 1
    last, count = count, begin
    for e in range(begin, last):
        k = close[e]
        a, b = first[k], second[k]
        d, reach = branch(pose, a, b, period), radius[a] + radius[b] + gap[k]
        off = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2] >= reach * reach) & (touch[k] != TOUCHING)
        touch[k] = 0 if off else touch[k]
        close[count] = k
        count += 0 if off else 1
    for e in range(begin, count, WIDTH):
        _many_pairs(pose, elements.motion, period, c, dt, e, count)
    return count


@device
def _many_pairs(pose, motion, period, c, dt, begin, end):
    """Forces and memory of WIDTH pairs from `begin` on of `c.close`; the last before `end` fills up the lanes."""
    law = c.law[0], c.law[1], c.law[2], c.law[3], c.law[4]
    k = places_below(c.close, np.uint64(begin), np.uint64(end))
    a, b = places_in(c.first, k), places_in(c.second, k)
    d, ra, rb = apart(row(pose, a), row(pose, b), period), number_in(c.radius, a), number_in(c.radius, b)
    reach, memory = ra + rb + number_in(c.gap, k), row(c.stretch, k)
    meeting = _meeting(row(motion, a), row(motion, b), ra, rb)
    overlap, found, torque = _pair_force(
        law, number_in(c.own, k), ra, rb, reach, d, meeting, memory[:3], memory[3:6], dt
    )  # fmt: skip
    f, s, p, damped, rubbed = found
    zero = zero_of(damped)
    put_row(c.stretch, k, (s[0], s[1], s[2], p[0], p[1], p[2], zero, zero))
    put_row(c.output, k, (f[0], f[1], f[2], torque[0], torque[1], torque[2], damped, rubbed))
    for n in range(min(end - begin, WIDTH)):
        c.touch[c.close[begin + n]] = TOUCHING if lane(overlap, n) > 0.0 else PARTED


@loop(parallel=True)
def pair_forces(elements, period, c, moved, dt):
    """Forces and memory of all pairs that may touch, in portions of the list."""
    near = c.nears[0]
    count = (near + _PORTION - 1) // _PORTION
    for q in prange(count):
        some_pairs(elements, period, c, c.near, moved, dt, q * _PORTION, min((q + 1) * _PORTION, near))


@device
def pair_energy(pose, period, c, k):
    """Elastic energy of a pair that touches [J]."""
    dx, dy, dz = branch(pose, c.first[k], c.second[k], period)
    ra, rb = c.radius[c.first[k]], c.radius[c.second[k]]
    overlap = max(ra + rb + c.gap[k] - math.sqrt(dx * dx + dy * dy + dz * dz), 0.0)
    slip = c.stretch[k, 0] ** 2 + c.stretch[k, 1] ** 2 + c.stretch[k, 2] ** 2
    kn, part, _ = pair_spring(c.law, c.own[k], ra, rb, overlap)
    return spring_energy(kn, part, c.law[SOFT] * kn, overlap, slip)


@loop(parallel=False)
def look_at(c, k):
    """Look at pair k in each step from now on, which was bonded; it keeps its place in the order of pairs."""
    near, e = c.near, c.nears[0]
    c.slack[k] = -np.inf
    while e > 0 and near[e - 1] > k:
        e -= 1
    if e > 0 and near[e - 1] == k:
        return
    for q in range(c.nears[0], e, -1):
        near[q] = near[q - 1]
    near[e] = k
    c.nears[0] += 1


@loop(parallel=False)
def _begin_pair(elements, period, contacts, k):
    """Let a pair that was passed over so far touch as it is, its tangential spring at rest; whether it touches."""
    look_at(contacts, k)
    contacts.touch[k] = 0
    for d in range(6):
        contacts.stretch[k, d] = 0.0
    listed = np.empty(1, np.int64)
    listed[0] = k
    some_pairs(elements, period, contacts, listed, np.inf, 0.0, 0, 1)
    return contacts.touch[k] == TOUCHING


@loop(parallel=False)
def press_on(elements, period, contacts, load, e):
    """The pair of bond e, of which nothing is left by now, bears what presses it together, on `load` of its ends."""
    k = contacts.of_bond[e]
    if k < 0:
        return
    if _begin_pair(elements, period, contacts, k):
        a, b, output = contacts.first[k], contacts.second[k], contacts.output
        for d in range(3):
            load[a, d] -= output[k, d]
            load[b, d] += output[k, d]
            load[a, 3 + d] += contacts.radius[a] * output[k, 3 + d]
            load[b, 3 + d] += contacts.radius[b] * output[k, 3 + d]


@loop(parallel=False)
def begin_contact(elements, bonds, contacts, sums, first_row, e):
    """The pair of bond e, broken just now, bears what presses it together; the energy that it takes over [J].

    Its force goes to the rows of the ends in `sums`, which close the step anew; its tangential spring is at rest.
    """
    k = contacts.of_bond[e]
    if k < 0:
        return 0.0
    if not _begin_pair(elements, bonds.period, contacts, k):
        return 0.0
    a, b, output = contacts.first[k], contacts.second[k], contacts.output
    for d in range(3):
        sums[first_row + a, d] -= output[k, d]
        sums[first_row + b, d] += output[k, d]
        sums[first_row + a, 4 + d] += contacts.radius[a] * output[k, 3 + d]
        sums[first_row + b, 4 + d] += contacts.radius[b] * output[k, 3 + d]
    return pair_energy(elements.pose, bonds.period, contacts, k)


@device
def let_touch(pose, period, contacts, e):
    """Facet e bears on nothing any more: its pair touches from its rest length on, or from where it is by now.

    So it touches without a force, and takes over no energy. Returns that distance [m].
    """
    c, k = contacts, contacts.of_bond[e]
    a, b = c.first[k], c.second[k]
    x, y, z = branch(pose, a, b, period)
    reach = min(c.apart[e], math.sqrt(x * x + y * y + z * z))
    c.joined[e], c.apart[e] = 0.0, reach
    c.gap[k] = reach - (c.radius[a] + c.radius[b])  # to the bit as a new list has it
    look_at(c, k)
    return reach
