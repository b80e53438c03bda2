"""What one crack bears and stores, once it is measured and the stresses of its cells are known.

What is called from several places is compiled once for all of them (`kernel`).
"""

import numpy as np

from bondem._compile import device, kernel
from bondem.kernels.cell_pass import STRESS
from bondem.kernels.crack_list import read_three
from bondem.kernels.crack_tables import FACET, GAP, NORMAL, RUB, SHARE_I, SHARE_J
from bondem.kernels.single_facets import orientation, resistance
from bondem.laws.cell_energy import cross, relative, resisted_turn, scalar, turned_by
from bondem.laws.softening import opening_force, whole_force


@kernel(parallel=False)
def halves(pose, bonds, cells, cracks, c):
    """Facet of a crack, its gap and normal, and F⁺ and pressing force of both halves."""
    k = np.int64(cracks.row[c, FACET])
    g, w = cracks.geometry[c], cracks.part[k]
    gap, normal = read_three(g, GAP), read_three(g, NORMAL)
    one = whole_force(cells.k[k], w, gap, read_three(g, SHARE_I), pose[bonds.i[k], STRESS])
    other = whole_force(cells.k[k], 1.0 - w, gap, read_three(g, SHARE_J), pose[bonds.j[k], STRESS])
    return k, gap, normal, opening_force(one, normal), opening_force(other, normal)


@kernel(parallel=False)
def bending(pose, bonds, cells, k):
    """Energy [J] and torque on cell i [N·m] of the bending of a whole facet."""
    p, q = orientation(pose, bonds.i[k]), orientation(pose, bonds.j[k])
    w, v, space = relative(p, q)
    turned = resisted_turn(resistance(cells, 1.0, k), v)
    h = turned_by(p, turned)
    c = cross(space, h)
    return 2.0 * scalar(v, turned), (2.0 * (w * h[0] + c[0]), 2.0 * (w * h[1] + c[1]), 2.0 * (w * h[2] + c[2]))


@device
def stretched(K, s, rub):
    """Energy over 1 - s of the spring of friction [J]."""
    return 0.0 if s >= 1.0 else 0.5 * scalar(rub, rub) / (K * (1.0 - s) ** 2)


@kernel(parallel=False)
def crack_energy(pose, bonds, cells, cracks, c):
    """Elastic energy of a crack: across, along and of bending [J]."""
    k, gap, normal, (one, _), (other, _) = halves(pose, bonds, cells, cracks, c)
    w, s, K = cracks.part[k], cracks.integrity[k], cells.k[k]
    across = along = 0.0
    for half in range(2):
        part, opening = (w, one) if half == 0 else (1.0 - w, other)
        u = (1.0 - s) * part / K
        e = part * gap[0] - u * opening[0], part * gap[1] - u * opening[1], part * gap[2] - u * opening[2]
        normal_part = scalar(e, normal)
        across += 0.5 * K / part * normal_part * normal_part
        along += 0.5 * K / part * (scalar(e, e) - normal_part * normal_part)
        across += 0.5 * s * (1.0 - s) * part / K * scalar(opening, opening)
    bent, _ = bending(pose, bonds, cells, k)
    along += (1.0 - s) * stretched(K, s, read_three(cracks.row[c], RUB))
    return across, along, s * bent
