"""Walls as rigid bodies: where they are, how they move, and what presses on them.

A row of `walls` is displacement (3) and growth of the radius [m], their rates [m/s] (4), the force of the elements on
the wall (3) and on its radius [N], the work of the wall on the elements [J], and the sum of the normal forces [N].
"""

import math

from bondem._compile import device, kernel
from bondem.kernels.boundary import interpolate

COLUMNS = 14
RATE, FORCE, WORK, NORMAL = 4, 8, 12, 13


@device
def wall_gap(x, y, z, radius, shape, walls, w):
    """Gap between the surface of a sphere and a wall [m], and the unit normal from the wall to the sphere."""
    dx = x - shape[w, 0] - walls[w, 0]
    dy = y - shape[w, 1] - walls[w, 1]
    dz = z - shape[w, 2] - walls[w, 2]
    nx, ny, nz = shape[w, 3], shape[w, 4], shape[w, 5]
    along = dx * nx + dy * ny + dz * nz
    if shape[w, 7] == 0.0:
        return along - radius, nx, ny, nz
    dx, dy, dz = dx - along * nx, dy - along * ny, dz - along * nz
    distance = math.sqrt(dx * dx + dy * dy + dz * dz)
    sign = 1.0 if shape[w, 7] == 2.0 else -1.0
    scale = sign / distance if distance > 0.0 else 0.0
    return sign * (distance - shape[w, 6] - walls[w, 3]) - radius, scale * dx, scale * dy, scale * dz


@kernel(parallel=False)
def move_walls(
    t, dt, shape, walls, times, values, start, drive_wall, drive_component, drive_schedule, drive_rate,
    servo_wall, servo_schedule, servo_speed, servo_mass,
):  # fmt: skip
    """Take the walls from t to t + dt."""
    for e in range(len(drive_wall)):
        s = drive_schedule[e]
        w, c = drive_wall[e], drive_component[e]
        if drive_rate[e]:
            walls[w, RATE + c] = interpolate(times, values, start[s], start[s + 1], t + 0.5 * dt)
        else:
            now = interpolate(times, values, start[s], start[s + 1], t)
            walls[w, RATE + c] = (interpolate(times, values, start[s], start[s + 1], t + dt) - now) / dt
    for e in range(len(servo_wall)):
        s = servo_schedule[e]
        w = servo_wall[e]
        wanted = interpolate(times, values, start[s], start[s + 1], t + dt)
        inward = _inward(shape, walls, w) + dt * (wanted - walls[w, NORMAL]) / servo_mass[e]
        inward = min(max(inward, -servo_speed[e]), servo_speed[e])
        if shape[w, 7] == 0.0:
            for d in range(3):
                walls[w, RATE + d] = inward * shape[w, 3 + d]
        else:
            walls[w, RATE + 3] = inward if shape[w, 7] == 2.0 else -inward
    for w in range(len(walls)):
        for d in range(4):
            walls[w, d] += dt * walls[w, RATE + d]


@kernel(parallel=False)
def load_walls(dt, shape, walls, wall, output):
    """Sum up what the elements do to the walls: rows of `output` are force (3) and normal force."""
    for w in range(len(walls)):
        walls[w, WORK] -= 0.5 * dt * _power(walls, w)
        for c in range(FORCE, FORCE + 4):
            walls[w, c] = 0.0
        walls[w, NORMAL] = 0.0
    for e in range(len(wall)):
        w = wall[e]
        for d in range(3):
            walls[w, FORCE + d] += output[e, d]
        walls[w, NORMAL] += output[e, 3]
    for w in range(len(walls)):
        if shape[w, 7] > 0.0:
            walls[w, FORCE + 3] = -walls[w, NORMAL] if shape[w, 7] == 2.0 else walls[w, NORMAL]
        walls[w, WORK] -= 0.5 * dt * _power(walls, w)


@device
def _inward(shape, walls, w):
    """Speed of a wall towards the elements [m/s]."""
    if shape[w, 7] == 0.0:
        return walls[w, RATE] * shape[w, 3] + walls[w, RATE + 1] * shape[w, 4] + walls[w, RATE + 2] * shape[w, 5]
    return walls[w, RATE + 3] if shape[w, 7] == 2.0 else -walls[w, RATE + 3]


@device
def _power(walls, w):
    power = 0.0
    for c in range(4):
        power += walls[w, FORCE + c] * walls[w, RATE + c]
    return power


@kernel(parallel=False)
def wall_travel(walls, listed):
    """How far a wall has come since the list was made [m]."""
    most = 0.0
    for w in range(len(walls)):
        x, y, z = walls[w, 0] - listed[w, 0], walls[w, 1] - listed[w, 1], walls[w, 2] - listed[w, 2]
        most = max(most, math.sqrt(x * x + y * y + z * z) + abs(walls[w, 3] - listed[w, 3]))
    return most
