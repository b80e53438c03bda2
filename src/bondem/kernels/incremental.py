"""Phase one of a step in the incremental formulation; same outputs as the total one."""

from bondem._compile import device, kernel
from bondem.kernels.bond_pass import branch
from bondem.laws.incremental import axis, levers, spin, turned_and_loaded


@kernel(parallel=False, separate=True)
def incremental_forces(
    pose, motion, i, j, constants, shear, bending, lever, integrity, history, period, dt,
    first, last, fx, fy, fz, ax, ay, az, bx, by, bz,
):  # fmt: skip
    """Go on by dt with the stored force and moment (6, m) of the bonds first … last; rows as of the total one."""
    for n in range(last - first):
        k = first + n
        a = i[k]
        b = j[k]
        dx, dy, dz = branch(pose, a, b, period)
        vx, vy, vz = motion[b, 0] - motion[a, 0], motion[b, 1] - motion[a, 1], motion[b, 2] - motion[a, 2]
        # half a step ago, which is when the velocities are: a rigid turn then neither stretches nor shears
        nx, ny, nz, l = axis(dx - 0.5 * dt * vx, dy - 0.5 * dt * vy, dz - 0.5 * dt * vz)
        near, far = levers(l, constants[3, k], lever[k])
        px, py, pz = motion[a, 4], motion[a, 5], motion[a, 6]
        qx, qy, qz = motion[b, 4], motion[b, 5], motion[b, 6]
        ox, oy, oz = spin(nx, ny, nz, l, vx, vy, vz, px + qx, py + qy, pz + qz)
        # velocity of j against i at the contact point
        sx, sy, sz = near * px + far * qx, near * py + far * qy, near * pz + far * qz
        vx -= sy * nz - sz * ny
        vy -= sz * nx - sx * nz
        vz -= sx * ny - sy * nx
        f0, f1, f2 = turned_and_loaded(
            history[0, k], history[1, k], history[2, k], ox, oy, oz, vx, vy, vz, nx, ny, nz,
            constants[4, k], shear[k], dt,
        )  # fmt: skip
        m0, m1, m2 = turned_and_loaded(
            history[3, k], history[4, k], history[5, k], ox, oy, oz, qx - px, qy - py, qz - pz, nx, ny, nz,
            constants[8, k], bending[k], dt,
        )  # fmt: skip
        history[0, k], history[1, k], history[2, k] = f0, f1, f2
        history[3, k], history[4, k], history[5, k] = m0, m1, m2
        s = integrity[k]
        nx, ny, nz, l = axis(dx, dy, dz)
        near, far = levers(l, constants[3, k], lever[k])
        c0, c1, c2 = ny * f2 - nz * f1, nz * f0 - nx * f2, nx * f1 - ny * f0
        fx[n], fy[n], fz[n] = -s * f0, -s * f1, -s * f2
        ax[n], ay[n], az[n] = s * (near * c0 + m0), s * (near * c1 + m1), s * (near * c2 + m2)
        bx[n], by[n], bz[n] = s * (far * c0 - m0), s * (far * c1 - m1), s * (far * c2 - m2)


@kernel(parallel=False)
def incremental_energies(pose, i, j, constants, shear, bending, integrity, history, period):
    """Normal, shear, bending and twisting energy of all bonds [J] from their stored forces and moments."""
    normal = slip = bend = twist = 0.0
    for k in range(len(i)):
        dx, dy, dz = branch(pose, i[k], j[k], period)
        nx, ny, nz, _ = axis(dx, dy, dz)
        s = integrity[k]
        along, across = _stored(history, 0, k, nx, ny, nz, constants[4, k], shear[k])
        normal += s * along
        slip += s * across
        along, across = _stored(history, 3, k, nx, ny, nz, constants[8, k], bending[k])
        twist += s * along
        bend += s * across
    return normal, slip, bend, twist


@device
def _stored(history, row, k, nx, ny, nz, stiff, soft):
    """Energy of a stored vector along a bond, of stiffness `stiff`, and across it."""
    x, y, z = history[row, k], history[row + 1, k], history[row + 2, k]
    along = x * nx + y * ny + z * nz
    rest = max(x * x + y * y + z * z - along * along, 0.0)
    return 0.5 * along * along / stiff if stiff > 0.0 else 0.0, 0.5 * rest / soft if soft > 0.0 else 0.0
