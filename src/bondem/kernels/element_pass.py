"""What elements do with the sums of the forces of their bonds: they move, and leave the sums at zero.

Both schemes are one update with three coefficients (bondem.solve.schemes):

    close the step:  v += finish · a
    open the next:   v += begin · a,    x += dt v + extra a

Boundary conditions live on the few elements that own a row (`row_of[p] >= 0`); the others pay one test.
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


def _open(
    pose, motion, acceleration, row_of, row_fixed, row_force, row_half, row_reaction, work, dt, begin, extra
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
    work, dt, finish, begin, extra, gamma, loss, go_on, first, last, load,
):  # fmt: skip
    """Elements whose sums are complete close the step, and open the next if it is to go on."""
    for e in range(first, last):
        p = element[e]
        s = row[e]
        f0, f1, f2, t0, t1, t2 = sums[s, 0], sums[s, 1], sums[s, 2], sums[s, 3], sums[s, 4], sums[s, 5]
        for d in range(6):
            sums[s, d] = 0.0
        if load is not None:  # of contacts; decided when compiled
            f0 += load[p, 0]
            f1 += load[p, 1]
            f2 += load[p, 2]
            t0 += load[p, 3]
            t1 += load[p, 4]
            t2 += load[p, 5]
        vx, vy, vz = motion[p, 0], motion[p, 1], motion[p, 2]
        wx, wy, wz = motion[p, 4], motion[p, 5], motion[p, 6]
        r = row_of[p]
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
        # two kicks also where they could be one: the bits must not depend on where a run pauses
        vx += finish * ax
        vy += finish * ay
        vz += finish * az
        wx += finish * bx
        wy += finish * by
        wz += finish * bz
        if gamma > 0.0:
            # the velocity between the two kicks gives their work, and the trapezoidal rule a second-order ledger
            power = (
                (g0 - f0) * vx + (g1 - f1) * vy + (g2 - f2) * vz + (h0 - t0) * wx + (h1 - t1) * wy + (h2 - t2) * wz
            )
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
        motion[p, 0], motion[p, 1], motion[p, 2] = vx, vy, vz
        motion[p, 4], motion[p, 5], motion[p, 6] = wx, wy, wz
        if go_on:
            _drift(pose, p, dt, extra, vx, vy, vz, wx, wy, wz, ax, ay, az, bx, by, bz)
        else:
            acceleration[p, 0], acceleration[p, 1], acceleration[p, 2] = ax, ay, az
            acceleration[p, 3], acceleration[p, 4], acceleration[p, 5] = bx, by, bz


open_step = kernel(parallel=True)(_open)
open_step_serial = kernel(parallel=False)(_open)
