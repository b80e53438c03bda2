"""What elements do with the sums of the forces of their bonds: they move, and leave the sums at zero.

Both schemes are one update with three coefficients (bondem.solve.schemes):

    close the step:  v += finish · a
    open the next:   v += begin · a,    x += dt v + extra a

Boundary conditions live on the few elements that own a row (`row_of[p] >= 0`); the others pay one test. What only
some models have (`bondem.kernels.boundary.Added`) is compiled in where there is any of it.
"""

from bondem._compile import device, kernel, prange
from bondem.laws.damping import local_damping
from bondem.laws.rotations import turn


@device
def _motion_of(motion, p):
    """The six velocities of an element."""
    return motion[p, 0], motion[p, 1], motion[p, 2], motion[p, 4], motion[p, 5], motion[p, 6]


@device
def _prescribed(fixed, velocity, r, vx, vy, vz, wx, wy, wz):
    """Velocities with the prescribed components of row r put in."""
    return (
        velocity[r, 0] if fixed[r, 0] else vx,
        velocity[r, 1] if fixed[r, 1] else vy,
        velocity[r, 2] if fixed[r, 2] else vz,
        velocity[r, 3] if fixed[r, 3] else wx,
        velocity[r, 4] if fixed[r, 4] else wy,
        velocity[r, 5] if fixed[r, 5] else wz,
    )


@device
def _power(fixed, force, reaction, r, vx, vy, vz, wx, wy, wz):
    """Power of loads and reactions on row r [W]."""
    return (
        (reaction[r, 0] if fixed[r, 0] else force[r, 0]) * vx
        + (reaction[r, 1] if fixed[r, 1] else force[r, 1]) * vy
        + (reaction[r, 2] if fixed[r, 2] else force[r, 2]) * vz
        + (reaction[r, 3] if fixed[r, 3] else force[r, 3]) * wx
        + (reaction[r, 4] if fixed[r, 4] else force[r, 4]) * wy
        + (reaction[r, 5] if fixed[r, 5] else force[r, 5]) * wz
    )


@device
def _switched(fixed, velocity, r, m, u, vx, vy, vz, wx, wy, wz):
    """Kinetic energy [J] brought in where prescribed velocities replace the present ones; m = 1/mass, u = 1/I."""
    translation = (
        (velocity[r, 0] ** 2 - vx * vx if fixed[r, 0] else 0.0)
        + (velocity[r, 1] ** 2 - vy * vy if fixed[r, 1] else 0.0)
        + (velocity[r, 2] ** 2 - vz * vz if fixed[r, 2] else 0.0)
    )
    rotation = (
        (velocity[r, 3] ** 2 - wx * wx if fixed[r, 3] else 0.0)
        + (velocity[r, 4] ** 2 - wy * wy if fixed[r, 4] else 0.0)
        + (velocity[r, 5] ** 2 - wz * wz if fixed[r, 5] else 0.0)
    )
    return 0.5 * (translation / m + rotation / u)


@device
def _drift(pose, p, dt, extra, vx, vy, vz, wx, wy, wz, ax, ay, az, bx, by, bz):
    pose[p, 0] += dt * vx + extra * ax
    pose[p, 1] += dt * vy + extra * ay
    pose[p, 2] += dt * vz + extra * az
    q0, q1, q2, q3 = turn(
        pose[p, 4], pose[p, 5], pose[p, 6], pose[p, 7],
        dt * wx + extra * bx, dt * wy + extra * by, dt * wz + extra * bz,
    )  # fmt: skip
    pose[p, 4] = q0
    pose[p, 5] = q1
    pose[p, 6] = q2
    pose[p, 7] = q3


