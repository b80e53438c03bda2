"""Hard spheres that fly, collide and grow: event-driven molecular dynamics.

Lubachevsky and Stillinger, J. Stat. Phys. 60 (1990); one event a sphere, as Lubachevsky, J. Comput. Phys. 94 (1991).
All radii grow in proportion at a constant rate. Between collisions a sphere flies straight; each knows its own next
event and stands in a heap by its time. One thread: events depend on each other, and their order makes the bits.
"""

import math

import numpy as np

from bondem._compile import device, kernel
from bondem.kernels.neighbour_grid import inverse_period, nearest_image

# What a call of `grow` ended with: all time used, a sphere about to outrun its neighbour list, too many events.
GROWN, STALE, EXHAUSTED = 0, 1, 2

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
def _sift(heap, place, when, k):
    """Restore the order of the heap after the time of the sphere at `k` has changed."""
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
def _foresee(
    i, now, sphere, unit, velocity, since, period, wall, start, neighbour, listed, slack, scale, rate, when
):  # fmt: skip
    """Next event of sphere i: its time and kind."""
    x, y, z = sphere[i, 0], sphere[i, 1], sphere[i, 2]
    vx, vy, vz = velocity[i, 0], velocity[i, 1], velocity[i, 2]
    r, grow = unit[i] * (scale + rate * now), unit[i] * rate
    dx, dy, dz = x - listed[i, 0], y - listed[i, 1], z - listed[i, 2]
    vv = vx * vx + vy * vy + vz * vz
    dv = dx * vx + dy * vy + dz * vz
    inside = max(slack * slack - dx * dx - dy * dy - dz * dz, 0.0)
    best = (math.sqrt(dv * dv + vv * inside) - dv) / max(vv, 1e-300)
    kind = _LEAVE
    for a in range(3):
        if grow - velocity[i, a] > 0.0:
            t = max(sphere[i, a] - wall[a] - r, 0.0) / (grow - velocity[i, a])
            if t < best:
                best, kind = t, _LOWER - a
        if grow + velocity[i, a] > 0.0:
            t = max(wall[3 + a] - sphere[i, a] - r, 0.0) / (grow + velocity[i, a])
            if t < best:
                best, kind = t, _UPPER - a
    if wall[9] < math.inf:
        room = wall[9] - r
        px, py, pz = wall[6] * x, wall[7] * y, wall[8] * z
        a = grow * grow - wall[6] * vx * vx - wall[7] * vy * vy - wall[8] * vz * vz
        b = -(px * vx + py * vy + pz * vz) - room * grow
        t = _meet(a, b, room * room - px * px - py * py - pz * pz)
        if t < best:
            best, kind = t, _ROUND
    qx, qy, qz = inverse_period(period[0]), inverse_period(period[1]), inverse_period(period[2])
    for k in range(start[i], start[i + 1]):
        j = np.int64(neighbour[k])
        late = now - since[j]
        dx = nearest_image(sphere[j, 0] + late * velocity[j, 0] - x, period[0], qx)
        dy = nearest_image(sphere[j, 1] + late * velocity[j, 1] - y, period[1], qy)
        dz = nearest_image(sphere[j, 2] + late * velocity[j, 2] - z, period[2], qz)
        ux, uy, uz = velocity[j, 0] - vx, velocity[j, 1] - vy, velocity[j, 2] - vz
        both, widen = r + unit[j] * (scale + rate * now), grow + unit[j] * rate
        a = ux * ux + uy * uy + uz * uz - widen * widen
        b = dx * ux + dy * uy + dz * uz - both * widen
        t = _meet(a, b, dx * dx + dy * dy + dz * dz - both * both)
        if t < best and now + t < when[j]:
            best, kind = t, j
    return now + best, kind


@device
def _fly(i, now, sphere, velocity, since):
    late = now - since[i]
    for a in range(3):
        sphere[i, a] += late * velocity[i, a]
    since[i] = now


