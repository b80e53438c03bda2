"""What elements do with the sums of the forces of their bonds: they move, and leave the sums at zero.

Both schemes are one update with three coefficients (bondem.solve.schemes):

    close the step:  v += finish · a
    open the next:   v += begin · a,    x += dt v + extra a

Elements are taken WIDTH at a time; those that own a row of the boundary stand in a list of their own and go one by
one, by the same function. What only some models have (`bondem.kernels.tables.Added`) is compiled in where there is
any.
"""

import numpy as np

from bondem._compile import device, kernel, loop, prange
from bondem.kernels.element_rows import gripped, loaded, prescribed, react, row_power, switched_energy
from bondem.kernels.lane_memory import clear_row, places_below, prefetch, put_entry, put_row, row
from bondem.kernels.lanes import WIDTH, all_below, dot, lane, put_lane
from bondem.kernels.resistance import (
    body_work,
    book_loss,
    damped,
    lost,
    resisted,
    viscous_power,
    with_body_forces,
    with_contacts,
    with_dashpots,
)
from bondem.laws.rotations import SMALL, half_angle, short_series, turned

# Elements ahead of the loop whose rows are asked for.
_AHEAD = 32


@device
def _moved(v, h, a):
    return v[0] + h * a[0], v[1] + h * a[1], v[2] + h * a[2]


@device
def _half_angles(h2):
    """cos(h) and sin(h)/h of many half angles, each as `half_angle` has it."""
    if all_below(h2, SMALL):  # a usual step
        return short_series(h2)
    cosine, sinc = h2, h2
    for n in range(WIDTH):
        one, other = half_angle(lane(h2, n))
        cosine, sinc = put_lane(cosine, n, one), put_lane(sinc, n, other)
    return cosine, sinc


@device
def _drifted(x, scheme, r, v, w, a, b):
    """A row of the pose a step later; r is None for many."""
    dt, extra = scheme.dt, scheme.extra
    p, q, s = dt * w[0] + extra * b[0], dt * w[1] + extra * b[1], dt * w[2] + extra * b[2]
    h2 = 0.25 * dot((p, q, s), (p, q, s))
    if r is None:
        cosine, sinc = _half_angles(h2)
    else:
        cosine, sinc = half_angle(h2)
    q0, q1, q2, q3 = turned(x[4], x[5], x[6], x[7], p, q, s, cosine, sinc)
    return (
        x[0] + (dt * v[0] + extra * a[0]), x[1] + (dt * v[1] + extra * a[1]), x[2] + (dt * v[2] + extra * a[2]),
        x[3], q0, q1, q2, q3,
    )  # fmt: skip


@device
def _driven(rows, velocity, r, m, u, v, w):
    """Put in the prescribed velocities of a row, and book the energy that brings."""
    rows.work[r] += switched_energy(rows.fixed, velocity, r, m, u, v, w)
    return prescribed(rows.fixed, velocity, r, v, w)


@device
def _row_work(rows, r, half, v, w):
    rows.work[r] += half * row_power(rows.fixed, rows.force, rows.reaction, r, v, w)


@device
def _step(elements, sums, rows, scheme, added, go_on, p, s, r):
    """One element, or many that own no row (r is None), close the step, and open the next if it is to go on."""
    dt, gamma = scheme.dt, scheme.gamma
    load, moving, x = row(sums, s), row(elements.motion, p), row(elements.pose, p)
    f, t = (load[0], load[1], load[2]), (load[4], load[5], load[6])
    v, m, w, u = (moving[0], moving[1], moving[2]), moving[3], (moving[4], moving[5], moving[6]), moving[7]
    clear_row(sums, s)
    f, t = with_contacts(elements.load, p, f, t)
    if added is not None:
        f, t = with_dashpots(added.dashed, s, f, t)
        f = with_body_forces(added.group, added.present, p, m, f)
        body_work(added.group, added.present, added.body, p, m, 0.5 * dt, v)
    if r is not None:
        f, t = gripped(rows.grip, r, f, t)
        react(rows.reaction, r, f, t)
        _row_work(rows, r, 0.5 * dt, v, w)
        f, t = loaded(rows.fixed, rows.force, r, f, t)
    whole_f, whole_t = f, t
    f, t = damped(f, t, v, w, gamma)
    a, b = (m * f[0], m * f[1], m * f[2]), (u * t[0], u * t[1], u * t[2])
    resisting = gamma > 0.0
    if added is not None:
        resisting = resisting or added.viscous
        kick = scheme.finish if scheme.finish > 0.0 else scheme.begin
        a, b = resisted(added.viscous, added.alpha, added.absorbing, rows.fixed, r, kick, m, v, w, a, b)
    # two kicks also where they could be one: the bits must not depend on where a run pauses
    v, w = _moved(v, scheme.finish, a), _moved(w, scheme.finish, b)
    if resisting:
        power = lost(f, t, whole_f, whole_t, v, w)
        if added is not None:
            power += viscous_power(added.alpha, added.dashed, added.absorbing, rows.fixed, s, r, m, u, v, w)
        book_loss(elements.loss, p, dt, power)
    if r is not None:
        v, w = _driven(rows, rows.full, r, m, u, v, w)
    if not go_on:
        for d in range(3):
            put_entry(elements.acceleration, p, d, a[d])
            put_entry(elements.acceleration, p, 3 + d, b[d])
        put_row(elements.motion, p, (v[0], v[1], v[2], m, w[0], w[1], w[2], u))
        return
    v, w = _moved(v, scheme.begin, a), _moved(w, scheme.begin, b)
    if r is not None:
        v, w = _driven(rows, rows.half, r, m, u, v, w)
        _row_work(rows, r, 0.5 * dt, v, w)
    if added is not None:
        body_work(added.group, added.present, added.body, p, m, 0.5 * dt, v)
    put_row(elements.pose, p, _drifted(x, scheme, r, v, w, a, b))
    put_row(elements.motion, p, (v[0], v[1], v[2], m, w[0], w[1], w[2], u))


