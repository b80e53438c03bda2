"""Dashpots of the bonds: as the springs, tile by tile, into sums of their own.

They act at the velocities in the middle of the last step, where the leapfrog has them; their loss is taken with that
at the time of the forces, from the sums, so that the energy ledger stays second order.
"""

import numpy as np

from bondem._compile import device, kernel
from bondem.kernels.bond_pass import add_forces, branch
from bondem.kernels.element_pass import collect
from bondem.laws.damping import dashpot_force


@device
def damp_bonds(
    added, pose, motion, i, j, integrity, period, row_i, row_j, first, last, fx, fy, fz, ax, ay, az, bx, by, bz
):  # fmt: skip
    """Add the dashpots of the bonds first … last to their sums, where there are any; overwrites the nine rows."""
    if added is not None and len(added.dashed) > 0:
        dashpot_forces(
            pose, motion, i, j, added.dashpot, added.share, integrity, period, first, last,
            fx, fy, fz, ax, ay, az, bx, by, bz,
        )  # fmt: skip
        add_forces(added.dashed, row_i, row_j, first, last, fx, fy, fz, ax, ay, az, bx, by, bz)


@device
def collect_dashpots(added, row, parts, part, first, last):
    """As `collect` does with the sums of the springs."""
    if added is not None and len(added.dashed) > 0:
        collect(added.dashed, row, parts, part, first, last)


@kernel(parallel=False, separate=True)
def dashpot_forces(
    pose, motion, i, j, value, share, integrity, period, first, last, fx, fy, fz, ax, ay, az, bx, by, bz
):  # fmt: skip
    """Force on j and torques on i and j of the dashpots of the bonds first … last, into nine rows."""
    begin = np.uint64(first)
    cn, cs, cb, ct = value[0], value[1], value[2], value[3]
    for n in range(last - first):
        k = np.uint64(n) + begin
        a = i[k]
        b = j[k]
        dx, dy, dz = branch(pose, a, b, period)
        s = integrity[k]
        fx[n], fy[n], fz[n], ax[n], ay[n], az[n], bx[n], by[n], bz[n] = dashpot_force(
            dx, dy, dz,
            motion[b, 0] - motion[a, 0], motion[b, 1] - motion[a, 1], motion[b, 2] - motion[a, 2],
            motion[a, 4], motion[a, 5], motion[a, 6], motion[b, 4], motion[b, 5], motion[b, 6],
            share[k], s * cn[k], s * cs[k], s * cb[k], s * ct[k],
        )  # fmt: skip
