"""Dashpots of the bonds: as the springs, into sums of their own.

They act at the velocities in the middle of the last step, where the leapfrog has them; their loss is taken with that
at the time of the forces, from the sums, so that the energy ledger stays second order.
"""

import numpy as np

from bondem._compile import device, loop
from bondem.kernels.bond_pass import apart, group, groups
from bondem.kernels.element_pass import collect_parts
from bondem.kernels.lane_memory import add_loads, places, row, side
from bondem.laws.damping import dashpot_force


@device
def damp_bonds(added, elements, bonds, row_i, row_j, first, last):
    """Add the dashpots of the bonds first … last to their sums, where there are any."""
    if added is not None:
        if len(added.dashed) > 0:
            dashpot_loads(elements.pose, elements.motion, bonds, added, row_i, row_j, first, last)


@device
def collect_dashpots(added, cut, first, last):
    """As `collect_parts` does with the sums of the springs."""
    if added is not None:
        if len(added.dashed) > 0:
            collect_parts(added.dashed, cut.shared_row, cut.parts, cut.part, first, last)


@loop(parallel=False)
def dashpot_loads(pose, motion, bonds, added, row_i, row_j, first, last):
    """Add force and torques of the dashpots of the bonds first … last to the rows of their two ends."""
    m = np.uint64(added.dashpot.shape[1])
    for g in range(groups(first, last)):
        k, known = group(first, last, g)
        i, j = places(bonds.i, k), places(bonds.j, k)
        dx, dy, dz = apart(row(pose, i), row(pose, j), bonds.period)
        a, b = row(motion, i), row(motion, j)
        s = side(bonds.integrity, k)
        fx, fy, fz, ax, ay, az, bx, by, bz = dashpot_force(
            dx, dy, dz, b[0] - a[0], b[1] - a[1], b[2] - a[2], a[4], a[5], a[6], b[4], b[5], b[6],
            side(added.share, k), s * side(added.dashpot, k), s * side(added.dashpot, m + k),
            s * side(added.dashpot, np.uint64(2) * m + k), s * side(added.dashpot, np.uint64(3) * m + k),
        )  # fmt: skip
        add_loads(
            added.dashed, places(row_i, k), places(row_j, k), (fx, fy, fz), (ax, ay, az), (bx, by, bz), known
        )