@kernel(parallel=False)
def move(elements, sums, rows, scheme, added, go_on, element, row_of_sums, first, last):
    """The elements first … last of a list, which own no rows, close the step, and open the next if it is to go on."""
    end = np.uint64(last)
    for g in range((last - first + WIDTH - 1) // WIDTH):
        e = np.uint64(first) + np.uint64(WIDTH) * np.uint64(g)
        later = places_below(element, e + np.uint64(_AHEAD), end)
        prefetch(elements.pose, later)
        prefetch(elements.motion, later)
        p, s = places_below(element, e, end), places_below(row_of_sums, e, end)
        _step(elements, sums, rows, scheme, added, go_on, p, s, None)


@loop(parallel=False)
def move_held(elements, sums, rows, scheme, added, go_on, element, row_of_sums, first, last):
    """The same of elements that own rows."""
    for e in range(first, last):
        p = np.uint64(element[e])
        _step(elements, sums, rows, scheme, added, go_on, p, np.uint64(row_of_sums[e]), rows.of[p])


@device
def _open_one(elements, rows, scheme, added, p):
    """One element opens a step after a pause."""
    acceleration, dt = elements.acceleration, scheme.dt
    a = acceleration[p, 0], acceleration[p, 1], acceleration[p, 2]
    b = acceleration[p, 3], acceleration[p, 4], acceleration[p, 5]
    x, moving = row(elements.pose, p), row(elements.motion, p)
    v, m, w, u = (moving[0], moving[1], moving[2]), moving[3], (moving[4], moving[5], moving[6]), moving[7]
    r = rows.of[p]
    if r >= 0:
        rows.work[r] += switched_energy(rows.fixed, rows.half, r, m, u, v, w)
    v, w = _moved(v, scheme.begin, a), _moved(w, scheme.begin, b)
    if r >= 0:
        v, w = prescribed(rows.fixed, rows.half, r, v, w)
        _row_work(rows, r, 0.5 * dt, v, w)
    if added is not None:
        body_work(added.group, added.present, added.body, p, m, 0.5 * dt, v)
    put_row(elements.motion, p, (v[0], v[1], v[2], m, w[0], w[1], w[2], u))
    put_row(elements.pose, p, _drifted(x, scheme, r, v, w, a, b))


def _open(elements, rows, scheme, added):
    for p in prange(len(elements.pose)):
        _open_one(elements, rows, scheme, added, np.uint64(p))


@loop(parallel=False)
def open_list(elements, rows, scheme, added, element, count):
    """The first `count` elements of a list open a step, as after a pause."""
    for e in range(count):
        _open_one(elements, rows, scheme, added, np.uint64(element[e]))


open_step = loop(parallel=True)(_open)
open_step_serial = loop(parallel=False)(_open)


@loop(parallel=False)
def collect_parts(sums, row_of_sums, parts, part, first, last):
    """Add what bonds of other domains have left to the sums of shared elements, and leave zeros there."""
    for e in range(first, last):
        for q in range(parts + part[e], parts + part[e + 1]):
            for d in range(8):
                sums[row_of_sums[e], d] += sums[q, d]
                sums[q, d] = 0.0
