"""Bonds of a block: their forces and torques, and the sums of these for each element.

Constants and outputs are structures of arrays, so that the first loop vectorises; positions are gathered from rows
of 8. The outputs stay in the cache until the second loop has added them up, in the order of the bonds.
"""

import numpy as np

from bondem._compile import device, kernel
from bondem.laws.beam_energy import bond_cosines, bond_energy, bond_force


@device
def branch(pose, a, b, period):
    """Centre b minus centre a over the nearest periodic image [m]; the inverse period of a free specimen is 0."""
    dx = pose[b, 0] - pose[a, 0]
    dy = pose[b, 1] - pose[a, 1]
    dz = pose[b, 2] - pose[a, 2]
    return (
        dx - period[0] * np.rint(dx * period[3]),
        dy - period[1] * np.rint(dy * period[4]),
        dz - period[2] * np.rint(dz * period[5]),
    )


@kernel(parallel=False, separate=True)
def bond_forces(
    pose, i, j, constants, same, integrity, period, first, last, fx, fy, fz, ax, ay, az, bx, by, bz
):  # fmt: skip
    """Force on j and torques on i and j of the bonds first … last, into the beginning of nine rows.

    Where all bonds are alike but for their length, `same` is kn L, A L = C L, B L and kt L, and a bond reads four
    numbers instead of nine; else it is None.
    """
    # unsigned, or every index would be tested for counting from the end
    begin = np.uint64(first)
    X0, Y0, Z0, rest = constants[0], constants[1], constants[2], constants[3]
    kn, A, B, C, kt = constants[4], constants[5], constants[6], constants[7], constants[8]
    knL, AL, BL, ktL = (0.0, 0.0, 0.0, 0.0) if same is None else same  # decided when compiled
    px, py, pz = period[0], period[1], period[2]
    ix, iy, iz = period[3], period[4], period[5]
    for n in range(last - first):
        k = np.uint64(n) + begin
        a = i[k]
        b = j[k]
        dx = pose[b, 0] - pose[a, 0]
        dy = pose[b, 1] - pose[a, 1]
        dz = pose[b, 2] - pose[a, 2]
        # nearest image; the inverse period of a free specimen is 0
        dx -= px * np.rint(dx * ix)
        dy -= py * np.rint(dy * iy)
        dz -= pz * np.rint(dz * iz)
        s = integrity[k]
        l = rest[k]
        if same is None:
            k0, k1, k2, k3, k4 = s * kn[k], s * A[k], s * B[k], s * C[k], s * kt[k]
        else:
            inverse = s / l
            k0, k1, k2, k3, k4 = knL * inverse, AL * inverse, BL * inverse, AL * inverse, ktL * inverse
        fx[n], fy[n], fz[n], ax[n], ay[n], az[n], bx[n], by[n], bz[n] = bond_force(
            dx, dy, dz,
            pose[a, 4], pose[a, 5], pose[a, 6], pose[a, 7],
            pose[b, 4], pose[b, 5], pose[b, 6], pose[b, 7],
            X0[k], Y0[k], Z0[k], l, k0, k1, k2, k3, k4,
        )  # fmt: skip


@kernel(parallel=False, separate=True)
def add_forces(sums, row_i, row_j, first, last, fx, fy, fz, ax, ay, az, bx, by, bz):
    """Add the nine rows to the sums of both ends, bond by bond: force (3) and torque (3) in rows of eight."""
    begin = np.uint64(first)
    for n in range(last - first):
        k = np.uint64(n) + begin
        b = row_j[k]
        sums[b, 0] += fx[n]
        sums[b, 1] += fy[n]
        sums[b, 2] += fz[n]
        sums[b, 3] += bx[n]
        sums[b, 4] += by[n]
        sums[b, 5] += bz[n]
        a = row_i[k]
        sums[a, 0] -= fx[n]
        sums[a, 1] -= fy[n]
        sums[a, 2] -= fz[n]
        sums[a, 3] += ax[n]
        sums[a, 4] += ay[n]
        sums[a, 5] += az[n]


@kernel(parallel=False)
def bond_energies(pose, i, j, constants, shear, lever, integrity, period):
    """Normal, shear, bending and twisting energy of all bonds [J]."""
    # without threads: it runs once a record, often on a few bonds, where launching them costs far more
    normal = slip = bend = twist = 0.0
    for k in range(len(i)):
        a = i[k]
        b = j[k]
        dx, dy, dz = branch(pose, a, b, period)
        part = bond_energy(
            dx, dy, dz,
            pose[a, 4], pose[a, 5], pose[a, 6], pose[a, 7],
            pose[b, 4], pose[b, 5], pose[b, 6], pose[b, 7],
            constants[0, k], constants[1, k], constants[2, k], constants[3, k], constants[4, k],
            constants[5, k], constants[6, k], constants[7, k], constants[8, k], shear[k], lever[k],
        )  # fmt: skip
        s = integrity[k]
        normal += s * part[0]
        slip += s * part[1]
        bend += s * part[2]
        twist += s * part[3]
    return normal, slip, bend, twist


@kernel(parallel=False)
def rotation_guard(pose, i, j, constants, integrity, period):
    """How many unbroken bonds are turned beyond the valid range, and beyond its end.

    Returns:
        (count with c1 or c2 < 0.7 or w² < 0.75, count with c1 or c2 <= 0 or w² <= 0.25, whether a number
        was not finite).
    """
    wide = 0
    lost = 0
    sick = False
    for k in range(len(i)):
        a = i[k]
        b = j[k]
        dx, dy, dz = branch(pose, a, b, period)
        c1, c2, w2 = bond_cosines(
            dx, dy, dz,
            pose[a, 4], pose[a, 5], pose[a, 6], pose[a, 7],
            pose[b, 4], pose[b, 5], pose[b, 6], pose[b, 7],
            constants[0, k], constants[1, k], constants[2, k],
        )  # fmt: skip
        c = min(c1, c2)
        sick |= not (c * c + w2 < 4.0)
        if integrity[k] > 0.0:
            wide += (c < 0.7) | (w2 < 0.75)
            lost += (c <= 0.0) | (w2 <= 0.25)
    return wide, lost, sick
