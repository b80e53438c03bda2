"""Walls as rigid bodies: where they are, how they move, and what presses on them.

A row of `walls` is displacement (3) and growth of the radius [m], their rates [m/s] (4), the force of the elements on
the wall (3) and on its radius [N], the work of the wall on the elements [J], and the sum of the normal forces [N].
"""

import math

from bondem._compile import device, loop
from bondem.kernels.boundary import interpolate

COLUMNS = 14
GROWTH, RATE, FORCE, WORK, NORMAL = 3, 4, 8, 12, 13
# A row of their shapes is a point (3), the normal or the axis (3), the radius [m], the kind, and that of a hole [m].
AXIS, RADIUS, KIND, HOLE = 3, 6, 7, 8
# Kinds: a plane, a cylinder around the elements, a cylinder among them, a sphere around them, a sphere among them, a
# disc, which may have a hole.
PLANE, INSIDE, OUTSIDE, SHELL, BALL, DISC = 0.0, 1.0, 2.0, 3.0, 4.0, 5.0


@device
def among(kind):
    """Whether elements are outside of a round wall."""
    return kind in (OUTSIDE, BALL)


@device
def flat(kind):
    """Whether a wall is a plane or a part of one."""
    return kind in (PLANE, DISC)


@device
def wall_gap(x, y, z, radius, shape, walls, w):
    """Gap between the surface of a sphere and a wall [m], and the unit normal from the wall to the sphere."""
    dx = x - shape[w, 0] - walls[w, 0]
    dy = y - shape[w, 1] - walls[w, 1]
    dz = z - shape[w, 2] - walls[w, 2]
    nx, ny, nz = shape[w, AXIS], shape[w, AXIS + 1], shape[w, AXIS + 2]  # zeros of a sphere
    along = dx * nx + dy * ny + dz * nz
    if shape[w, KIND] == PLANE:
        return along - radius, nx, ny, nz
    dx, dy, dz = dx - along * nx, dy - along * ny, dz - along * nz
    distance = math.sqrt(dx * dx + dy * dy + dz * dz)
    if shape[w, KIND] == DISC:
        past = max(distance - shape[w, RADIUS], 0.0) - max(shape[w, HOLE] - distance, 0.0)
        if past == 0.0:
            return along - radius, nx, ny, nz
        # beside the disc the nearest place is its rim
        away = math.sqrt(along * along + past * past)
        out = past / (distance * away) if distance > 0.0 else 0.0
        up = along / away
        return away - radius, up * nx + out * dx, up * ny + out * dy, up * nz + out * dz
    sign = 1.0 if among(shape[w, KIND]) else -1.0
    scale = sign / distance if distance > 0.0 else 0.0
    return sign * (distance - shape[w, RADIUS] - walls[w, GROWTH]) - radius, scale * dx, scale * dy, scale * dz


@device
def _wanted(contacts, s, t):
    """Value of a schedule of the walls at time t."""
    return interpolate(contacts.times, contacts.values, contacts.start[s], contacts.start[s + 1], t)


@device
def _kick(c, walls, dt):
    """Velocities of free walls dt later: half a step before they move, half when the forces on them are known."""
    for e in range(len(c.free_wall)):
        w = c.free_wall[e]
        for d in range(3):
            walls[w, RATE + d] += dt * (walls[w, FORCE + d] + c.free_force[e, d]) / c.free_mass[e]


@loop(parallel=False)
def move_walls(t, dt, contacts):
    """Take the walls from t to t + dt."""
    c, shape, walls = contacts, contacts.shape, contacts.walls
    for e in range(len(c.drive_wall)):
        s = c.drive_schedule[e]
        w, column = c.drive_wall[e], RATE + c.drive_component[e]
        if c.drive_rate[e]:
            walls[w, column] = _wanted(c, s, t + 0.5 * dt)
        else:
            walls[w, column] = (_wanted(c, s, t + dt) - _wanted(c, s, t)) / dt
    for e in range(len(c.servo_wall)):
        w = c.servo_wall[e]
        missing = _wanted(c, c.servo_schedule[e], t + dt) - walls[w, NORMAL]
        inward = _inward(shape, walls, w) + dt * missing / c.servo_mass[e]
        inward = min(max(inward, -c.servo_speed[e]), c.servo_speed[e])
        if flat(shape[w, KIND]):
            for d in range(3):
                walls[w, RATE + d] = inward * shape[w, AXIS + d]
        else:
            walls[w, RATE + 3] = inward if among(shape[w, KIND]) else -inward
    _kick(c, walls, 0.5 * dt)
    for w in range(len(walls)):
        for d in range(4):
            walls[w, d] += dt * walls[w, RATE + d]


@loop(parallel=False)
def load_walls(dt, contacts):
    """Sum up what the elements do to the walls: rows of `wall_output` are force (3) and normal force."""
    shape, walls, output = contacts.shape, contacts.walls, contacts.wall_output
    for w in range(len(walls)):
        walls[w, WORK] -= 0.5 * dt * _power(walls, w)
        for c in range(FORCE, FORCE + 4):
            walls[w, c] = 0.0
        walls[w, NORMAL] = 0.0
    for e in range(len(contacts.wall)):
        w = contacts.wall[e]
        for d in range(3):
            walls[w, FORCE + d] += output[e, d]
        walls[w, NORMAL] += output[e, 3]
    for w in range(len(walls)):
        if not flat(shape[w, KIND]):
            walls[w, FORCE + 3] = -walls[w, NORMAL] if among(shape[w, KIND]) else walls[w, NORMAL]
        walls[w, WORK] -= 0.5 * dt * _power(walls, w)
    _kick(contacts, walls, 0.5 * dt)


@device
def _inward(shape, walls, w):
    """Speed of a wall towards the elements [m/s]."""
    if flat(shape[w, KIND]):
        return (
            walls[w, RATE] * shape[w, AXIS]
            + walls[w, RATE + 1] * shape[w, AXIS + 1]
            + walls[w, RATE + 2] * shape[w, AXIS + 2]
        )
    return walls[w, RATE + 3] if among(shape[w, KIND]) else -walls[w, RATE + 3]


@device
def _power(walls, w):
    power = 0.0
    for c in range(4):
        power += walls[w, FORCE + c] * walls[w, RATE + c]
    return power


@loop(parallel=False)
def wall_travel(walls, listed):
    """How far a wall has come since the list was made [m]."""
    most = 0.0
    for w in range(len(walls)):
        x, y, z = walls[w, 0] - listed[w, 0], walls[w, 1] - listed[w, 1], walls[w, 2] - listed[w, 2]
        most = max(most, math.sqrt(x * x + y * y + z * z) + abs(walls[w, GROWTH] - listed[w, GROWTH]))
    return most