@kernel(parallel=False)
def grow(
    sphere, unit, velocity, period, wall, start, neighbour, listed, slack, scale, rate, duration, events, report
):  # fmt: skip
    """Let the spheres fly and grow, as far as the neighbour list is valid.

    Args:
        sphere: centres and radii [m], shape (n, 4), without overlap; all are advanced to the end.
        unit: radii at scale 1 [m], (n,).
        velocity: in metres per unit of time, shape (n, 3).
        period: periodic edge lengths [m], (3,), 0 where there is none.
        wall: the walls, (10,), as in `kernels.packing`.
        start: where each sphere's neighbours begin, (n + 1,).
        neighbour: neighbour lists.
        listed: centres when the list was made [m], shape (n, 3).
        slack: how far a centre may fly before the list is stale [m].
        scale: of the radii at the beginning [-].
        rate: scale gained per unit of time.
        duration: how long to go on.
        events: most collisions.
        report: filled with the time gone by, sum of (distance times exchanged momentum) [m²], collisions; (3,).

    Returns:
        GROWN, STALE (make a new list and call again) or EXHAUSTED.
    """
    n = sphere.shape[0]
    since, when = np.zeros(n), np.zeros(n)
    what = np.full(n, _CHECK, np.int64)  # at time 0 every sphere looks ahead for the first time
    heap, place = np.arange(n), np.arange(n)
    todo = np.empty(2, np.int64)
    status, now, virial, collisions = GROWN, 0.0, 0.0, 0
    while True:
        i = heap[0]
        if when[i] > duration:
            now = duration
            break
        now = when[i]
        kind = what[i]
        if kind == _LEAVE:
            status = STALE
            break
        if collisions >= events:
            status = EXHAUSTED
            break
        _fly(i, now, sphere, velocity, since)
        todo[0], todo[1] = i, _NOTHING
        swell = unit[i] * rate
        if kind >= 0:
            j = kind
            _fly(j, now, sphere, velocity, since)
            todo[1] = j
            dx = nearest_image(sphere[j, 0] - sphere[i, 0], period[0], inverse_period(period[0]))
            dy = nearest_image(sphere[j, 1] - sphere[i, 1], period[1], inverse_period(period[1]))
            dz = nearest_image(sphere[j, 2] - sphere[i, 2], period[2], inverse_period(period[2]))
            d = math.sqrt(dx * dx + dy * dy + dz * dz)
            dx, dy, dz = dx / d, dy / d, dz / d
            apart = dx * (velocity[j, 0] - velocity[i, 0]) + dy * (velocity[j, 1] - velocity[i, 1])
            apart += dz * (velocity[j, 2] - velocity[i, 2])
            push = swell + unit[j] * rate - apart  # elastic for surfaces that move with the growth
            velocity[i, 0] -= push * dx
            velocity[i, 1] -= push * dy
            velocity[i, 2] -= push * dz
            velocity[j, 0] += push * dx
            velocity[j, 1] += push * dy
            velocity[j, 2] += push * dz
            virial += push * d
            collisions += 1
            when[j], what[j] = np.inf, _NOTHING
            _sift(heap, place, when, place[j])
        elif kind == _ROUND:
            px, py, pz = wall[6] * sphere[i, 0], wall[7] * sphere[i, 1], wall[8] * sphere[i, 2]
            d = math.sqrt(px * px + py * py + pz * pz)
            out = 2.0 * ((px * velocity[i, 0] + py * velocity[i, 1] + pz * velocity[i, 2]) / d + swell)
            velocity[i, 0] -= out * px / d
            velocity[i, 1] -= out * py / d
            velocity[i, 2] -= out * pz / d
            collisions += 1
        elif kind <= _UPPER:
            velocity[i, _UPPER - kind] = -velocity[i, _UPPER - kind] - 2.0 * swell
            collisions += 1
        elif kind <= _LOWER:
            velocity[i, _LOWER - kind] = -velocity[i, _LOWER - kind] + 2.0 * swell
            collisions += 1
        when[i], what[i] = np.inf, _NOTHING
        _sift(heap, place, when, place[i])
        for q in range(2):
            p = todo[q]
            if p < 0:
                continue
            time, kind = _foresee(
                p, now, sphere, unit, velocity, since, period, wall, start, neighbour, listed, slack, scale, rate,
                when,
            )  # fmt: skip
            other = what[p]
            if other >= 0:  # chosen a moment ago by the one before
                if time >= when[p]:
                    continue
                what[other] = _CHECK
            when[p], what[p] = time, kind
            if kind >= 0:
                jilted = what[kind]
                if jilted >= 0:
                    what[jilted] = _CHECK
                when[kind], what[kind] = time, p
                _sift(heap, place, when, place[kind])
            _sift(heap, place, when, place[p])
    for i in range(n):
        _fly(i, now, sphere, velocity, since)
        sphere[i, 3] = unit[i] * (scale + rate * now)
    report[0], report[1], report[2] = now, virial, collisions
    return status
