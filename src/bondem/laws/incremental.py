"""The incremental formulation of the papers: rates integrated step by step, forces stored per bond.

    F' = Ω × F + kn (v·n) n + ks (v - (v·n) n)        M' = Ω × M + kt (ω·n) n + kb (ω - (ω·n) n)

with v the relative velocity at the contact point, ω the relative angular velocity and Ω the spin of the bond
(that of its axis, and about it the mean of the two elements). F acts on i at the contact point and -F on j;
tension positive. Plasticity and rate laws need it, and users compare with it.

The papers do not say at which instant of a step the rates are taken. Here it is the middle, where the velocities are,
and a stored force is turned by the Cayley transform of Ω dt, which keeps its length (Hughes and Winget 1980): a rigid
turn of any size leaves it as it was, to the second order of the step. What stays is that rotations do not commute: a
closed cycle of bending and twisting leaves a force of the second order in the angle, at any step; the total
formulation leaves none. References: Chen et al. (2022) eqs (1), (5) to (7), Tables 1, 2 and 8; Hughes and Winget
(1980), Int. J. Numer. Meth. Engng 15, 1862-1867.
"""

import math

from bondem._compile import device


@device
def axis(dx, dy, dz):
    """Return unit vector and length [m] of a branch vector."""
    l = math.sqrt(dx * dx + dy * dy + dz * dz)
    return dx / l, dy / l, dz / l, l


@device
def spin(nx, ny, nz, l, vx, vy, vz, sx, sy, sz):
    """Return the angular velocity Ω of a bond [rad/s] from the velocity of j against i and the sum of both spins."""
    along = 0.5 * (sx * nx + sy * ny + sz * nz)
    return (
        (ny * vz - nz * vy) / l + along * nx,
        (nz * vx - nx * vz) / l + along * ny,
        (nx * vy - ny * vx) / l + along * nz,
    )


@device
def levers(l, rest, lever):
    """Return distances of the contact point from both centres [m]; both halves share a gain in length."""
    near = lever + 0.5 * (l - rest)
    return near, l - near


@device
def turned_and_loaded(x, y, z, ox, oy, oz, rx, ry, rz, nx, ny, nz, along, across, dt):
    """Return a stored vector after a step: half of the rate r with its two stiffnesses, rotation, other half."""
    h = 0.5 * dt
    normal = (along - across) * (rx * nx + ry * ny + rz * nz)
    gx, gy, gz = h * (normal * nx + across * rx), h * (normal * ny + across * ry), h * (normal * nz + across * rz)
    x, y, z = x + gx, y + gy, z + gz
    tx, ty, tz = h * ox, h * oy, h * oz
    s = 2.0 / (1.0 + tx * tx + ty * ty + tz * tz)
    ux, uy, uz = x + ty * z - tz * y, y + tz * x - tx * z, z + tx * y - ty * x
    return (
        x + s * (ty * uz - tz * uy) + gx,
        y + s * (tz * ux - tx * uz) + gy,
        z + s * (tx * uy - ty * ux) + gz,
    )
