"""Contacts of a step: every pair that touches writes its force, then every element gathers its own.

Like bonds in two phases, so that results do not depend on the thread count. Contacts run before the bonds of the
step and leave their sum for each element in `load`, which the pass over the elements adds to that of the bonds.
On one thread pairs that touch hand out what they do in the order of the list, which is that in which elements gather
it.
"""

from bondem._compile import device, loop, prange
from bondem.kernels.contact_list import farthest
from bondem.kernels.contact_pairs import (
    TOUCHING,
    measure_pairs,
    pair_energy,
    pair_forces,
    some_pairs,
    spring_and_dashpot,
)
from bondem.kernels.tables import DAMPED, RUBBED
from bondem.kernels.walls import KIND, RATE, among, load_walls, wall_gap, wall_travel
from bondem.laws.contact import SOFT, contact_force, spring_energy, wall_spring

# Below this many pairs that may touch launching threads costs more than the loop.
SERIAL_PAIRS = 1000
# Elements of one portion of work.
_PORTION = 2000
# Distances of all pairs are measured anew when an element has moved this share of the reach of the list.
_FRESH = 0.1


@device
def outdated(pose, c):
    """Whether the list may miss a contact by now; also where a centre is not a number.

    How far elements are from where they were measured is kept for `contact_loads`, and bounds how far they are from
    where they were listed.
    """
    far = c.far
    far[0] = farthest(pose, c.measured)
    if not far[0] + far[1] < c.reach and not farthest(pose, c.listed) < c.reach:
        return True
    return not wall_travel(c.walls, c.wall_listed) < c.reach


@loop(parallel=False)
def _measure_walls(pose, c):
    """Keep the deepest overlap with a wall so far, over the radius, in `far`."""
    for p in range(len(pose) if len(c.wall) > 0 else 0):
        for e in range(c.wall_start[p], c.wall_start[p + 1]):
            r = c.radius[p]
            distance, _, _, _ = wall_gap(pose[p, 0], pose[p, 1], pose[p, 2], r, c.shape, c.walls, c.wall[e])
            c.far[2] = max(c.far[2], (c.wall_gap[e] - distance) / r)


@loop(parallel=False)
def contact_loads(elements, period, dt, contacts, threaded):
    """Contact forces at the present, into `load` and on the walls; memory and losses go on by dt.

    A run is `threaded` from beginning to end, or never.
    """
    moved = contacts.far[0]
    if not moved <= _FRESH * contacts.reach:
        measure_pairs(elements.pose, period, contacts, _FRESH * contacts.reach)
        _measure_walls(elements.pose, contacts)
        contacts.far[0], contacts.far[1] = 0.0, farthest(elements.pose, contacts.listed)
        moved = 0.0
    if threaded and contacts.nears[0] >= SERIAL_PAIRS:
        pair_forces(elements, period, contacts, moved, dt)
    else:
        nears = contacts.nears[0]
        contacts.nears[1] = some_pairs(elements, period, contacts, contacts.near, moved, dt, 0, nears)
    if threaded:
        gather(elements, contacts, dt)
    else:
        hand_out(elements, contacts, dt)
    load_walls(dt, contacts)


@device
def _put(stretch, output, k, found):
    """Keep the memory of a contact, and its force; the force."""
    force, s, p, _, _ = found
    for d in range(3):
        stretch[k, d], stretch[k, 3 + d], output[k, d] = s[d], p[d], force[d]
    return force


@device
def _at_wall(arm, v, grow, spin, n):
    """Unit normal, and the velocity of a sphere against a wall at the contact, `arm` from its centre."""
    wx, wy, wz = arm * spin[0], arm * spin[1], arm * spin[2]
    u = (
        v[0] - grow * n[0] - (wy * n[2] - wz * n[1]),
        v[1] - grow * n[1] - (wz * n[0] - wx * n[2]),
        v[2] - grow * n[2] - (wx * n[1] - wy * n[0]),
    )
    return n, u


