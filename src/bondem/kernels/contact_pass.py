"""Contacts of a step: every pair that touches writes its force, then every element gathers its own.

Like bonds in two phases, so that results do not depend on the thread count. Contacts run before the bonds of the
step and leave their sum for each element in `load`, which the pass over the elements adds to that of the bonds.
"""

import math

from bondem._compile import device, kernel, prange
from bondem.kernels.bond_pass import branch
from bondem.kernels.contact_list import farthest
from bondem.kernels.tables import DAMPED, RUBBED
from bondem.kernels.walls import KIND, OUTSIDE, RATE, load_walls, wall_gap, wall_travel
from bondem.laws.contact import FRICTION, SOFT, contact_force, pair_spring, spring_energy, wall_spring

# A pair that touches, and one that parted in this step: it still hands in what it lost.
TOUCHING, PARTED = 1, 2
# Below this many candidates launching threads costs more than the loop.
SERIAL_PAIRS = 4000


@device
def outdated(pose, c):
    """Whether the list may miss a contact by now; also where a centre is not a number."""
    return not (farthest(pose, c.listed) < c.reach and wall_travel(c.walls, c.wall_listed) < c.reach)


@kernel(parallel=False)
def contact_loads(elements, bonds, dt, contacts):
    """Contact forces at the present, into `load` and on the walls; memory and losses go on by dt."""
    if len(contacts.first) >= SERIAL_PAIRS:
        pair_forces(elements, bonds, contacts, dt)
        gather(elements, contacts, dt)
    else:
        pair_forces_serial(elements, bonds, contacts, dt)
        gather_serial(elements, contacts, dt)
    load_walls(dt, contacts)


@device
def _overlap_before(d, a, b, dt, reach):
    """Overlap a step ago of a pair of rows of the motion that is d apart now [m]."""
    x, y, z = d[0] - dt * (b[0] - a[0]), d[1] - dt * (b[1] - a[1]), d[2] - dt * (b[2] - a[2])
    return max(reach - math.sqrt(x * x + y * y + z * z), 0.0)


@device
def _pair_force(pose, motion, c, period, dt, k):
    """Force and memory of a pair, if it touches or has just parted."""
    a, b, law, stretch, output = c.first[k], c.second[k], c.law, c.stretch, c.output
    dx, dy, dz = branch(pose, a, b, period)
    ra, rb = c.radius[a], c.radius[b]
    reach = ra + rb + c.gap[k]
    square = dx * dx + dy * dy + dz * dz
    if square >= reach * reach and c.touch[k] != TOUCHING:
        c.touch[k] = 0
    else:
        d = math.sqrt(square)
        overlap = max(reach - d, 0.0)
        nx, ny, nz = dx / d, dy / d, dz / d
        # the contact point divides the distance as the radii do: no net moment
        share = d / (ra + rb)
        wx = share * (ra * motion[a, 4] + rb * motion[b, 4])
        wy = share * (ra * motion[a, 5] + rb * motion[b, 5])
        wz = share * (ra * motion[a, 6] + rb * motion[b, 6])
        vx = motion[b, 0] - motion[a, 0] - (wy * nz - wz * ny)
        vy = motion[b, 1] - motion[a, 1] - (wz * nx - wx * nz)
        vz = motion[b, 2] - motion[a, 2] - (wx * ny - wy * nx)
        twist = 0.5 * (
            (motion[a, 4] + motion[b, 4]) * nx
            + (motion[a, 5] + motion[b, 5]) * ny
            + (motion[a, 6] + motion[b, 6]) * nz
        )
        kn, part, beta = pair_spring(law, c.own[k], ra, rb, overlap)
        ks = law[SOFT] * kn
        before = ks
        if part < 1.0:
            last = _overlap_before((dx, dy, dz), motion[a], motion[b], dt, reach)
            before = law[SOFT] * pair_spring(law, 0.0, ra, rb, last)[0]
        mass = 1.0 / (motion[a, 3] + motion[b, 3])
        fx, fy, fz, s0, s1, s2, p0, p1, p2, damped, rubbed = contact_force(
            kn, part, ks, before, 2.0 * beta * math.sqrt(kn * mass), 2.0 * beta * math.sqrt(ks * mass), law[FRICTION],
            overlap, nx, ny, nz, vx, vy, vz, twist, stretch[k, 0], stretch[k, 1], stretch[k, 2],
            stretch[k, 3], stretch[k, 4], stretch[k, 5], dt,
        )  # fmt: skip
        stretch[k, 0], stretch[k, 1], stretch[k, 2] = s0, s1, s2
        stretch[k, 3], stretch[k, 4], stretch[k, 5] = p0, p1, p2
        output[k, 0], output[k, 1], output[k, 2] = fx, fy, fz
        output[k, 3] = -share * (ny * fz - nz * fy)
        output[k, 4] = -share * (nz * fx - nx * fz)
        output[k, 5] = -share * (nx * fy - ny * fx)
        output[k, 6], output[k, 7] = damped, rubbed
        c.touch[k] = TOUCHING if overlap > 0.0 else PARTED


