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

# Functions take the arrays that they use, and those that may have nothing to do return early: whole tables that are
# handed on are counted, and what is assigned in a branch is kept in memory, for every element.


@device
def with_contacts(contact, p, f, t):
    """Force and torque with those of contacts, if there can be any."""
    if contact.ndim == 1:  # decided when compiled
        return f, t
    return (
        (f[0] + entry(contact, p, 0), f[1] + entry(contact, p, 1), f[2] + entry(contact, p, 2)),
        (t[0] + entry(contact, p, 3), t[1] + entry(contact, p, 4), t[2] + entry(contact, p, 5)),
    )


@device
def with_dashpots(dashed, s, f, t):
    """Force and torque with those of the dashpots of bonds, if there are any."""
    if len(dashed) == 0:
        return f, t
    d = row(dashed, s)
    return (f[0] + d[0], f[1] + d[1], f[2] + d[2]), (t[0] + d[4], t[1] + d[5], t[2] + d[6])


@device
def with_body_forces(group, present, p, m, f):
    """Force with body forces, if there are any."""
    if len(group) == 0:
        return f
    q = places_in(group, p)
    return f[0] + entry(present, q, 0) / m, f[1] + entry(present, q, 1) / m, f[2] + entry(present, q, 2) / m


@device
def body_work(group, present, work, p, m, half, v):
    """Add the work of the body forces over half a step [J]."""
    if len(group) > 0:
        q = places_in(group, p)
        power = dot((entry(present, q, 0), entry(present, q, 1), entry(present, q, 2)), v)
        put_entry(work, p, 0, entry(work, p, 0) + half * power / m)


@device
def damped(f, t, v, w, gamma):
    """Force and torque, each component reduced against the motion."""
    if gamma == 0.0:
        return f, t
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
def resisted(viscous, alpha, absorbing, fixed, r, h, m, v, w, a, b):
    """Accelerations slowed by mass damping and absorbing dashpots at the velocity a kick of h later.

    Taken at that velocity, which is the one at the time of the forces, they are second order and never unstable.
    """
    if not viscous:
        return a, b
    if r is not None:
        v, w = free(fixed, r, v, w)
    s = 1.0 + h * alpha
    a = a[0] - alpha * v[0], a[1] - alpha * v[1], a[2] - alpha * v[2]
    b = (b[0] - alpha * w[0]) / s, (b[1] - alpha * w[1]) / s, (b[2] - alpha * w[2]) / s
    if r is not None:
        if len(absorbing) > 0:
            return _absorbed(absorbing, r, h, s, m, v, a), b
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
def viscous_power(alpha, dashed, absorbing, fixed, s, r, m, u, v, w):
    """Power taken by mass damping and dashpots [W]; row s of those of bonds is left at zero."""
    power = zero_of(v[0])
    if len(dashed) > 0:
        c = row(dashed, s)
        along = dot((c[0], c[1], c[2]), v)
        power -= fused(c[6], w[2], fused(c[5], w[1], fused(c[4], w[0], along)))
        clear_row(dashed, s)
    if r is not None:
        v, w = free(fixed, r, v, w)
    power += alpha * (dot(v, v) / m + dot(w, w) / u)
    if r is not None:
        if len(absorbing) > 0:
            c = absorbing[r]
            power += c[0] * v[0] * v[0] + c[1] * v[1] * v[1] + c[2] * v[2] * v[2]
            power += 2.0 * (c[3] * v[0] * v[1] + c[4] * v[0] * v[2] + c[5] * v[1] * v[2])
    return power


@device
def book_loss(loss, p, dt, power):
    """Add the loss of the last step by the trapezoidal rule, which keeps the ledger second order."""
    put_entry(loss, p, DAMPED, entry(loss, p, DAMPED) + 0.5 * dt * (entry(loss, p, POWER) + power))
    put_entry(loss, p, POWER, power)