@device
def _with_wall(pose, motion, c, p, e, dt, total):
    """The same with contact e of an element with a wall added, if they touch; it is kept for the wall too."""
    f0, f1, f2, q0, q1, q2, damped, rubbed = total
    shape, walls, w, r, stretch, output = c.shape, c.walls, c.wall[e], c.radius[p], c.wall_stretch, c.wall_output
    x, y, z = pose[p, 0], pose[p, 1], pose[p, 2]
    distance, nx, ny, nz = wall_gap(x, y, z, r, shape, walls, w)
    overlap = max(c.wall_gap[e] - distance, 0.0)
    for d in range(4):
        output[e, d] = 0.0
    if not (overlap > 0.0 or c.wall_touch[e] == TOUCHING):
        return total
    n, spin = (nx, ny, nz), (motion[p, 4], motion[p, 5], motion[p, 6])
    v = motion[p, 0] - walls[w, RATE], motion[p, 1] - walls[w, RATE + 1], motion[p, 2] - walls[w, RATE + 2]
    grow = walls[w, RATE + 3] if among(shape[w, KIND]) else -walls[w, RATE + 3]
    was, mx, my, mz = wall_gap(x - dt * v[0], y - dt * v[1], z - dt * v[2], r, shape, walls, w)
    was += dt * grow
    arm = r + distance  # from the centre to the wall
    now, last = _at_wall(arm, v, grow, spin, n), _at_wall(r + was, v, grow, spin, (mx, my, mz))
    kn, part, beta = wall_spring(c.law, r, overlap)
    before = wall_spring(c.law, r, max(c.wall_gap[e] - was, 0.0))[0]
    spring = spring_and_dashpot(c.law, kn, part, beta, before, 1.0 / motion[p, 3])
    twist = 0.5 * (spin[0] * nx + spin[1] * ny + spin[2] * nz)
    s, h = (stretch[e, 0], stretch[e, 1], stretch[e, 2]), (stretch[e, 3], stretch[e, 4], stretch[e, 5])
    found = contact_force(spring, c.wall_friction[w], overlap, now, last, twist, s, h, dt)
    fx, fy, fz = _put(stretch, output, e, found)
    output[e, 0], output[e, 1], output[e, 2] = -fx, -fy, -fz
    output[e, 3] = fx * nx + fy * ny + fz * nz
    c.wall_touch[e] = TOUCHING if overlap > 0.0 else 0
    lever = arm / r
    q0 -= lever * (ny * fz - nz * fy)
    q1 -= lever * (nz * fx - nx * fz)
    q2 -= lever * (nx * fy - ny * fx)
    return f0 + fx, f1 + fy, f2 + fz, q0, q1, q2, damped + found[3], rubbed + found[4]


@device
def _write(load, loss, radius, p, total):
    """What contacts do to an element, and what they lose there."""
    r = radius[p]
    load[p, 0], load[p, 1], load[p, 2] = total[0], total[1], total[2]
    load[p, 3], load[p, 4], load[p, 5] = r * total[3], r * total[4], r * total[5]
    loss[p, DAMPED] += total[6]
    loss[p, RUBBED] += total[7]


@loop(parallel=False)
def _walled(elements, contacts, dt, p, total):
    """The same of an element that may touch walls; `total` is what its contacts with others do."""
    for e in range(contacts.wall_start[p], contacts.wall_start[p + 1]):
        total = _with_wall(elements.pose, elements.motion, contacts, p, e, dt, total)
    _write(contacts.load, elements.loss, contacts.radius, p, total)


