"""What only some runs have on their elements: further forces, and what resists their motion.

All of it works on one element and on many (`bondem.kernels.lanes`): p is where the element is, s its row of sums, r
its row of the boundary, or None for elements that own none; m and u are 1/mass and 1/I.
"""

from bondem._compile import device
from bondem.kernels.element_rows import free
from bondem.kernels.lane_memory import clear_row, entry, places_in, put_entry, row
from bondem.kernels.lanes import dot, fused, sign, zero_of
from bondem.kernels.tables import DAMPED, POWER
from bondem.laws.damping import local_damping


@device
def with_added(added, p, s, m, f, t):
    """Force and torque with those of contacts, body forces and dashpots of bonds."""
    if len(added.contact) > 0:
        c = added.contact
        f = f[0] + entry(c, p, 0), f[1] + entry(c, p, 1), f[2] + entry(c, p, 2)
        t = t[0] + entry(c, p, 3), t[1] + entry(c, p, 4), t[2] + entry(c, p, 5)
    if len(added.dashed) > 0:
        d = row(added.dashed, s)
        f = f[0] + d[0], f[1] + d[1], f[2] + d[2]
        t = t[0] + d[4], t[1] + d[5], t[2] + d[6]
    if len(added.group) > 0:
        q = places_in(added.group, p)
        f = (
            f[0] + entry(added.present, q, 0) / m, f[1] + entry(added.present, q, 1) / m,
            f[2] + entry(added.present, q, 2) / m,
        )  # fmt: skip
    return f, t


@device
def body_work(added, p, m, half, v):
    """Add the work of the body forces over half a step [J]."""
    if len(added.group) > 0:
        q = places_in(added.group, p)
        power = dot((entry(added.present, q, 0), entry(added.present, q, 1), entry(added.present, q, 2)), v)
        put_entry(added.body, p, 0, entry(added.body, p, 0) + half * power / m)


@device
def damped(f, t, v, w, gamma):
    """Force and torque, each component reduced against the motion."""
    return (
        (
            local_damping(f[0], sign(v[0]), gamma), local_damping(f[1], sign(v[1]), gamma),
            local_damping(f[2], sign(v[2]), gamma),
        ),
        (
            local_damping(t[0], sign(w[0]), gamma), local_damping(t[1], sign(w[1]), gamma),
            local_damping(t[2], sign(w[2]), gamma),
        ),
    )  # fmt: skip


@device
def resisted(added, fixed, r, h, m, v, w, a, b):
    """Accelerations slowed by mass damping and absorbing dashpots at the velocity a kick of h later.

    Taken at that velocity, which is the one at the time of the forces, they are second order and never unstable.
    """
    if r is not None:
        v, w = free(fixed, r, v, w)
    alpha = added.alpha
    s = 1.0 + h * alpha
    a = a[0] - alpha * v[0], a[1] - alpha * v[1], a[2] - alpha * v[2]
    b = (b[0] - alpha * w[0]) / s, (b[1] - alpha * w[1]) / s, (b[2] - alpha * w[2]) / s
    if r is not None:
        if len(added.absorbing) > 0:
            return _absorbed(added.absorbing, r, h, s, m, v, a), b
    return (a[0] / s, a[1] / s, a[2] / s), b


@device
def _absorbed(absorbing, r, h, s, m, v, a):
    xx, yy, zz = m * absorbing[r, 0], m * absorbing[r, 1], m * absorbing[r, 2]
    xy, xz, yz = m * absorbing[r, 3], m * absorbing[r, 4], m * absorbing[r, 5]
    ax = a[0] - (xx * v[0] + xy * v[1] + xz * v[2])
    ay = a[1] - (xy * v[0] + yy * v[1] + yz * v[2])
    az = a[2] - (xz * v[0] + yz * v[1] + zz * v[2])
    xx, yy, zz = s + h * xx, s + h * yy, s + h * zz
    xy, xz, yz = h * xy, h * xz, h * yz
    # the symmetric 3 × 3 system by its cofactors
    c0, c1, c2 = yy * zz - yz * yz, xz * yz - xy * zz, xy * yz - xz * yy
    c3, c4, c5 = xx * zz - xz * xz, xy * xz - xx * yz, xx * yy - xy * xy
    whole = xx * c0 + xy * c1 + xz * c2
    return (
        (c0 * ax + c1 * ay + c2 * az) / whole,
        (c1 * ax + c3 * ay + c4 * az) / whole,
        (c2 * ax + c4 * ay + c5 * az) / whole,
    )


@device
def lost(f, t, before_f, before_t, v, w):
    """Power taken by local damping [W]: what it takes of force and torque, at the velocity between the two kicks."""
    power = dot((before_f[0] - f[0], before_f[1] - f[1], before_f[2] - f[2]), v)
    power = fused(before_t[0] - t[0], w[0], power)
    power = fused(before_t[1] - t[1], w[1], power)
    return fused(before_t[2] - t[2], w[2], power)


@device
def viscous_power(added, fixed, s, r, m, u, v, w):
    """Power taken by mass damping and dashpots [W]; row s of those of bonds is left at zero."""
    power = zero_of(v[0])
    if len(added.dashed) > 0:
        c = row(added.dashed, s)
        along = dot((c[0], c[1], c[2]), v)
        power -= fused(c[6], w[2], fused(c[5], w[1], fused(c[4], w[0], along)))
        clear_row(added.dashed, s)
    if r is not None:
        v, w = free(fixed, r, v, w)
    power += added.alpha * (dot(v, v) / m + dot(w, w) / u)
    if r is not None:
        if len(added.absorbing) > 0:
            c = added.absorbing[r]
            power += c[0] * v[0] * v[0] + c[1] * v[1] * v[1] + c[2] * v[2] * v[2]
            power += 2.0 * (c[3] * v[0] * v[1] + c[4] * v[0] * v[2] + c[5] * v[1] * v[2])
    return power


@device
def book_loss(loss, p, dt, power):
    """Add the loss of the last step by the trapezoidal rule, which keeps the ledger second order."""
    put_entry(loss, p, DAMPED, entry(loss, p, DAMPED) + 0.5 * dt * (entry(loss, p, POWER) + power))
    put_entry(loss, p, POWER, power)
