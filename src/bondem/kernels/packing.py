"""Soft spheres between rigid walls, brought to mechanical equilibrium.

Overlapping spheres repel with unit stiffness, walls let nothing through, and the energy is minimised by
FIRE 2.0 (Guénolé et al., Comput. Mater. Sci. 175, 2020): inertial descent that is steered along the force
and stopped whenever it runs uphill. Unit mass and stiffness make every time dimensionless.
"""

import math

import numpy as np

from bondem._compile import device, kernel, prange
from bondem.kernels.neighbour_grid import inverse_period, nearest_image
from bondem.kernels.packing_walls import borne, borne_by_both, has_grid, kept_on_grid, kept_within, plain_walls

# Partial sums over blocks of fixed size, added up in order: the result does not depend on the threads.
_BLOCK = 128

# Columns of these partial sums.
_POWER, _FORCE, _SPEED, _OVERLAP, _CONTACTS, _DEEPEST, _FARTHEST, _SUMS = range(8)

# What a call of `relax` ended with.
CONVERGED, STALE, EXHAUSTED, LOOSE = 0, 1, 2, 3

# Columns of the report of `relax`: rms force [m], mean overlap [m], contacts, largest overlap [m], steps taken.
RMS_FORCE, MEAN_OVERLAP, CONTACTS, LARGEST_OVERLAP, STEPS, REPORTED = range(6)

# FIRE: longest step (the stiffest sphere stays stable to about 0.7), mixing, and when to trust the descent.
DT_START, DT_MAX, ALPHA, PATIENCE = 0.15, 0.45, 0.25, 10

# Longest step between walls on a grid: a sphere pressed into a rounded edge swings fast.
_DT_MAX_GRID = 0.25

# Columns of what FIRE keeps: time step, mixing, steps downhill.
_DT, _MIXING, _DOWNHILL = range(3)


@device
def _blocks(n):
    return (n + _BLOCK - 1) // _BLOCK


@device
def _press(spheres, walls, near, b, part):
    """Forces on the spheres of a block, and what they sum up to."""
    sphere, velocity, force = spheres.sphere, spheres.velocity, spheres.force
    px, py, pz = spheres.period[0], spheres.period[1], spheres.period[2]
    qx, qy, qz = inverse_period(px), inverse_period(py), inverse_period(pz)
    start, neighbour, plain, grid = near.start, near.neighbour, plain_walls(walls), has_grid(walls)
    power, ff, vv, overlap, contacts, deepest = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for i in range(b * _BLOCK, min((b + 1) * _BLOCK, len(sphere))):
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
        if grid:
            fx, fy, fz = borne_by_both(plain, walls, x, y, z, r, fx, fy, fz)
        else:
            fx, fy, fz = borne(plain, x, y, z, r, fx, fy, fz)
        force[i, 0], force[i, 1], force[i, 2] = fx, fy, fz
        vx, vy, vz = velocity[i, 0], velocity[i, 1], velocity[i, 2]
        power += fx * vx + fy * vy + fz * vz
        ff += fx * fx + fy * fy + fz * fz
        vv += vx * vx + vy * vy + vz * vz
    part[b, _POWER], part[b, _FORCE], part[b, _SPEED], part[b, _OVERLAP] = power, ff, vv, overlap
    part[b, _CONTACTS], part[b, _DEEPEST] = contacts, deepest


