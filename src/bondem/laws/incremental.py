"""The incremental formulation of the papers: rates integrated step by step, forces stored per bond.

    F' = Ω × F + kn (v·n) n + ks (v - (v·n) n)        M' = Ω × M + kt (ω·n) n + kb (ω - (ω·n) n)

with v the relative velocity at the contact point, ω the relative angular velocity and Ω the spin of the bond
(that of its axis, and about it the mean of the two elements). F acts on i at the contact point and -F on j;
tension positive. Plasticity and rate laws need it, and users compare with it; unlike the total formulation
it is exact only for small rotations a step, and drifts. Reference: Chen et al. (2022) Tables 1, 2 and 8, eqs
(6), (7).
"""

import math

from bondem._compile import device


@device
def axis(dx, dy, dz):
    """Unit vector and length [m] of a branch vector."""
    l = math.sqrt(dx * dx + dy * dy + dz * dz)
    return dx / l, dy / l, dz / l, l


@device
def spin(nx, ny, nz, l, vx, vy, vz, sx, sy, sz):
    """Angular velocity Ω of a bond [rad/s] from the velocity of j against i and the sum of both spins."""
    along = 0.5 * (sx * nx + sy * ny + sz * nz)
    return (
        (ny * vz - nz * vy) / l + along * nx,
        (nz * vx - nx * vz) / l + along * ny,
        (nx * vy - ny * vx) / l + along * nz,
    )


@device
def turned_and_loaded(x, y, z, ox, oy, oz, rx, ry, rz, nx, ny, nz, along, across, dt):
    """A stored vector after a step: turned by Ω dt and raised by the rate r with the two stiffnesses."""
    normal = rx * nx + ry * ny + rz * nz
    return (
        x + dt * (oy * z - oz * y + (along - across) * normal * nx + across * rx),
        y + dt * (oz * x - ox * z + (along - across) * normal * ny + across * ry),
        z + dt * (ox * y - oy * x + (along - across) * normal * nz + across * rz),
    )
