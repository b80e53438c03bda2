"""Contacts of a step: every pair that touches writes its force, then every element gathers its own.

Like bonds in two phases, so that results do not depend on the thread count. Contacts run before the bonds of the
step and leave their sum for each element in `load`, which the pass over the elements adds to that of the bonds.
"""

import math
from typing import NamedTuple

import numpy as np

from bondem._compile import device, kernel, prange
from bondem.kernels.bond_pass import branch
from bondem.kernels.contact_list import farthest
from bondem.kernels.walls import load_walls, move_walls, wall_gap, wall_travel
from bondem.laws.contact import contact_force, pair_stiffness

# A pair that touches, and one that parted in this step: it still hands in what it lost.
TOUCHING, PARTED = 1, 2
# Below this many candidates launching threads costs more than the loop.
SERIAL_PAIRS = 4000


class Contacts(NamedTuple):
    """Arrays of the contacts, in the kernels' order; c pairs, b contacts with walls, w walls."""

    law: np.ndarray  #: E [Pa], ks / kn, μ, β; (4,)
    radius: np.ndarray  #: of the elements [m], (n,)
    load: np.ndarray  #: force and torque of all contacts on each element [N, N·m], (n, 6)
    listed: np.ndarray  #: centres when the list was made [m], (n, 3)
    reach: float  #: how far elements, and walls, may move before the next list [m]
    first: np.ndarray  #: uint32, (c,)
    second: np.ndarray  #: uint32, (c,)
    gap: np.ndarray  #: from which the overlap counts, at most 0 [m], (c,)
    stretch: np.ndarray  #: tangential stretch [m] and force of the dashpots [N], (c, 6)
    touch: np.ndarray  #: uint8, (c,)
    output: np.ndarray  #: force on the second, torque over the radius, losses; (c, 8)
    in_start: np.ndarray  #: pairs whose second element is p, (n + 1,)
    out_start: np.ndarray  #: pairs whose first element is p, (n + 1,)
    out_pair: np.ndarray  #: uint32, (c,)
    wall_start: np.ndarray  #: contacts of each element with walls, (n + 1,)
    wall: np.ndarray  #: uint32, (b,)
    wall_gap: np.ndarray  #: (b,)
    wall_stretch: np.ndarray  #: (b, 6)
    wall_touch: np.ndarray  #: uint8, (b,)
    wall_output: np.ndarray  #: force on the wall (3), normal force; (b, 4)
    shape: np.ndarray  #: of the walls, (w, 8)
    walls: np.ndarray  #: the walls themselves, (w, 14)
    wall_listed: np.ndarray  #: displacements when the list was made [m], (w, 4)
    wall_friction: np.ndarray  #: μ, (w,)
    times: np.ndarray
    values: np.ndarray
    start: np.ndarray
    drive_wall: np.ndarray
    drive_component: np.ndarray
    drive_schedule: np.ndarray
    drive_rate: np.ndarray
    servo_wall: np.ndarray
    servo_schedule: np.ndarray
    servo_speed: np.ndarray
    servo_mass: np.ndarray


@device
def advance_walls(t, dt, c):
    """Take the walls from t to t + dt."""
    move_walls(
        t, dt, c.shape, c.walls, c.times, c.values, c.start, c.drive_wall, c.drive_component,
        c.drive_schedule, c.drive_rate, c.servo_wall, c.servo_schedule, c.servo_speed, c.servo_mass,
    )  # fmt: skip


@device
def outdated(pose, c):
    """Whether the list may miss a contact by now; also where a centre is not a number."""
    return not (farthest(pose, c.listed) < c.reach and wall_travel(c.walls, c.wall_listed) < c.reach)