def _pair_forces(elements, bonds, c, dt):
    pose, motion, period, integrity, bond = elements.pose, elements.motion, bonds.period, bonds.integrity, c.bond
    for k in prange(len(c.first)):
        joined = False
        if bond[k] >= 0:
            joined = integrity[bond[k]] > 0.0
        if not joined:
            _pair_force(pose, motion, c, period, dt, k)


@device
def _pair_energy(pose, period, c, k):
    """Elastic energy of a pair that touches [J]."""
    dx, dy, dz = branch(pose, c.first[k], c.second[k], period)
    ra, rb = c.radius[c.first[k]], c.radius[c.second[k]]
    overlap = max(ra + rb + c.gap[k] - math.sqrt(dx * dx + dy * dy + dz * dz), 0.0)
    slip = c.stretch[k, 0] ** 2 + c.stretch[k, 1] ** 2 + c.stretch[k, 2] ** 2
    kn, part, _ = pair_spring(c.law, c.own[k], ra, rb, overlap)
    return spring_energy(kn, part, c.law[SOFT] * kn, overlap, slip)


@kernel(parallel=False)
def begin_contact(elements, bonds, contacts, sums, first_row, e):
    """The pair of bond e, broken just now, bears what presses it together; the energy that it takes over [J].

    Its force goes to the rows of the ends in `sums`, which close the step anew; its tangential spring is at rest.
    """
    k = contacts.of_bond[e]
    if k < 0:
        return 0.0
    contacts.touch[k] = 0
    for d in range(6):
        contacts.stretch[k, d] = 0.0
    _pair_force(elements.pose, elements.motion, contacts, bonds.period, 0.0, k)
    if contacts.touch[k] != TOUCHING:
        return 0.0
    a, b, output = contacts.first[k], contacts.second[k], contacts.output
    for d in range(3):
        sums[first_row + a, d] -= output[k, d]
        sums[first_row + b, d] += output[k, d]
        sums[first_row + a, 4 + d] += contacts.radius[a] * output[k, 3 + d]
        sums[first_row + b, 4 + d] += contacts.radius[b] * output[k, 3 + d]
    return _pair_energy(elements.pose, bonds.period, contacts, k)


@device
def _gathered(c, p):
    """Force, torque over the radius, and losses of an element's contacts with others."""
    touch, output = c.touch, c.output
    f0 = f1 = f2 = q0 = q1 = q2 = damped = rubbed = 0.0
    for k in range(c.in_start[p], c.in_start[p + 1]):
        if touch[k] != 0:
            f0 += output[k, 0]
            f1 += output[k, 1]
            f2 += output[k, 2]
            q0 += output[k, 3]
            q1 += output[k, 4]
            q2 += output[k, 5]
            damped += output[k, 6]
            rubbed += output[k, 7]
    for e in range(c.out_start[p], c.out_start[p + 1]):
        k = c.out_pair[e]
        if touch[k] != 0:
            f0 -= output[k, 0]
            f1 -= output[k, 1]
            f2 -= output[k, 2]
            q0 += output[k, 3]
            q1 += output[k, 4]
            q2 += output[k, 5]
    return f0, f1, f2, q0, q1, q2, damped, rubbed


