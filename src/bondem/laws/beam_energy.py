"""Bond energy common to all laws, its gradient and its parts.

All bonds are made in one reference configuration, where every orientation is the identity. X0 is the reference
direction i→j, and X1 and X2 are X0 rotated with elements i and j. X is the present direction and ℓ the present
length; c1 = X·X1, c2 = X·X2, w = q_i·q_j, a the lever of the contact point from i, b = L - a, k' = kb - kt. Then

    U = ½ kn (ℓ - L)² + ½ A (1 - c1²) + B (X1·X2 - c1 c2) + ½ C (1 - c2²) + 2 kt (1 - w²)
    A = ks a² + k'      B = ks a b - k'      C = ks b² + k'

Its second derivative at rest is the 12×12 matrix of the bond law, and it is invariant under rigid motion. Forces that
are its exact gradient conserve momentum and angular momentum to rounding. It is periodic: the shear moment peaks at
45°, and X = -X0 is a false zero. Relative rotations must therefore stay moderate (`c1`, `c2` above 0.7, w² above
0.75). Tension is positive. The V-model of Kuzkin and Asonov (2012) is a relative.
"""

import math

from bondem._compile import device
from bondem.laws.rotations import rotate


@device
def bond_force(dx, dy, dz, wi, xi, yi, zi, wj, xj, yj, zj, X0, Y0, Z0, L, kn, A, B, C, kt):
    """Return force on j and torques on i and j [N, N·m] of one bond; the force on i is the opposite.

    Args:
        dx, dy, dz: centre j minus centre i [m].
        wi, xi, yi, zi: orientation of i; wj … of j.
        X0, Y0, Z0: reference direction; L: rest length [m].
        kn, A, B, C, kt: constants of the energy [N/m, N·m].
    """
    l = math.sqrt(dx * dx + dy * dy + dz * dz)
    inverse = 1.0 / l
    ex, ey, ez = dx * inverse, dy * inverse, dz * inverse
    px, py, pz = rotate(wi, xi, yi, zi, X0, Y0, Z0)
    qx, qy, qz = rotate(wj, xj, yj, zj, X0, Y0, Z0)
    c1 = ex * px + ey * py + ez * pz
    c2 = ex * qx + ey * qy + ez * qz
    g1 = A * c1 + B * c2
    g2 = B * c1 + C * c2
    axial = -kn * (l - L) - (g1 * c1 + g2 * c2) * inverse
    s1, s2 = g1 * inverse, g2 * inverse
    fx = axial * ex + s1 * px + s2 * qx
    fy = axial * ey + s1 * py + s2 * qy
    fz = axial * ez + s1 * pz + s2 * qz
    # relative rotation r = q_j q_i*
    w = wi * wj + xi * xj + yi * yj + zi * zj
    twist = 2.0 * kt * w
    vx = twist * (wi * xj - wj * xi + yi * zj - zi * yj) - B * (py * qz - pz * qy)
    vy = twist * (wi * yj - wj * yi + zi * xj - xi * zj) - B * (pz * qx - px * qz)
    vz = twist * (wi * zj - wj * zi + xi * yj - yi * xj) - B * (px * qy - py * qx)
    ax = g1 * (py * ez - pz * ey) + vx
    ay = g1 * (pz * ex - px * ez) + vy
    az = g1 * (px * ey - py * ex) + vz
    bx = g2 * (qy * ez - qz * ey) - vx
    by = g2 * (qz * ex - qx * ez) - vy
    bz = g2 * (qx * ey - qy * ex) - vz
    return fx, fy, fz, ax, ay, az, bx, by, bz


@device
def bond_energy(dx, dy, dz, wi, xi, yi, zi, wj, xj, yj, zj, X0, Y0, Z0, L, kn, A, B, C, kt, ks, a):
    """Return normal, shear, bending and twisting energy of one bond [J]; their sum is U.

    Sines are computed from cross products, so that small deformations keep their digits.
    """
    l = math.sqrt(dx * dx + dy * dy + dz * dz)
    ex, ey, ez = dx / l, dy / l, dz / l
    px, py, pz = rotate(wi, xi, yi, zi, X0, Y0, Z0)
    qx, qy, qz = rotate(wj, xj, yj, zj, X0, Y0, Z0)
    mx, my, mz = py * ez - pz * ey, pz * ex - px * ez, px * ey - py * ex
    nx, ny, nz = qy * ez - qz * ey, qz * ex - qx * ez, qx * ey - qy * ex
    s11 = mx * mx + my * my + mz * mz
    s12 = mx * nx + my * ny + mz * nz
    s22 = nx * nx + ny * ny + nz * nz
    b = L - a
    normal = 0.5 * kn * (l - L) ** 2
    shear = 0.5 * ks * (a * a * s11 + 2.0 * a * b * s12 + b * b * s22)
    vx = wi * xj - wj * xi + yi * zj - zi * yj
    vy = wi * yj - wj * yi + zi * xj - xi * zj
    vz = wi * zj - wj * zi + xi * yj - yi * xj
    tx, ty, tz = px + qx, py + qy, pz + qz
    along = (vx * tx + vy * ty + vz * tz) ** 2 / (tx * tx + ty * ty + tz * tz)
    twisting = 2.0 * kt * along
    k = A - ks * a * a
    bending = 0.5 * k * (s11 - 2.0 * s12 + s22) + 2.0 * kt * (vx * vx + vy * vy + vz * vz - along)
    return normal, shear, bending, twisting


@device
def bond_cosines(dx, dy, dz, wi, xi, yi, zi, wj, xj, yj, zj, X0, Y0, Z0):
    """Return c1, c2 and w² of one bond, which measure its distance from the false zeros."""
    inverse = 1.0 / math.sqrt(dx * dx + dy * dy + dz * dz)
    px, py, pz = rotate(wi, xi, yi, zi, X0, Y0, Z0)
    qx, qy, qz = rotate(wj, xj, yj, zj, X0, Y0, Z0)
    c1 = (dx * px + dy * py + dz * pz) * inverse
    c2 = (dx * qx + dy * qy + dz * qz) * inverse
    w = wi * wj + xi * xj + yi * yj + zi * zj
    return c1, c2, w * w
