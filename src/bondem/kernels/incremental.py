"""Phase one of a step in the incremental formulation; same outputs as the total one."""

from bondem._compile import kernel, prange
from bondem.kernels.bond_pass import branch
from bondem.laws.incremental import axis, spin, turned_and_loaded


@kernel(parallel=True)
def incremental_forces(pose, motion, i, j, constants, shear, bending, lever, integrity, history, period, dt, output):
    """Go on by dt with the stored force and moment of each bond (6, m), and write forces and torques (9, m)."""
    for k in prange(len(i)):
        a = i[k]
        b = j[k]
        dx, dy, dz = branch(pose, a, b, period)
        nx, ny, nz, l = axis(dx, dy, dz)
        near = lever[k]
        far = constants[3, k] - near
        vx, vy, vz = motion[b, 0] - motion[a, 0], motion[b, 1] - motion[a, 1], motion[b, 2] - motion[a, 2]
        px, py, pz = motion[a, 4], motion[a, 5], motion[a, 6]
        qx, qy, qz = motion[b, 4], motion[b, 5], motion[b, 6]
        ox, oy, oz = spin(nx, ny, nz, l, vx, vy, vz, px + qx, py + qy, pz + qz)
        # velocity of j against i at the contact point
        sx, sy, sz = near * px + far * qx, near * py + far * qy, near * pz + far * qz
        vx -= sy * nz - sz * ny
        vy -= sz * nx - sx * nz
        vz -= sx * ny - sy * nx
        fx, fy, fz = turned_and_loaded(
            history[0, k], history[1, k], history[2, k], ox, oy, oz, vx, vy, vz, nx, ny, nz,
            constants[4, k], shear[k], dt,
        )  # fmt: skip
        mx, my, mz = turned_and_loaded(
            history[3, k], history[4, k], history[5, k], ox, oy, oz, qx - px, qy - py, qz - pz, nx, ny, nz,
            constants[8, k], bending[k], dt,
        )  # fmt: skip
        history[0, k], history[1, k], history[2, k] = fx, fy, fz
        history[3, k], history[4, k], history[5, k] = mx, my, mz
        s = integrity[k]
        cx, cy, cz = ny * fz - nz * fy, nz * fx - nx * fz, nx * fy - ny * fx
        output[0, k], output[1, k], output[2, k] = -s * fx, -s * fy, -s * fz
        output[3, k], output[4, k], output[5, k] = s * (near * cx + mx), s * (near * cy + my), s * (near * cz + mz)
        output[6, k], output[7, k], output[8, k] = s * (far * cx - mx), s * (far * cy - my), s * (far * cz - mz)


@kernel(parallel=False)
def incremental_energies(pose, i, j, constants, shear, bending, integrity, history, period, output):
    """Normal, shear, bending and twisting energy of every bond [J] from its stored force and moment."""
    for k in range(len(i)):
        a = i[k]
        b = j[k]
        dx, dy, dz = branch(pose, a, b, period)
        nx, ny, nz, _ = axis(dx, dy, dz)
        for part in range(2):
            x, y, z = history[3 * part, k], history[3 * part + 1, k], history[3 * part + 2, k]
            along = x * nx + y * ny + z * nz
            rest = max(x * x + y * y + z * z - along * along, 0.0)
            stiff = constants[4, k] if part == 0 else constants[8, k]
            soft = shear[k] if part == 0 else bending[k]
            first = 0.5 * along * along / stiff if stiff > 0.0 else 0.0
            second = 0.5 * rest / soft if soft > 0.0 else 0.0
            s = integrity[k]
            # rows: normal, shear, bending, twisting
            output[3 * part, k] = s * first
            output[1 + part, k] = s * second