@device
def _with_added(added, motion, p, s, f0, f1, f2, t0, t1, t2):
    """Force and torque with those of contacts, body forces and dashpots of bonds, which are in row s."""
    if len(added.contact) > 0:
        c = added.contact
        f0, f1, f2, t0, t1, t2 = f0 + c[p, 0], f1 + c[p, 1], f2 + c[p, 2], t0 + c[p, 3], t1 + c[p, 4], t2 + c[p, 5]
    if len(added.dashed) > 0:
        c = added.dashed
        f0, f1, f2, t0, t1, t2 = f0 + c[s, 0], f1 + c[s, 1], f2 + c[s, 2], t0 + c[s, 3], t1 + c[s, 4], t2 + c[s, 5]
    if len(added.group) > 0:
        g = added.present[added.group[p]]
        m = motion[p, 3]
        f0, f1, f2 = f0 + g[0] / m, f1 + g[1] / m, f2 + g[2] / m
    return f0, f1, f2, t0, t1, t2


@device
def _body_work(added, work, p, m, half, vx, vy, vz):
    """Add the work of the body forces over half a step [J]; m = 1/mass."""
    if len(added.group) > 0:
        g = added.present[added.group[p]]
        work[added.place + p] += half * (g[0] * vx + g[1] * vy + g[2] * vz) / m


@device
def _free(fixed, r, vx, vy, vz, wx, wy, wz):
    """Velocities, zero in the prescribed components of row r: nothing resists these."""
    if r < 0:
        return vx, vy, vz, wx, wy, wz
    return (
        0.0 if fixed[r, 0] else vx,
        0.0 if fixed[r, 1] else vy,
        0.0 if fixed[r, 2] else vz,
        0.0 if fixed[r, 3] else wx,
        0.0 if fixed[r, 4] else wy,
        0.0 if fixed[r, 5] else wz,
    )


@device
def _resisted(alpha, absorbing, fixed, r, h, m, vx, vy, vz, wx, wy, wz, ax, ay, az, bx, by, bz):
    """Accelerations slowed by mass damping and absorbing dashpots at the velocity a kick of h later.

    Taken at that velocity, which is the one at the time of the forces, they are second order and never unstable.
    """
    vx, vy, vz, wx, wy, wz = _free(fixed, r, vx, vy, vz, wx, wy, wz)
    s = 1.0 + h * alpha
    ax, ay, az = ax - alpha * vx, ay - alpha * vy, az - alpha * vz
    bx, by, bz = (bx - alpha * wx) / s, (by - alpha * wy) / s, (bz - alpha * wz) / s
    if len(absorbing) > 0 and r >= 0:
        xx, yy, zz = m * absorbing[r, 0], m * absorbing[r, 1], m * absorbing[r, 2]
        xy, xz, yz = m * absorbing[r, 3], m * absorbing[r, 4], m * absorbing[r, 5]
        ax -= xx * vx + xy * vy + xz * vz
        ay -= xy * vx + yy * vy + yz * vz
        az -= xz * vx + yz * vy + zz * vz
        xx, yy, zz = s + h * xx, s + h * yy, s + h * zz
        xy, xz, yz = h * xy, h * xz, h * yz
        # the symmetric 3 × 3 system by its cofactors
        c0, c1, c2 = yy * zz - yz * yz, xz * yz - xy * zz, xy * yz - xz * yy
        c3, c4, c5 = xx * zz - xz * xz, xy * xz - xx * yz, xx * yy - xy * xy
        whole = xx * c0 + xy * c1 + xz * c2
        return (
            (c0 * ax + c1 * ay + c2 * az) / whole,
            (c1 * ax + c3 * ay + c4 * az) / whole,
            (c2 * ax + c4 * ay + c5 * az) / whole,
            bx, by, bz,
        )  # fmt: skip
    return ax / s, ay / s, az / s, bx, by, bz


