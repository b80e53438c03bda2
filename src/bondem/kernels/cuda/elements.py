"""One thread an element: it gathers its bonds and moves; one a boundary row, or a body force's group: its schedules.

The step number is on the device (`clock`), so that the launches of a step are the same for every step. The sequence
is that of `bondem.kernels.element_pass` and `bondem.kernels.boundary`, by the same functions. (As one function of
both, with its dozen arrays, it would take the CPU twice the time for a step.)
"""

from bondem._compile import device
from bondem._compile_cuda import cuda, cuda_kernel
from bondem.kernels.boundary import interpolate
from bondem.kernels.couples import add_couple
from bondem.kernels.element_rows import gripped, loaded, prescribed, react, row_power, switched_energy
from bondem.kernels.tables import DAMPED, INVERSE_INERTIA, INVERSE_MASS, POWER
from bondem.laws.damping import direction, local_damping
from bondem.laws.rotations import turn


@device
def _velocities(motion, p):
    return (motion[p, 0], motion[p, 1], motion[p, 2]), (motion[p, 4], motion[p, 5], motion[p, 6])


@device
def _put_velocities(motion, p, v, w):
    motion[p, 0], motion[p, 1], motion[p, 2] = v
    motion[p, 4], motion[p, 5], motion[p, 6] = w


@device
def _kicked(v, h, a):
    return v[0] + h * a[0], v[1] + h * a[1], v[2] + h * a[2]


@device
def _damped(f, v, gamma):
    return (
        local_damping(f[0], direction(v[0]), gamma),
        local_damping(f[1], direction(v[1]), gamma),
        local_damping(f[2], direction(v[2]), gamma),
    )


@device
def _drift(pose, p, dt, extra, v, w, a, b):
    pose[p, 0] += dt * v[0] + extra * a[0]
    pose[p, 1] += dt * v[1] + extra * a[1]
    pose[p, 2] += dt * v[2] + extra * a[2]
    pose[p, 4], pose[p, 5], pose[p, 6], pose[p, 7] = turn(
        pose[p, 4], pose[p, 5], pose[p, 6], pose[p, 7],
        dt * w[0] + extra * b[0], dt * w[1] + extra * b[1], dt * w[2] + extra * b[2],
    )  # fmt: skip


@device
def _value(schedules, s, t):
    return interpolate(schedules.times, schedules.values, schedules.start[s], schedules.start[s + 1], t)


@cuda_kernel
def schedule_rows(clock, ahead, scheme, schedules, rows):
    """Set a row's force and velocities `ahead` steps from now."""
    r = cuda.grid(1)
    if r >= schedules.r:
        return
    dt = scheme.dt
    t = scheme.origin + (clock[0] + ahead) * dt
    for d in range(6):
        rows.force[r, d] = 0.0
    for e in range(schedules.load_start[r], schedules.load_start[r + 1]):
        amplitude = _value(schedules, schedules.load_schedule[e], t)
        for d in range(6):
            rows.force[r, d] += amplitude * schedules.load_value[e, d]
    for e in range(schedules.drive_start[r], schedules.drive_start[r + 1]):
        s = schedules.drive_schedule[e]
        d = schedules.drive_dof[e]
        now = _value(schedules, s, t)
        if schedules.drive_rate[e]:
            rows.full[r, d] = now
            rows.half[r, d] = _value(schedules, s, t + 0.5 * dt)
        else:
            rows.half[r, d] = (_value(schedules, s, t + dt) - now) / dt
            rows.full[r, d] = rows.half[r, d]


@cuda_kernel
def turn_moments(clock, ahead, scheme, schedules, couples, pose, rows):
    """Add the forces of moments to those of the rows; one thread, as rows may have several."""
    if cuda.grid(1) > 0:
        return
    t = scheme.origin + (clock[0] + ahead) * scheme.dt
    for c in range(couples.schedule.shape[0]):
        add_couple(couples, c, _value(schedules, couples.schedule[c], t), pose, rows.force)


@cuda_kernel
def pull_groups(clock, ahead, scheme, schedules, bodies):
    """Set the acceleration that body forces give a group `ahead` steps from now."""
    g = cuda.grid(1)
    if g >= bodies.present.shape[0] or bodies.b == 0:
        return
    t = scheme.origin + (clock[0] + ahead) * scheme.dt
    for d in range(3):
        bodies.present[g, d] = 0.0
    for b in range(bodies.b):
        amplitude = _value(schedules, bodies.schedule[b], t)
        for d in range(3):
            bodies.present[g, d] += bodies.member[g, b] * amplitude * bodies.pull[b, d]


@device
def _pulled(bodies, p, m, f):
    """Force with body forces, if there are any; m = 1/mass."""
    if bodies.b == 0:
        return f
    g, a = bodies.group[p], bodies.present
    return f[0] + a[g, 0] / m, f[1] + a[g, 1] / m, f[2] + a[g, 2] / m


@device
def _body_work(work, bodies, p, m, half, v):
    """Add the work of the body forces over half a step [J]."""
    if bodies.b > 0:
        g, a = bodies.group[p], bodies.present
        work[bodies.place + p] += half * (a[g, 0] * v[0] + a[g, 1] * v[1] + a[g, 2] * v[2]) / m