@device
def contact_loads(pose, motion, loss, period, dt, c):
    """Contact forces at the present, into `load` and on the walls; memory and losses go on by dt."""
    if len(c.first) >= SERIAL_PAIRS:
        pair_forces(
            pose, motion, c.law, c.radius, c.first, c.second, c.gap, c.stretch, c.touch, c.output, period, dt
        )
        gather(
            pose, motion, c.law, c.radius, c.touch, c.output, c.in_start, c.out_start, c.out_pair, c.wall_start,
            c.wall, c.wall_gap, c.wall_stretch, c.wall_touch, c.wall_output, c.shape, c.walls, c.wall_friction,
            c.load, loss, dt,
        )  # fmt: skip
    else:
        pair_forces_serial(
            pose, motion, c.law, c.radius, c.first, c.second, c.gap, c.stretch, c.touch, c.output, period, dt
        )
        gather_serial(
            pose, motion, c.law, c.radius, c.touch, c.output, c.in_start, c.out_start, c.out_pair, c.wall_start,
            c.wall, c.wall_gap, c.wall_stretch, c.wall_touch, c.wall_output, c.shape, c.walls, c.wall_friction,
            c.load, loss, dt,
        )  # fmt: skip
    load_walls(dt, c.shape, c.walls, c.wall, c.wall_output)


def _pair_forces(pose, motion, law, radius, first, second, gap, stretch, touch, output, period, dt):
    modulus, soft, friction, damping = law[0], law[1], law[2], law[3]
    for k in prange(len(first)):
        a = first[k]
        b = second[k]
        dx, dy, dz = branch(pose, a, b, period)
        ra, rb = radius[a], radius[b]
        reach = ra + rb + gap[k]
        square = dx * dx + dy * dy + dz * dz
        if square >= reach * reach and touch[k] != TOUCHING:
            touch[k] = 0
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
            kn = pair_stiffness(modulus, ra, rb)
            ks = soft * kn
            mass = 1.0 / (motion[a, 3] + motion[b, 3])
            fx, fy, fz, s0, s1, s2, p0, p1, p2, damped, rubbed = contact_force(
                kn, ks, 2.0 * damping * math.sqrt(kn * mass), 2.0 * damping * math.sqrt(ks * mass), friction, overlap,
                nx, ny, nz, vx, vy, vz, twist, stretch[k, 0], stretch[k, 1], stretch[k, 2],
                stretch[k, 3], stretch[k, 4], stretch[k, 5], dt,
            )  # fmt: skip
            stretch[k, 0], stretch[k, 1], stretch[k, 2] = s0, s1, s2
            stretch[k, 3], stretch[k, 4], stretch[k, 5] = p0, p1, p2
            output[k, 0], output[k, 1], output[k, 2] = fx, fy, fz
            output[k, 3] = -share * (ny * fz - nz * fy)
            output[k, 4] = -share * (nz * fx - nx * fz)
            output[k, 5] = -share * (nx * fy - ny * fx)
            output[k, 6], output[k, 7] = damped, rubbed
            touch[k] = TOUCHING if overlap > 0.0 else PARTED


