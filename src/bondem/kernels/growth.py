"""Hard spheres that fly, collide and grow: event-driven molecular dynamics.

Lubachevsky and Stillinger, J. Stat. Phys. 60 (1990); one event a sphere, as Lubachevsky, J. Comput. Phys. 94 (1991).
All radii grow in proportion at a constant rate. Between collisions a sphere flies straight; each knows its own next
event and stands in a heap by its time. One thread: events depend on each other, and their order makes the bits.
"""

import math

import numpy as np

from bondem._compile import device, kernel
from bondem.kernels.neighbour_grid import inverse_period, nearest_image
from bondem.kernels.packing_tables import Flight

# What a call ended with: all time used, a sphere about to outrun its neighbour list, too many events.
GROWN, STALE, EXHAUSTED = 0, 1, 2

# Columns of its report: time gone by, sum of (distance times exchanged momentum) [m²], collisions.
TIME, VIRIAL, COLLISIONS, REPORTED = range(4)

# What the next event of a sphere is, where it is not the number of the other sphere.
_NOTHING, _LEAVE, _CHECK, _ROUND = -1, -2, -3, -4
_LOWER, _UPPER = -10, -20  # less the axis


@device
def _meet(a, b, c):
    """First time from now at which a t² + 2 b t + c, which is positive now, falls to 0; infinite without one."""
    if b < 0.0:
        if c <= 0.0:
            return 0.0
        inside = b * b - a * c
        return c / (math.sqrt(inside) - b) if inside >= 0.0 else math.inf
    if a < 0.0:
        return (b + math.sqrt(b * b - a * max(c, 0.0))) / -a
    return math.inf