@device
def _descend(spheres, walls, listed, back, dt, keep, steer, b, part):
    """Move the spheres of a block, and find how far any has come since the neighbour list was made."""
    sphere, velocity, force = spheres.sphere, spheres.velocity, spheres.force
    plain, grid, farthest = plain_walls(walls), has_grid(walls), 0.0
    for i in range(b * _BLOCK, min((b + 1) * _BLOCK, len(sphere))):
        fx, fy, fz = force[i, 0], force[i, 1], force[i, 2]
        ux, uy, uz = velocity[i, 0], velocity[i, 1], velocity[i, 2]
        vx = keep * ux + (steer + dt) * fx
        vy = keep * uy + (steer + dt) * fy
        vz = keep * uz + (steer + dt) * fz
        x = sphere[i, 0] - back * ux + dt * vx
        y = sphere[i, 1] - back * uy + dt * vy
        z = sphere[i, 2] - back * uz + dt * vz
        x, y, z, vx, vy, vz = kept_within(plain, sphere[i, 3], x, y, z, vx, vy, vz)
        if grid:
            x, y, z, vx, vy, vz = kept_on_grid(plain, walls, sphere[i, 3], x, y, z, vx, vy, vz)
        sphere[i, 0], sphere[i, 1], sphere[i, 2] = x, y, z
        velocity[i, 0], velocity[i, 1], velocity[i, 2] = vx, vy, vz
        dx, dy, dz = x - listed[i, 0], y - listed[i, 1], z - listed[i, 2]
        farthest = max(farthest, dx * dx + dy * dy + dz * dz)
    part[b, _FARTHEST] = farthest


@device
def _total(part, column):
    total = 0.0
    for b in range(len(part)):
        total += part[b, column]
    return total


@device
def _most(part, column):
    most = 0.0
    for b in range(len(part)):
        most = max(most, part[b, column])
    return most


@device
def _report(part, n, step, report):
    contacts = _total(part, _CONTACTS)
    report[RMS_FORCE] = math.sqrt(_total(part, _FORCE) / n)
    report[MEAN_OVERLAP] = _total(part, _OVERLAP) / max(contacts, 1.0)
    report[CONTACTS], report[LARGEST_OVERLAP], report[STEPS] = 0.5 * contacts, _most(part, _DEEPEST), step


@device
def _steered(fire, longest, part):
    """The next step: how far back, its length, and what of velocity and of force enters the new velocity."""
    if _total(part, _POWER) > 0.0:
        fire[_DOWNHILL] += 1.0
        if fire[_DOWNHILL] > PATIENCE:
            fire[_DT] = min(1.1 * fire[_DT], longest)
            fire[_MIXING] *= 0.99
        steer = fire[_MIXING] * math.sqrt(_total(part, _SPEED) / _total(part, _FORCE))
        return 0.0, fire[_DT], 1.0 - fire[_MIXING], steer
    back = 0.5 * fire[_DT]
    fire[_DT], fire[_MIXING], fire[_DOWNHILL] = max(0.5 * fire[_DT], 0.02), ALPHA, 0.0
    return back, fire[_DT], 0.0, 0.0


@kernel(parallel=True)
def relax(spheres, walls, near, fire, limits, report):
    """Minimise the overlap energy, as far as the neighbour list is valid.

    Args:
        spheres: `kernels.tables.Spheres`; centres are moved.
        walls: `kernels.tables.PackingWalls`.
        near: `kernels.tables.Near`.
        fire: time step, mixing and number of steps downhill, (3,), kept between calls.
        limits: `kernels.tables.RelaxLimits`.
        report: filled with its columns, (REPORTED,).

    Returns:
        CONVERGED, LOOSE, STALE (make a new list and call again) or EXHAUSTED.
    """
    n = len(spheres.sphere)
    blocks = _blocks(n)
    part = np.zeros((blocks, _SUMS))
    longest = _DT_MAX_GRID if has_grid(walls) else DT_MAX
    listed = near.listed
    for step in range(limits.steps + 1):
        for b in prange(blocks):
            _press(spheres, walls, near, b, part)
        _report(part, n, step, report)
        if report[RMS_FORCE] <= limits.tolerance * report[MEAN_OVERLAP]:
            return CONVERGED
        if report[MEAN_OVERLAP] < limits.loose:
            return LOOSE
        if step == limits.steps:
            return EXHAUSTED
        back, dt, keep, steer = _steered(fire, longest, part)
        for b in prange(blocks):
            _descend(spheres, walls, listed, back, dt, keep, steer, b, part)
        if _most(part, _FARTHEST) > near.slack * near.slack:
            return STALE
    return EXHAUSTED