def _gather(
    pose, motion, law, radius, touch, output, in_start, out_start, out_pair, wall_start, wall, wall_rest,
    wall_stretch, wall_touch, wall_output, shape, walls, wall_friction, load, loss, dt,
):  # fmt: skip
    modulus, soft, damping = law[0], law[1], law[3]
    for p in prange(len(load)):
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
        r = radius[p]
        for e in range(wall_start[p], wall_start[p + 1]):
            w = wall[e]
            distance, nx, ny, nz = wall_gap(pose[p, 0], pose[p, 1], pose[p, 2], r, shape, walls, w)
            overlap = max(wall_rest[e] - distance, 0.0)
            for d in range(4):
                wall_output[e, d] = 0.0
            if overlap > 0.0 or wall_touch[e] == TOUCHING:
                kn = modulus * math.pi * r
                ks = soft * kn
                arm = r + distance  # from the centre to the wall
                wx, wy, wz = arm * motion[p, 4], arm * motion[p, 5], arm * motion[p, 6]
                grow = walls[w, 7] if shape[w, 7] == 2.0 else -walls[w, 7]
                vx = motion[p, 0] - walls[w, 4] - grow * nx - (wy * nz - wz * ny)
                vy = motion[p, 1] - walls[w, 5] - grow * ny - (wz * nx - wx * nz)
                vz = motion[p, 2] - walls[w, 6] - grow * nz - (wx * ny - wy * nx)
                twist = 0.5 * (motion[p, 4] * nx + motion[p, 5] * ny + motion[p, 6] * nz)
                mass = 1.0 / motion[p, 3]
                fx, fy, fz, s0, s1, s2, p0, p1, p2, lost, worn = contact_force(
                    kn, ks, 2.0 * damping * math.sqrt(kn * mass), 2.0 * damping * math.sqrt(ks * mass),
                    wall_friction[w], overlap, nx, ny, nz, vx, vy, vz, twist,
                    wall_stretch[e, 0], wall_stretch[e, 1], wall_stretch[e, 2],
                    wall_stretch[e, 3], wall_stretch[e, 4], wall_stretch[e, 5], dt,
                )  # fmt: skip
                wall_stretch[e, 0], wall_stretch[e, 1], wall_stretch[e, 2] = s0, s1, s2
                wall_stretch[e, 3], wall_stretch[e, 4], wall_stretch[e, 5] = p0, p1, p2
                f0 += fx
                f1 += fy
                f2 += fz
                lever = arm / r
                q0 -= lever * (ny * fz - nz * fy)
                q1 -= lever * (nz * fx - nx * fz)
                q2 -= lever * (nx * fy - ny * fx)
                damped += lost
                rubbed += worn
                wall_output[e, 0], wall_output[e, 1], wall_output[e, 2] = -fx, -fy, -fz
                wall_output[e, 3] = fx * nx + fy * ny + fz * nz
                wall_touch[e] = TOUCHING if overlap > 0.0 else 0
        load[p, 0], load[p, 1], load[p, 2] = f0, f1, f2
        load[p, 3], load[p, 4], load[p, 5] = r * q0, r * q1, r * q2
        loss[p, 0] += damped
        loss[p, 2] += rubbed


pair_forces = kernel(parallel=True)(_pair_forces)
pair_forces_serial = kernel(parallel=False)(_pair_forces)
gather = kernel(parallel=True)(_gather)
gather_serial = kernel(parallel=False)(_gather)


@kernel(parallel=False)
def contact_energy(pose, period, c):
    """Elastic energy of all contacts [J]."""
    modulus, soft = c.law[0], c.law[1]
    total = 0.0
    for k in range(len(c.first)):
        if c.touch[k] == TOUCHING:
            dx, dy, dz = branch(pose, c.first[k], c.second[k], period)
            ra, rb = c.radius[c.first[k]], c.radius[c.second[k]]
            overlap = max(ra + rb + c.gap[k] - math.sqrt(dx * dx + dy * dy + dz * dz), 0.0)
            slip = c.stretch[k, 0] ** 2 + c.stretch[k, 1] ** 2 + c.stretch[k, 2] ** 2
            total += 0.5 * pair_stiffness(modulus, ra, rb) * (overlap * overlap + soft * slip)
    for p in range(len(pose)):
        for e in range(c.wall_start[p], c.wall_start[p + 1]):
            if c.wall_touch[e] == TOUCHING:
                r = c.radius[p]
                distance, _, _, _ = wall_gap(pose[p, 0], pose[p, 1], pose[p, 2], r, c.shape, c.walls, c.wall[e])
                overlap = max(c.wall_gap[e] - distance, 0.0)
                slip = c.wall_stretch[e, 0] ** 2 + c.wall_stretch[e, 1] ** 2 + c.wall_stretch[e, 2] ** 2
                total += 0.5 * modulus * math.pi * r * (overlap * overlap + soft * slip)
    return total
