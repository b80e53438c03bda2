"""Soft spheres between rigid walls, brought to mechanical equilibrium.

Overlapping spheres repel with unit stiffness, walls let nothing through, and the energy is minimised by
FIRE 2.0 (Guénolé et al., Comput. Mater. Sci. 175, 2020): inertial descent that is steered along the force
and stopped whenever it runs uphill. Unit mass and stiffness make every time dimensionless.
"""

import math

import numpy as np

from bondem._compile import device, kernel, prange
from bondem.kernels.neighbour_grid import inverse_period, nearest_image

# Partial sums over blocks of fixed size, added up in order: the result does not depend on the threads.
_BLOCK = 128

# Walls: a box (infinite where it has no wall) and a round wall about the axes whose weight is 1.
# wall = lower (3), upper (3), weight (3), radius of the round wall. Any other shape appends its depth on a
# grid: lower corner (3), spacing, counts (3), and the depths, the last axis fastest.
_PLAIN, _GRID = 10, 17

# A sphere this near a wall of the grid, over its radius, touches it.
_TOUCH = 1e-6

# What a call of `relax` ended with.
CONVERGED, STALE, EXHAUSTED, LOOSE = 0, 1, 2, 3

# FIRE: longest step (the stiffest sphere stays stable to about 0.7), mixing, and when to trust the descent.
DT_START, DT_MAX, ALPHA, PATIENCE = 0.15, 0.45, 0.25, 10

# Longest step between walls on a grid: a sphere pressed into a rounded edge swings fast.
_DT_MAX_GRID = 0.25


@device
def _round_distance(x, y, z, wall):
    return math.sqrt(wall[6] * x * x + wall[7] * y * y + wall[8] * z * z)


@device
def _grid_depth(x, y, z, wall, enough):
    """Depth at a point and its gradient, smooth over the grid; some depth above `enough` where it is more."""
    h = wall[13]
    nx, ny, nz = int(wall[14]), int(wall[15]), int(wall[16])
    u, v, w = (x - wall[10]) / h, (y - wall[11]) / h, (z - wall[12]) / h
    i = min(max(int(u + 0.5), 1), nx - 2)
    j = min(max(int(v + 0.5), 1), ny - 2)
    k = min(max(int(w + 0.5), 1), nz - 2)
    depth = wall[_GRID + (i * ny + j) * nz + k]
    gx, gy, gz = 0.0, 0.0, 0.0
    if depth <= enough + 2.0 * h:
        # Quadratic B-splines: without a jump in the gradient no sphere is driven to and fro between two normals.
        u, v, w = min(max(u - i, -0.5), 0.5), min(max(v - j, -0.5), 0.5), min(max(w - k, -0.5), 0.5)
        depth = 0.0
        for a in range(3):
            fa, da = _spline(a, u)
            for b in range(3):
                fb, db = _spline(b, v)
                for c in range(3):
                    fc, dc = _spline(c, w)
                    value = wall[_GRID + ((i + a - 1) * ny + j + b - 1) * nz + k + c - 1]
                    depth += fa * fb * fc * value
                    gx += da * fb * fc * value
                    gy += fa * db * fc * value
                    gz += fa * fb * dc * value
        gx, gy, gz = gx / h, gy / h, gz / h
    return depth, gx, gy, gz


@device
def _spline(which, t):
    """Weight of the node before, at or after the nearest one, t in -0.5 … 0.5 from it, and its slope."""
    if which == 0:
        return 0.5 * (0.5 - t) * (0.5 - t), t - 0.5
    if which == 1:
        return 0.75 - t * t, -2.0 * t
    return 0.5 * (0.5 + t) * (0.5 + t), t + 0.5