@device
def open_one(elements, rows, bodies, scheme, p):
    """Open a step of one element from its stored acceleration, as after a pause."""
    motion, acceleration, dt, begin = elements.motion, elements.acceleration, scheme.dt, scheme.begin
    a = acceleration[p, 0], acceleration[p, 1], acceleration[p, 2]
    b = acceleration[p, 3], acceleration[p, 4], acceleration[p, 5]
    v, w = _velocities(motion, p)
    m, u = motion[p, INVERSE_MASS], motion[p, INVERSE_INERTIA]
    r = rows.of[p]
    if r >= 0:
        rows.work[r] += switched_energy(rows.fixed, rows.half, r, m, u, v, w)
    v, w = _kicked(v, begin, a), _kicked(w, begin, b)
    if r >= 0:
        v, w = prescribed(rows.fixed, rows.half, r, v, w)
        rows.work[r] += 0.5 * dt * row_power(rows.fixed, rows.force, rows.reaction, r, v, w)
    _body_work(rows.work, bodies, p, m, 0.5 * dt, v)
    _put_velocities(motion, p, v, w)
    _drift(elements.pose, p, dt, scheme.extra, v, w, a, b)


@cuda_kernel
def open_step(elements, rows, bodies, scheme):
    """Open a step after a pause."""
    p = cuda.grid(1)
    if p >= elements.pose.shape[0]:
        return
    open_one(elements, rows, bodies, scheme, p)


@device
def move_one(elements, adjacency, forces, rows, bodies, scheme, go_on, p):
    """Add up the bonds or facets of one element, close the step, and open the next or not.

    Bonds are added as on the CPU: those with j = p, then those with i = p, both ascending.
    """
    motion, acceleration, loss = elements.motion, elements.acceleration, elements.loss
    dt, finish, begin, gamma = scheme.dt, scheme.finish, scheme.begin, scheme.gamma
    f0 = f1 = f2 = t0 = t1 = t2 = 0.0
    for k in range(adjacency.in_start[p], adjacency.in_start[p + 1]):
        f0 += forces[0, k]
        f1 += forces[1, k]
        f2 += forces[2, k]
        t0 += forces[6, k]
        t1 += forces[7, k]
        t2 += forces[8, k]
    for e in range(adjacency.out_start[p], adjacency.out_start[p + 1]):
        k = adjacency.out_bond[e]
        f0 -= forces[0, k]
        f1 -= forces[1, k]
        f2 -= forces[2, k]
        t0 += forces[3, k]
        t1 += forces[4, k]
        t2 += forces[5, k]
    f, t = (f0, f1, f2), (t0, t1, t2)
    v, w = _velocities(motion, p)
    m, u = motion[p, INVERSE_MASS], motion[p, INVERSE_INERTIA]
    f = _pulled(bodies, p, m, f)
    _body_work(rows.work, bodies, p, m, 0.5 * dt, v)
    r = rows.of[p]
    if r >= 0:
        f, t = gripped(rows.grip, r, f, t)
        react(rows.reaction, r, f, t)
        rows.work[r] += 0.5 * dt * row_power(rows.fixed, rows.force, rows.reaction, r, v, w)
        f, t = loaded(rows.fixed, rows.force, r, f, t)
    whole_f, whole_t = f, t
    if gamma > 0.0:
        f, t = _damped(f, v, gamma), _damped(t, w, gamma)
    a, b = (m * f[0], m * f[1], m * f[2]), (u * t[0], u * t[1], u * t[2])
    # two kicks also where they could be one: the bits must not depend on where a run pauses
    v, w = _kicked(v, finish, a), _kicked(w, finish, b)
    if gamma > 0.0:
        # the velocity between the two kicks gives their work, and the trapezoidal rule a second-order ledger
        power = (
            (whole_f[0] - f[0]) * v[0] + (whole_f[1] - f[1]) * v[1] + (whole_f[2] - f[2]) * v[2]
            + (whole_t[0] - t[0]) * w[0] + (whole_t[1] - t[1]) * w[1] + (whole_t[2] - t[2]) * w[2]
        )  # fmt: skip
        loss[p, DAMPED] += 0.5 * dt * (loss[p, POWER] + power)
        loss[p, POWER] = power
    if r >= 0:
        rows.work[r] += switched_energy(rows.fixed, rows.full, r, m, u, v, w)
        v, w = prescribed(rows.fixed, rows.full, r, v, w)
    if go_on:
        v, w = _kicked(v, begin, a), _kicked(w, begin, b)
        if r >= 0:
            rows.work[r] += switched_energy(rows.fixed, rows.half, r, m, u, v, w)
            v, w = prescribed(rows.fixed, rows.half, r, v, w)
            rows.work[r] += 0.5 * dt * row_power(rows.fixed, rows.force, rows.reaction, r, v, w)
        _body_work(rows.work, bodies, p, m, 0.5 * dt, v)
    _put_velocities(motion, p, v, w)
    if go_on:
        _drift(elements.pose, p, dt, scheme.extra, v, w, a, b)
    else:
        for d in range(3):
            acceleration[p, d] = a[d]
            acceleration[p, 3 + d] = b[d]


@cuda_kernel
def move(clock, tick, elements, adjacency, forces, rows, bodies, scheme, go_on):
    """Every element closes the step, and opens the next or not; the clock goes on by `tick`."""
    p = cuda.grid(1)
    if p == 0:
        clock[0] += tick
    if p >= elements.pose.shape[0]:
        return
    move_one(elements, adjacency, forces, rows, bodies, scheme, go_on, p)
