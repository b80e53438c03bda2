"""Phase one of a step: every bond writes its force and torques, and nobody else's.

Constants and outputs are structures of arrays, so that the loop vectorises; positions are gathered from
rows of 8. Because a bond writes only its own column, the result does not depend on the thread count.
"""

import numpy as np

from bondem._compile import device, kernel, prange
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


def _forces(pose, i, j, constants, integrity, period, output, first, last):
    # unsigned, or every index would be tested for counting from the end
    begin = np.uint64(first)
    X0, Y0, Z0, rest = constants[0], constants[1], constants[2], constants[3]
    kn, A, B, C, kt = constants[4], constants[5], constants[6], constants[7], constants[8]
    fx, fy, fz = output[0], output[1], output[2]
    ax, ay, az = output[3], output[4], output[5]
    bx, by, bz = output[6], output[7], output[8]
    px, py, pz = period[0], period[1], period[2]
    ix, iy, iz = period[3], period[4], period[5]
    for n in prange(last - first):
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
        f0, f1, f2, a0, a1, a2, b0, b1, b2 = bond_force(
            dx, dy, dz,
            pose[a, 4], pose[a, 5], pose[a, 6], pose[a, 7],
            pose[b, 4], pose[b, 5], pose[b, 6], pose[b, 7],
            X0[k], Y0[k], Z0[k], rest[k], kn[k], A[k], B[k], C[k], kt[k],
        )  # fmt: skip
        fx[k] = s * f0
        fy[k] = s * f1
        fz[k] = s * f2
        ax[k] = s * a0
        ay[k] = s * a1
        az[k] = s * a2
        bx[k] = s * b0
        by[k] = s * b1
        bz[k] = s * b2


bond_forces = kernel(parallel=True)(_forces)
bond_forces_serial = kernel(parallel=False)(_forces)


@kernel(parallel=False)
def bond_energies(pose, i, j, constants, shear, lever, integrity, period, output):
    """Normal, shear, bending and twisting energy of every bond [J] into rows 0 … 3 of `output` (≥ 4, m)."""
    # without threads: it runs once a record, often on a few bonds, where launching them costs far more
    for k in range(len(i)):
        a = i[k]
        b = j[k]
        dx, dy, dz = branch(pose, a, b, period)
        normal, slip, bend, twist = bond_energy(
            dx, dy, dz,
            pose[a, 4], pose[a, 5], pose[a, 6], pose[a, 7],
            pose[b, 4], pose[b, 5], pose[b, 6], pose[b, 7],
            constants[0, k], constants[1, k], constants[2, k], constants[3, k], constants[4, k],
            constants[5, k], constants[6, k], constants[7, k], constants[8, k], shear[k], lever[k],
        )  # fmt: skip
        s = integrity[k]
        output[0, k] = s * normal
        output[1, k] = s * slip
        output[2, k] = s * bend
        output[3, k] = s * twist


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