@kernel(parallel=True)
def relax(
    sphere, velocity, force, period, wall, start, neighbour, listed, slack, fire, tolerance, loose, steps, report
):
    """Minimise the overlap energy, as far as the neighbour list is valid.

    Args:
        sphere: centres and radii [m], shape (n, 4); centres are moved.
        velocity: shape (n, 3), kept between calls.
        force: overlap forces [m], shape (n, 3), less what walls bear.
        period: periodic edge lengths [m], (3,), 0 where there is none.
        wall: the walls, (10,), or with a grid of depths.
        start: where each sphere's neighbours begin, (n + 1,).
        neighbour: neighbour lists.
        listed: centres when the list was made [m], shape (n, 3).
        slack: how far a centre may move before the list is stale [m].
        fire: time step, mixing and number of steps downhill, (3,), kept between calls.
        tolerance: converged when the rms force is below this share of the mean contact force [-].
        loose: spheres with a mean overlap below this do not press on each other [m].
        steps: most steps to take.
        report: filled with rms force [m], mean overlap [m], contacts, largest overlap [m], steps taken; (5,).

    Returns:
        CONVERGED, LOOSE, STALE (make a new list and call again) or EXHAUSTED.
    """
    n = sphere.shape[0]
    blocks = (n + _BLOCK - 1) // _BLOCK
    part = np.zeros((blocks, 8))
    px, py, pz = period[0], period[1], period[2]
    qx, qy, qz = inverse_period(px), inverse_period(py), inverse_period(pz)
    longest = DT_MAX if wall.size == _PLAIN else _DT_MAX_GRID
    for step in range(steps + 1):
        for b in prange(blocks):
            power, ff, vv, overlap, contacts, deepest = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
            for i in range(b * _BLOCK, min((b + 1) * _BLOCK, n)):
                x, y, z, r = sphere[i, 0], sphere[i, 1], sphere[i, 2], sphere[i, 3]
                fx, fy, fz = 0.0, 0.0, 0.0
                for k in range(start[i], start[i + 1]):
                    j = neighbour[k]
                    dx = nearest_image(sphere[j, 0] - x, px, qx)
                    dy = nearest_image(sphere[j, 1] - y, py, qy)
                    dz = nearest_image(sphere[j, 2] - z, pz, qz)
                    touch = r + sphere[j, 3]
                    # No branch: about a third of the neighbours do not touch, in no order a processor could guess.
                    d = math.sqrt(max(dx * dx + dy * dy + dz * dz, 1e-300))
                    deep = max(touch - d, 0.0)
                    push = deep / d
                    fx -= push * dx
                    fy -= push * dy
                    fz -= push * dz
                    overlap += deep
                    contacts += 1.0 if deep > 0.0 else 0.0
                    deepest = max(deepest, deep)
                # Rigid walls bear what presses against them.
                near = r * (1.0 + 1e-12)
                if (x - wall[0] <= near and fx < 0.0) or (wall[3] - x <= near and fx > 0.0):
                    fx = 0.0
                if (y - wall[1] <= near and fy < 0.0) or (wall[4] - y <= near and fy > 0.0):
                    fy = 0.0
                if (z - wall[2] <= near and fz < 0.0) or (wall[5] - z <= near and fz > 0.0):
                    fz = 0.0
                rho = _round_distance(x, y, z, wall)
                if wall[9] - rho <= near:
                    nx, ny, nz = wall[6] * x / rho, wall[7] * y / rho, wall[8] * z / rho
                    out = max(fx * nx + fy * ny + fz * nz, 0.0)
                    fx -= out * nx
                    fy -= out * ny
                    fz -= out * nz
                if wall.size > _PLAIN:
                    d, nx, ny, nz = _grid_depth(x, y, z, wall, r)
                    if d <= r * (1.0 + _TOUCH):
                        steep = max(nx * nx + ny * ny + nz * nz, 0.01)
                        out = min(fx * nx + fy * ny + fz * nz, 0.0) / steep
                        fx -= out * nx
                        fy -= out * ny
                        fz -= out * nz
                force[i, 0], force[i, 1], force[i, 2] = fx, fy, fz
                vx, vy, vz = velocity[i, 0], velocity[i, 1], velocity[i, 2]
                power += fx * vx + fy * vy + fz * vz
                ff += fx * fx + fy * fy + fz * fz
                vv += vx * vx + vy * vy + vz * vz
            part[b, 0], part[b, 1], part[b, 2], part[b, 3] = power, ff, vv, overlap
            part[b, 4], part[b, 5] = contacts, deepest

        power, ff, vv, overlap, contacts, deepest = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
        for b in range(blocks):
            power += part[b, 0]
            ff += part[b, 1]
            vv += part[b, 2]
            overlap += part[b, 3]
            contacts += part[b, 4]
            deepest = max(deepest, part[b, 5])
        mean = overlap / max(contacts, 1.0)
        report[0], report[1], report[2], report[3] = math.sqrt(ff / n), mean, 0.5 * contacts, deepest
        report[4] = step
        if math.sqrt(ff / n) <= tolerance * mean:
            return CONVERGED
        if mean < loose:
            return LOOSE
        if step == steps:
            return EXHAUSTED

        back = 0.0
        if power > 0.0:
            fire[2] += 1.0
            if fire[2] > PATIENCE:
                fire[0] = min(1.1 * fire[0], longest)
                fire[1] *= 0.99
        else:
            back = 0.5 * fire[0]
            fire[0] = max(0.5 * fire[0], 0.02)
            fire[1] = ALPHA
            fire[2] = 0.0
        dt = fire[0]
        keep = 0.0 if back > 0.0 else 1.0 - fire[1]
        steer = 0.0 if back > 0.0 else fire[1] * math.sqrt(vv / ff)

        for b in prange(blocks):
            farthest = 0.0
            for i in range(b * _BLOCK, min((b + 1) * _BLOCK, n)):
                r = sphere[i, 3]
                fx, fy, fz = force[i, 0], force[i, 1], force[i, 2]
                ux, uy, uz = velocity[i, 0], velocity[i, 1], velocity[i, 2]
                vx = keep * ux + (steer + dt) * fx
                vy = keep * uy + (steer + dt) * fy
                vz = keep * uz + (steer + dt) * fz
                x = sphere[i, 0] - back * ux + dt * vx
                y = sphere[i, 1] - back * uy + dt * vy
                z = sphere[i, 2] - back * uz + dt * vz
                # A wall that is reached stops the sphere: its velocity along the normal is gone.
                if x < wall[0] + r:
                    x, vx = wall[0] + r, max(vx, 0.0)
                if x > wall[3] - r:
                    x, vx = wall[3] - r, min(vx, 0.0)
                if y < wall[1] + r:
                    y, vy = wall[1] + r, max(vy, 0.0)
                if y > wall[4] - r:
                    y, vy = wall[4] - r, min(vy, 0.0)
                if z < wall[2] + r:
                    z, vz = wall[2] + r, max(vz, 0.0)
                if z > wall[5] - r:
                    z, vz = wall[5] - r, min(vz, 0.0)
                rho = _round_distance(x, y, z, wall)
                if rho > wall[9] - r:
                    nx, ny, nz = wall[6] * x / rho, wall[7] * y / rho, wall[8] * z / rho
                    inward = rho - (wall[9] - r)
                    out = max(vx * nx + vy * ny + vz * nz, 0.0)
                    x -= inward * nx
                    y -= inward * ny
                    z -= inward * nz
                    vx -= out * nx
                    vy -= out * ny
                    vz -= out * nz
                if wall.size > _PLAIN:
                    beyond, steep = False, 1.0
                    nx = ny = nz = 0.0
                    for _ in range(3):  # Newton's steps back to the wall, where need be from either side
                        d, nx, ny, nz = _grid_depth(x, y, z, wall, r)
                        beyond = beyond or d < r
                        if not beyond:
                            break
                        steep = max(nx * nx + ny * ny + nz * nz, 0.01)
                        x += (r - d) * nx / steep
                        y += (r - d) * ny / steep
                        z += (r - d) * nz / steep
                    if beyond:
                        out = min(vx * nx + vy * ny + vz * nz, 0.0) / steep
                        vx -= out * nx
                        vy -= out * ny
                        vz -= out * nz
                sphere[i, 0], sphere[i, 1], sphere[i, 2] = x, y, z
                velocity[i, 0], velocity[i, 1], velocity[i, 2] = vx, vy, vz
                dx, dy, dz = x - listed[i, 0], y - listed[i, 1], z - listed[i, 2]
                farthest = max(farthest, dx * dx + dy * dy + dz * dz)
            part[b, 6] = farthest
        farthest = 0.0
        for b in range(blocks):
            farthest = max(farthest, part[b, 6])
        if farthest > slack * slack:
            return STALE
    return EXHAUSTED