@device
def _resisting_power(added, fixed, s, r, m, u, vx, vy, vz, wx, wy, wz):
    """Power taken by mass damping and dashpots [W]; row s of those of bonds is left at zero. m = 1/mass, u = 1/I."""
    power = 0.0
    if len(added.dashed) > 0:
        c = added.dashed
        power -= c[s, 0] * vx + c[s, 1] * vy + c[s, 2] * vz + c[s, 3] * wx + c[s, 4] * wy + c[s, 5] * wz
        for d in range(6):
            c[s, d] = 0.0
    vx, vy, vz, wx, wy, wz = _free(fixed, r, vx, vy, vz, wx, wy, wz)
    power += added.alpha * ((vx * vx + vy * vy + vz * vz) / m + (wx * wx + wy * wy + wz * wz) / u)
    if len(added.absorbing) > 0 and r >= 0:
        c = added.absorbing[r]
        power += c[0] * vx * vx + c[1] * vy * vy + c[2] * vz * vz
        power += 2.0 * (c[3] * vx * vy + c[4] * vx * vz + c[5] * vy * vz)
    return power


def _open(
    pose, motion, acceleration, row_of, row_fixed, row_force, row_half, row_reaction, work, dt, begin, extra, added
):  # fmt: skip
    for p in prange(len(pose)):
        ax, ay, az = acceleration[p, 0], acceleration[p, 1], acceleration[p, 2]
        bx, by, bz = acceleration[p, 3], acceleration[p, 4], acceleration[p, 5]
        vx, vy, vz = motion[p, 0] + begin * ax, motion[p, 1] + begin * ay, motion[p, 2] + begin * az
        wx, wy, wz = motion[p, 4] + begin * bx, motion[p, 5] + begin * by, motion[p, 6] + begin * bz
        r = row_of[p]
        if r >= 0:
            m, u = motion[p, 3], motion[p, 7]
            work[r] += _switched(row_fixed, row_half, r, m, u, *_motion_of(motion, p))
            vx, vy, vz, wx, wy, wz = _prescribed(row_fixed, row_half, r, vx, vy, vz, wx, wy, wz)
            work[r] += 0.5 * dt * _power(row_fixed, row_force, row_reaction, r, vx, vy, vz, wx, wy, wz)
        if added is not None:
            _body_work(added, work, p, motion[p, 3], 0.5 * dt, vx, vy, vz)
        motion[p, 0], motion[p, 1], motion[p, 2] = vx, vy, vz
        motion[p, 4], motion[p, 5], motion[p, 6] = wx, wy, wz
        _drift(pose, p, dt, extra, vx, vy, vz, wx, wy, wz, ax, ay, az, bx, by, bz)


@kernel(parallel=False)
def collect(sums, row, parts, part, first, last):
    """Add what bonds of other domains have left to the sums of shared elements, and leave zeros there."""
    for e in range(first, last):
        for q in range(parts + part[e], parts + part[e + 1]):
            for d in range(6):
                sums[row[e], d] += sums[q, d]
                sums[q, d] = 0.0