@loop(parallel=False)
def _gather(elements, contacts, dt, begin, end):
    """What all contacts do to the elements begin … end."""
    c, loss = contacts, elements.loss
    load, radius, wall_start, touch, output = c.load, c.radius, c.wall_start, c.touch, c.output
    in_start, out_start, out_pair = c.in_start, c.out_start, c.out_pair
    for p in range(begin, end):
        f0 = f1 = f2 = q0 = q1 = q2 = damped = rubbed = 0.0
        for k in range(in_start[p], in_start[p + 1]):
            if touch[k] != 0:
                f0 += output[k, 0]
                f1 += output[k, 1]
                f2 += output[k, 2]
                q0 += output[k, 3]
                q1 += output[k, 4]
                q2 += output[k, 5]
                damped += output[k, 6]
                rubbed += output[k, 7]
        for e in range(out_start[p], out_start[p + 1]):
            k = out_pair[e]
            if touch[k] != 0:
                f0 -= output[k, 0]
                f1 -= output[k, 1]
                f2 -= output[k, 2]
                q0 += output[k, 3]
                q1 += output[k, 4]
                q2 += output[k, 5]
        if wall_start[p + 1] > wall_start[p]:
            _walled(elements, contacts, dt, p, (f0, f1, f2, q0, q1, q2, damped, rubbed))
        else:
            _write(load, loss, radius, p, (f0, f1, f2, q0, q1, q2, damped, rubbed))


@loop(parallel=True)
def gather(elements, contacts, dt):
    """What all contacts do to each element, in portions."""
    n = len(contacts.load)
    for q in prange((n + _PORTION - 1) // _PORTION):
        _gather(elements, contacts, dt, q * _PORTION, min((q + 1) * _PORTION, n))


@loop(parallel=False)
def hand_out(elements, contacts, dt):
    """The same from the pairs that touch, to the same bits; elements that nothing touches are left alone."""
    c, sums, hit, met = contacts, contacts.sums, contacts.hit, contacts.met
    first, second, output, load, close, wall_start = c.first, c.second, c.output, c.load, c.close, c.wall_start
    for e in range(c.hits[0]):
        for d in range(6):
            load[hit[e], d] = 0.0
    count = 0
    for e in range(c.nears[1]):
        k = close[e]
        a, b = first[k], second[k]
        for end in range(2):  # no function: tables that are handed to what branches have their references counted
            p = a if end == 0 else b
            if met[p] == 0:
                met[p], hit[count] = 1, p
                count += 1
                for d in range(8):
                    sums[p, d] = 0.0
        for d in range(3):
            sums[a, d] -= output[k, d]
            sums[a, 3 + d] += output[k, 3 + d]
        for d in range(8):
            sums[b, d] += output[k, d]
    radius, loss = c.radius, elements.loss
    for p in range(len(load) if len(c.wall) > 0 else 0):
        if wall_start[p + 1] > wall_start[p] and met[p] == 0:
            met[p], hit[count] = 1, p
            count += 1
            for d in range(8):
                sums[p, d] = 0.0
    for e in range(count):
        p = hit[e]
        met[p] = 0
        total = (
            sums[p, 0], sums[p, 1], sums[p, 2], sums[p, 3], sums[p, 4], sums[p, 5], sums[p, 6], sums[p, 7]
        )  # fmt: skip
        if wall_start[p + 1] > wall_start[p]:
            _walled(elements, contacts, dt, p, total)
        else:
            _write(load, loss, radius, p, total)
    c.hits[0] = count


@loop(parallel=False)
def contact_energy(pose, period, c):
    """Elastic energy of all contacts [J]."""
    total = 0.0
    for k in range(len(c.first)):
        if c.touch[k] == TOUCHING:
            total += pair_energy(pose, period, c, k)
    for p in range(len(pose)):
        for e in range(c.wall_start[p], c.wall_start[p + 1]):
            if c.wall_touch[e] == TOUCHING:
                r = c.radius[p]
                distance, _, _, _ = wall_gap(pose[p, 0], pose[p, 1], pose[p, 2], r, c.shape, c.walls, c.wall[e])
                overlap = max(c.wall_gap[e] - distance, 0.0)
                slip = c.wall_stretch[e, 0] ** 2 + c.wall_stretch[e, 1] ** 2 + c.wall_stretch[e, 2] ** 2
                kn, part, _ = wall_spring(c.law, r, overlap)
                total += spring_energy(kn, part, c.law[SOFT] * kn, overlap, slip)
    return total