@device
def _sift(flight, k):
    """Restore the order of the heap after the time of the sphere at `k` has changed."""
    heap, place, when = flight.heap, flight.place, flight.when
    i = heap[k]
    while k > 0 and when[i] < when[heap[(k - 1) // 2]]:
        heap[k] = heap[(k - 1) // 2]
        place[heap[k]] = k
        k = (k - 1) // 2
    while 2 * k + 1 < heap.size:
        child = 2 * k + 1
        if child + 1 < heap.size and when[heap[child + 1]] < when[heap[child]]:
            child += 1
        if when[heap[child]] >= when[i]:
            break
        heap[k] = heap[child]
        place[heap[k]] = k
        k = child
    heap[k] = i
    place[i] = k


@device
def _set(flight, i, time, kind):
    flight.when[i], flight.what[i] = time, kind
    _sift(flight, flight.place[i])


@device
def _at_walls(walls, x, v, r, grow, best, kind):
    """The first of an event known so far and the walls that a sphere reaches."""
    for a in range(3):
        if grow - v[a] > 0.0:
            t = max(x[a] - walls.lower[a] - r, 0.0) / (grow - v[a])
            if t < best:
                best, kind = t, _LOWER - a
        if grow + v[a] > 0.0:
            t = max(walls.upper[a] - x[a] - r, 0.0) / (grow + v[a])
            if t < best:
                best, kind = t, _UPPER - a
    if walls.radius < math.inf:
        weight, room = walls.weight, walls.radius - r
        px, py, pz = weight[0] * x[0], weight[1] * x[1], weight[2] * x[2]
        a = grow * grow - weight[0] * v[0] * v[0] - weight[1] * v[1] * v[1] - weight[2] * v[2] * v[2]
        b = -(px * v[0] + py * v[1] + pz * v[2]) - room * grow
        t = _meet(a, b, room * room - px * px - py * py - pz * pz)
        if t < best:
            best, kind = t, _ROUND
    return best, kind


@device
def _foresee(i, now, spheres, walls, near, growing, flight):
    """Next event of sphere i: its time and kind."""
    sphere, unit, velocity, period = spheres.sphere, spheres.unit, spheres.velocity, spheres.period
    x, y, z = sphere[i, 0], sphere[i, 1], sphere[i, 2]
    vx, vy, vz = velocity[i, 0], velocity[i, 1], velocity[i, 2]
    scale = growing.scale + growing.rate * now
    r, grow = unit[i] * scale, unit[i] * growing.rate
    dx, dy, dz = x - near.listed[i, 0], y - near.listed[i, 1], z - near.listed[i, 2]
    vv = vx * vx + vy * vy + vz * vz
    dv = dx * vx + dy * vy + dz * vz
    inside = max(near.slack * near.slack - dx * dx - dy * dy - dz * dz, 0.0)
    best = (math.sqrt(dv * dv + vv * inside) - dv) / max(vv, 1e-300)
    best, kind = _at_walls(walls, sphere[i], velocity[i], r, grow, best, _LEAVE)
    qx, qy, qz = inverse_period(period[0]), inverse_period(period[1]), inverse_period(period[2])
    for k in range(near.start[i], near.start[i + 1]):
        j = np.int64(near.neighbour[k])
        late = now - flight.since[j]
        dx = nearest_image(sphere[j, 0] + late * velocity[j, 0] - x, period[0], qx)
        dy = nearest_image(sphere[j, 1] + late * velocity[j, 1] - y, period[1], qy)
        dz = nearest_image(sphere[j, 2] + late * velocity[j, 2] - z, period[2], qz)
        ux, uy, uz = velocity[j, 0] - vx, velocity[j, 1] - vy, velocity[j, 2] - vz
        both, widen = r + unit[j] * scale, grow + unit[j] * growing.rate
        a = ux * ux + uy * uy + uz * uz - widen * widen
        b = dx * ux + dy * uy + dz * uz - both * widen
        t = _meet(a, b, dx * dx + dy * dy + dz * dz - both * both)
        if t < best and now + t < flight.when[j]:
            best, kind = t, j
    return now + best, kind


@device
def _fly(spheres, flight, i, now):
    late = now - flight.since[i]
    for a in range(3):
        spheres.sphere[i, a] += late * spheres.velocity[i, a]
    flight.since[i] = now


@device
def _collide(spheres, i, j, swell):
    """Two spheres part, elastic for surfaces that move with the growth; distance times exchanged momentum [m²]."""
    sphere, velocity, period = spheres.sphere, spheres.velocity, spheres.period
    dx = nearest_image(sphere[j, 0] - sphere[i, 0], period[0], inverse_period(period[0]))
    dy = nearest_image(sphere[j, 1] - sphere[i, 1], period[1], inverse_period(period[1]))
    dz = nearest_image(sphere[j, 2] - sphere[i, 2], period[2], inverse_period(period[2]))
    d = math.sqrt(dx * dx + dy * dy + dz * dz)
    dx, dy, dz = dx / d, dy / d, dz / d
    apart = dx * (velocity[j, 0] - velocity[i, 0]) + dy * (velocity[j, 1] - velocity[i, 1])
    apart += dz * (velocity[j, 2] - velocity[i, 2])
    push = swell - apart
    velocity[i, 0] -= push * dx
    velocity[i, 1] -= push * dy
    velocity[i, 2] -= push * dz
    velocity[j, 0] += push * dx
    velocity[j, 1] += push * dy
    velocity[j, 2] += push * dz
    return push * d


@device
def _bounce(spheres, walls, i, kind, swell):
    """A sphere turns back at a wall; whether it was one."""
    x, v, weight = spheres.sphere[i], spheres.velocity[i], walls.weight
    if kind == _ROUND:
        px, py, pz = weight[0] * x[0], weight[1] * x[1], weight[2] * x[2]
        d = math.sqrt(px * px + py * py + pz * pz)
        out = 2.0 * ((px * v[0] + py * v[1] + pz * v[2]) / d + swell)
        v[0] -= out * px / d
        v[1] -= out * py / d
        v[2] -= out * pz / d
    elif kind <= _UPPER:
        v[_UPPER - kind] = -v[_UPPER - kind] - 2.0 * swell
    elif kind <= _LOWER:
        v[_LOWER - kind] = -v[_LOWER - kind] + 2.0 * swell
    else:
        return False
    return True


@device
def _look_ahead(p, now, spheres, walls, near, growing, flight):
    """Sphere p chooses its next event; who was to meet it or its new partner must look again."""
    time, kind = _foresee(p, now, spheres, walls, near, growing, flight)
    when, what = flight.when, flight.what
    other = what[p]
    if other >= 0:  # chosen a moment ago by the one before
        if time >= when[p]:
            return
        what[other] = _CHECK
    when[p], what[p] = time, kind
    if kind >= 0:
        jilted = what[kind]
        if jilted >= 0:
            what[jilted] = _CHECK
        _set(flight, kind, time, p)
    _sift(flight, flight.place[p])


@kernel(parallel=False)
def fly_and_grow(spheres, walls, near, growing, report):
    """Let the spheres fly and grow, as far as the neighbour list is valid.

    Args:
        spheres: `kernels.packing_tables.Spheres`, without overlap; all are advanced to the end.
        walls: `kernels.packing_tables.PackingWalls` without a grid.
        near: `kernels.packing_tables.Near`.
        growing: `kernels.packing_tables.Growing`.
        report: filled with its columns, (REPORTED,).

    Returns:
        GROWN, STALE (make a new list and call again) or EXHAUSTED.
    """
    unit, rate = spheres.unit, growing.rate
    n = len(unit)
    # at time 0 every sphere looks ahead for the first time
    flight = Flight(np.zeros(n), np.zeros(n), np.full(n, _CHECK, np.int64), np.arange(n), np.arange(n))
    status, now, virial, collisions = GROWN, 0.0, 0.0, 0
    while True:
        i = flight.heap[0]
        if flight.when[i] > growing.duration:
            now = growing.duration
            break
        now = flight.when[i]
        kind = flight.what[i]
        if kind == _LEAVE:
            status = STALE
            break
        if collisions >= growing.events:
            status = EXHAUSTED
            break
        _fly(spheres, flight, i, now)
        swell = unit[i] * rate
        if kind >= 0:
            _fly(spheres, flight, kind, now)
            virial += _collide(spheres, i, kind, swell + unit[kind] * rate)
            collisions += 1
            _set(flight, kind, np.inf, _NOTHING)
        elif _bounce(spheres, walls, i, kind, swell):
            collisions += 1
        _set(flight, i, np.inf, _NOTHING)
        _look_ahead(i, now, spheres, walls, near, growing, flight)
        if kind >= 0:
            _look_ahead(kind, now, spheres, walls, near, growing, flight)
    for i in range(n):
        _fly(spheres, flight, i, now)
        spheres.sphere[i, 3] = unit[i] * (growing.scale + rate * now)
    report[TIME], report[VIRIAL], report[COLLISIONS] = now, virial, collisions
    return status
