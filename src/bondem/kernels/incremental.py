"""The bonds of a step in the incremental formulation: the same sums as of the total one, and what they store."""

import numpy as np

from bondem._compile import device, kernel, loop
from bondem.kernels.bond_pass import ahead, apart, branch, group, groups
from bondem.kernels.lane_memory import add_loads, places, put_side, row, side
from bondem.laws.incremental import axis, levers, spin, turned_and_loaded


@device
def stored(history, first, k):
    """Three rows of what bonds k … store, from row `first` on."""
    m = np.uint64(history.shape[1])
    f = np.uint64(first)
    return (
        side(history, f * m + k), side(history, (f + np.uint64(1)) * m + k), side(history, (f + np.uint64(2)) * m + k)
    )


@device
def store(history, first, k, values, known):
    """Write them, but for the first `known` bonds."""
    m = np.uint64(history.shape[1])
    for d in range(3):
        put_side(history, np.uint64(first + d) * m + k, values[d], known)


@kernel(parallel=False)
def incremental_loads(elements, bonds, history, dt, sums, row_i, row_j, first, last):
    """Go on by dt with the stored force and moment of the bonds first … last, and add what they do to `sums`."""
    pose, motion = elements.pose, elements.motion
    for g in range(groups(first, last)):
        k, known = group(first, last, g)
        ahead(bonds, pose, k, last)
        i, j = places(bonds.i, k), places(bonds.j, k)
        dx, dy, dz = apart(row(pose, i), row(pose, j), bonds.period)
        a, b = row(motion, i), row(motion, j)
        vx, vy, vz = b[0] - a[0], b[1] - a[1], b[2] - a[2]
        rest, lever = side(bonds.length, k), side(bonds.lever, k)
        # half a step ago, which is when the velocities are: a rigid turn then neither stretches nor shears
        nx, ny, nz, l = axis(dx - 0.5 * dt * vx, dy - 0.5 * dt * vy, dz - 0.5 * dt * vz)
        near, far = levers(l, rest, lever)
        px, py, pz = a[4], a[5], a[6]
        qx, qy, qz = b[4], b[5], b[6]
        ox, oy, oz = spin(nx, ny, nz, l, vx, vy, vz, px + qx, py + qy, pz + qz)
        # velocity of j against i at the contact point
        sx, sy, sz = near * px + far * qx, near * py + far * qy, near * pz + far * qz
        vx -= sy * nz - sz * ny
        vy -= sz * nx - sx * nz
        vz -= sx * ny - sy * nx
        f0, f1, f2 = stored(history, 0, k)
        f0, f1, f2 = turned_and_loaded(
            f0, f1, f2, ox, oy, oz, vx, vy, vz, nx, ny, nz, side(bonds.kn, k), side(bonds.ks, k), dt
        )
        m0, m1, m2 = stored(history, 3, k)
        m0, m1, m2 = turned_and_loaded(
            m0, m1, m2, ox, oy, oz, qx - px, qy - py, qz - pz, nx, ny, nz, side(bonds.kt, k), side(bonds.kb, k), dt
        )
        store(history, 0, k, (f0, f1, f2), known)
        store(history, 3, k, (m0, m1, m2), known)
        s = side(bonds.integrity, k)
        nx, ny, nz, l = axis(dx, dy, dz)
        near, far = levers(l, rest, lever)
        c0, c1, c2 = ny * f2 - nz * f1, nz * f0 - nx * f2, nx * f1 - ny * f0
        add_loads(
            sums, places(row_i, k), places(row_j, k),
            (-s * f0, -s * f1, -s * f2),
            (s * (near * c0 + m0), s * (near * c1 + m1), s * (near * c2 + m2)),
            (s * (far * c0 - m0), s * (far * c1 - m1), s * (far * c2 - m2)),
            known,
        )  # fmt: skip


@loop(parallel=False)
def incremental_energies(pose, bonds, history):
    """Normal, shear, bending and twisting energy of all bonds [J] from their stored forces and moments."""
    normal = slip = bend = twist = 0.0
    for k in range(bonds.m):
        dx, dy, dz = branch(pose, bonds.i[k], bonds.j[k], bonds.period)
        nx, ny, nz, _ = axis(dx, dy, dz)
        s = bonds.integrity[k]
        along, across = _energies(history, 0, k, nx, ny, nz, bonds.kn[k], bonds.ks[k])
        normal += s * along
        slip += s * across
        along, across = _energies(history, 3, k, nx, ny, nz, bonds.kt[k], bonds.kb[k])
        twist += s * along
        bend += s * across
    return normal, slip, bend, twist


@device
def _energies(history, first, k, nx, ny, nz, stiff, soft):
    """Energy of a stored vector along a bond, of stiffness `stiff`, and across it."""
    x, y, z = history[first, k], history[first + 1, k], history[first + 2, k]
    along = x * nx + y * ny + z * nz
    rest = max(x * x + y * y + z * z - along * along, 0.0)
    return 0.5 * along * along / stiff if stiff > 0.0 else 0.0, 0.5 * rest / soft if soft > 0.0 else 0.0