@device
def _with_wall(pose, motion, c, p, e, dt, total):
    """The same with contact e of an element with a wall added, if they touch; it is kept for the wall too."""
    f0, f1, f2, q0, q1, q2, damped, rubbed = total
    law, shape, walls, w, r = c.law, c.shape, c.walls, c.wall[e], c.radius[p]
    distance, nx, ny, nz = wall_gap(pose[p, 0], pose[p, 1], pose[p, 2], r, shape, walls, w)
    overlap = max(c.wall_gap[e] - distance, 0.0)
    output, stretch = c.wall_output, c.wall_stretch
    for d in range(4):
        output[e, d] = 0.0
    if not (overlap > 0.0 or c.wall_touch[e] == TOUCHING):
        return total
    kn, part, beta = wall_spring(law, r, overlap)
    ks = law[SOFT] * kn
    arm = r + distance  # from the centre to the wall
    wx, wy, wz = arm * motion[p, 4], arm * motion[p, 5], arm * motion[p, 6]
    grow = walls[w, RATE + 3] if shape[w, KIND] == OUTSIDE else -walls[w, RATE + 3]
    vx = motion[p, 0] - walls[w, RATE] - grow * nx - (wy * nz - wz * ny)
    vy = motion[p, 1] - walls[w, RATE + 1] - grow * ny - (wz * nx - wx * nz)
    vz = motion[p, 2] - walls[w, RATE + 2] - grow * nz - (wx * ny - wy * nx)
    twist = 0.5 * (motion[p, 4] * nx + motion[p, 5] * ny + motion[p, 6] * nz)
    mass = 1.0 / motion[p, 3]
    before = ks
    if part < 1.0:
        last = max(overlap + dt * (vx * nx + vy * ny + vz * nz), 0.0)
        before = law[SOFT] * wall_spring(law, r, last)[0]
    fx, fy, fz, s0, s1, s2, p0, p1, p2, lost, worn = contact_force(
        kn, part, ks, before, 2.0 * beta * math.sqrt(kn * mass), 2.0 * beta * math.sqrt(ks * mass),
        c.wall_friction[w], overlap, nx, ny, nz, vx, vy, vz, twist,
        stretch[e, 0], stretch[e, 1], stretch[e, 2], stretch[e, 3], stretch[e, 4], stretch[e, 5], dt,
    )  # fmt: skip
    stretch[e, 0], stretch[e, 1], stretch[e, 2] = s0, s1, s2
    stretch[e, 3], stretch[e, 4], stretch[e, 5] = p0, p1, p2
    output[e, 0], output[e, 1], output[e, 2] = -fx, -fy, -fz
    output[e, 3] = fx * nx + fy * ny + fz * nz
    c.wall_touch[e] = TOUCHING if overlap > 0.0 else 0
    lever = arm / r
    q0 -= lever * (ny * fz - nz * fy)
    q1 -= lever * (nz * fx - nx * fz)
    q2 -= lever * (nx * fy - ny * fx)
    return f0 + fx, f1 + fy, f2 + fz, q0, q1, q2, damped + lost, rubbed + worn


def _gather(elements, contacts, dt):
    pose, motion, loss, load = elements.pose, elements.motion, elements.loss, contacts.load
    for p in prange(len(load)):
        total = _gathered(contacts, p)
        for e in range(contacts.wall_start[p], contacts.wall_start[p + 1]):
            total = _with_wall(pose, motion, contacts, p, e, dt, total)
        f0, f1, f2, q0, q1, q2, damped, rubbed = total
        r = contacts.radius[p]
        load[p, 0], load[p, 1], load[p, 2] = f0, f1, f2
        load[p, 3], load[p, 4], load[p, 5] = r * q0, r * q1, r * q2
        loss[p, DAMPED] += damped
        loss[p, RUBBED] += rubbed


pair_forces = kernel(parallel=True)(_pair_forces)
pair_forces_serial = kernel(parallel=False)(_pair_forces)
gather = kernel(parallel=True)(_gather)
gather_serial = kernel(parallel=False)(_gather)


@kernel(parallel=False)
def contact_energy(pose, period, c):
    """Elastic energy of all contacts [J]."""
    total = 0.0
    for k in range(len(c.first)):
        if c.touch[k] == TOUCHING:
            total += _pair_energy(pose, period, c, k)
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
