"""One thread an element: it gathers its bonds and moves; one a boundary row: its schedules.

The step number is on the device (`clock`), so that the launches of a step are the same for every step. The sequence
is that of `bondem.kernels.element_pass` and `bondem.kernels.boundary`, by the same functions. (As one function of
both, with its dozen arrays, it would take the CPU twice the time for a step.)
"""

from bondem._compile_cuda import cuda, cuda_kernel
from bondem.kernels.boundary import interpolate
from bondem.kernels.element_pass import _drift, _motion_of, _power, _prescribed, _switched
from bondem.laws.damping import local_damping


@cuda_kernel
def schedule_rows(
    clock, ahead, t0, dt, count, times, values, start, load_start, load_schedule, load_value,
    drive_start, drive_dof, drive_schedule, drive_rate, row_force, row_half, row_full,
):  # fmt: skip
    """Set a row's force and velocities `ahead` steps from now; its loads and drives are contiguous."""
    r = cuda.grid(1)
    if r >= count:
        return
    t = t0 + (clock[0] + ahead) * dt
    for d in range(6):
        row_force[r, d] = 0.0
    for e in range(load_start[r], load_start[r + 1]):
        s = load_schedule[e]
        amplitude = interpolate(times, values, start[s], start[s + 1], t)
        for d in range(6):
            row_force[r, d] += amplitude * load_value[e, d]
    for e in range(drive_start[r], drive_start[r + 1]):
        s = drive_schedule[e]
        d = drive_dof[e]
        now = interpolate(times, values, start[s], start[s + 1], t)
        if drive_rate[e]:
            row_full[r, d] = now
            row_half[r, d] = interpolate(times, values, start[s], start[s + 1], t + 0.5 * dt)
        else:
            row_half[r, d] = (interpolate(times, values, start[s], start[s + 1], t + dt) - now) / dt
            row_full[r, d] = row_half[r, d]


@cuda_kernel
def open_step(
    pose, motion, acceleration, row_of, row_fixed, row_force, row_half, row_reaction, work, dt, begin, extra
):  # fmt: skip
    """Open a step after a pause."""
    p = cuda.grid(1)
    if p >= pose.shape[0]:
        return
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


@cuda_kernel
def move(
    clock, tick, pose, motion, acceleration, forces, in_start, out_start, out_bond,
    row_of, row_fixed, row_force, row_half, row_full, row_reaction, work,
    dt, finish, begin, extra, gamma, loss, go_on,
):  # fmt: skip
    """Add up an element's bonds, close the step, and open the next or not; the clock goes on by `tick`.

    Bonds are added as on the CPU: those with j = p, then those with i = p, both ascending.
    """
    p = cuda.grid(1)
    if p == 0:
        clock[0] += tick
    if p >= pose.shape[0]:
        return
    f0 = f1 = f2 = t0 = t1 = t2 = 0.0
    for k in range(in_start[p], in_start[p + 1]):
        f0 += forces[0, k]
        f1 += forces[1, k]
        f2 += forces[2, k]
        t0 += forces[6, k]
        t1 += forces[7, k]
        t2 += forces[8, k]
    for e in range(out_start[p], out_start[p + 1]):
        k = out_bond[e]
        f0 -= forces[0, k]
        f1 -= forces[1, k]
        f2 -= forces[2, k]
        t0 += forces[3, k]
        t1 += forces[4, k]
        t2 += forces[5, k]
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