@kernel(parallel=False)
def move(
    pose, motion, acceleration, sums, element, row, row_of, row_fixed, row_force, row_half, row_full, row_reaction,
    work, dt, finish, begin, extra, gamma, loss, go_on, first, last, added,
):  # fmt: skip
    """Elements whose sums are complete close the step, and open the next if it is to go on."""
    resisting = gamma > 0.0
    kick = finish if finish > 0.0 else begin
    if added is not None:
        resisting = resisting or added.viscous
    for e in range(first, last):
        p = element[e]
        s = row[e]
        f0, f1, f2, t0, t1, t2 = sums[s, 0], sums[s, 1], sums[s, 2], sums[s, 3], sums[s, 4], sums[s, 5]
        for d in range(6):
            sums[s, d] = 0.0
        if added is not None:  # decided when compiled
            f0, f1, f2, t0, t1, t2 = _with_added(added, motion, p, s, f0, f1, f2, t0, t1, t2)
        vx, vy, vz = motion[p, 0], motion[p, 1], motion[p, 2]
        wx, wy, wz = motion[p, 4], motion[p, 5], motion[p, 6]
        r = row_of[p]
        if added is not None:
            _body_work(added, work, p, motion[p, 3], 0.5 * dt, vx, vy, vz)
        if r >= 0:
            row_reaction[r, 0], row_reaction[r, 1], row_reaction[r, 2] = -f0, -f1, -f2
            row_reaction[r, 3], row_reaction[r, 4], row_reaction[r, 5] = -t0, -t1, -t2
            work[r] += 0.5 * dt * _power(row_fixed, row_force, row_reaction, r, vx, vy, vz, wx, wy, wz)
            f0 += row_force[r, 0]
            f1 += row_force[r, 1]
            f2 += row_force[r, 2]
            t0 += row_force[r, 3]
            t1 += row_force[r, 4]
            t2 += row_force[r, 5]
            f0 = 0.0 if row_fixed[r, 0] else f0
            f1 = 0.0 if row_fixed[r, 1] else f1
            f2 = 0.0 if row_fixed[r, 2] else f2
            t0 = 0.0 if row_fixed[r, 3] else t0
            t1 = 0.0 if row_fixed[r, 4] else t1
            t2 = 0.0 if row_fixed[r, 5] else t2
        g0, g1, g2, h0, h1, h2 = f0, f1, f2, t0, t1, t2
        if gamma > 0.0:
            f0 = local_damping(f0, vx, gamma)
            f1 = local_damping(f1, vy, gamma)
            f2 = local_damping(f2, vz, gamma)
            t0 = local_damping(t0, wx, gamma)
            t1 = local_damping(t1, wy, gamma)
            t2 = local_damping(t2, wz, gamma)
        m = motion[p, 3]
        u = motion[p, 7]
        ax, ay, az = m * f0, m * f1, m * f2
        bx, by, bz = u * t0, u * t1, u * t2
        if added is not None and added.viscous:
            ax, ay, az, bx, by, bz = _resisted(
                added.alpha, added.absorbing, row_fixed, r, kick, m, vx, vy, vz, wx, wy, wz, ax, ay, az, bx, by, bz
            )
        # two kicks also where they could be one: the bits must not depend on where a run pauses
        vx += finish * ax
        vy += finish * ay
        vz += finish * az
        wx += finish * bx
        wy += finish * by
        wz += finish * bz
        if resisting:
            # the velocity between the two kicks gives their work, and the trapezoidal rule a second-order ledger
            power = (
                (g0 - f0) * vx + (g1 - f1) * vy + (g2 - f2) * vz + (h0 - t0) * wx + (h1 - t1) * wy + (h2 - t2) * wz
            )
            if added is not None:
                power += _resisting_power(added, row_fixed, s, r, m, u, vx, vy, vz, wx, wy, wz)
            loss[p, 0] += 0.5 * dt * (loss[p, 1] + power)
            loss[p, 1] = power
        if r >= 0:
            work[r] += _switched(row_fixed, row_full, r, m, u, vx, vy, vz, wx, wy, wz)
            vx, vy, vz, wx, wy, wz = _prescribed(row_fixed, row_full, r, vx, vy, vz, wx, wy, wz)
        if go_on:
            vx += begin * ax
            vy += begin * ay
            vz += begin * az
            wx += begin * bx
            wy += begin * by
            wz += begin * bz
            if r >= 0:
                work[r] += _switched(row_fixed, row_half, r, m, u, vx, vy, vz, wx, wy, wz)
                vx, vy, vz, wx, wy, wz = _prescribed(row_fixed, row_half, r, vx, vy, vz, wx, wy, wz)
                work[r] += 0.5 * dt * _power(row_fixed, row_force, row_reaction, r, vx, vy, vz, wx, wy, wz)
            if added is not None:
                _body_work(added, work, p, m, 0.5 * dt, vx, vy, vz)
        motion[p, 0], motion[p, 1], motion[p, 2] = vx, vy, vz
        motion[p, 4], motion[p, 5], motion[p, 6] = wx, wy, wz
        if go_on:
            _drift(pose, p, dt, extra, vx, vy, vz, wx, wy, wz, ax, ay, az, bx, by, bz)
        else:
            acceleration[p, 0], acceleration[p, 1], acceleration[p, 2] = ax, ay, az
            acceleration[p, 3], acceleration[p, 4], acceleration[p, 5] = bx, by, bz


open_step = kernel(parallel=True)(_open)
open_step_serial = kernel(parallel=False)(_open)
