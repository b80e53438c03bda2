"""What one crack bears and stores, from its geometry and the stresses of its cells.

What is called from several places is compiled once for all of them (`kernel`), and takes numbers: to hand on whole
tables costs more than all that is done here.
"""

import math

from bondem._compile import device, kernel, loop
from bondem.laws.cell_energy import bending_square, cross, relative, resisted_turn, scalar, turned_by
from bondem.laws.plasticity import largest_pressure
from bondem.laws.softening import opening_force, whole_force


@kernel(parallel=False)
def halves(k, part, gap, normal, shares, stresses):
    """F⁺ and pressing force of both halves of a crack.

    Args:
        k: stiffness of the facet [N/m].
        part: w, part of cell i in its compliance [-].
        gap: δ [m].
        normal: from i to j [-].
        shares: g of both sides [m²].
        stresses: σ of both cells [Pa].
    """
    one = whole_force(k, part, gap, shares[0], stresses[0])
    other = whole_force(k, 1.0 - part, gap, shares[1], stresses[1])
    return opening_force(one, normal), opening_force(other, normal)


@kernel(parallel=False)
def bending(p, q, H):
    """Energy [J] and torque on cell i [N·m] of the bending of a whole facet between cells of orientations p and q."""
    w, v, space = relative(p, q)
    turned = resisted_turn(H, v)
    h = turned_by(p, turned)
    c = cross(space, h)
    return 2.0 * scalar(v, turned), (2.0 * (w * h[0] + c[0]), 2.0 * (w * h[1] + c[1]), 2.0 * (w * h[2] + c[2]))


@device
def bending_traction(p, q, factor, H):
    """T_b of a facet [Pa]."""
    return math.sqrt(max(bending_square(p, q, factor, H), 0.0))


@device
def opened_at_most(bent, mean):
    """Bound of `opened_by` without an angle: σ3 is at most the least of the diagonal [Pa]."""
    return max(bent + min(mean[0], mean[1], mean[2], 0.0), 0.0)


@kernel(parallel=False)
def opened_by(bent, mean):
    """T_b of a facet less the largest pressure of the `mean` stress of its cells, at least 0 [Pa]."""
    if opened_at_most(bent, mean) == 0.0:
        return 0.0
    return max(bent - largest_pressure(mean), 0.0)


@device
def bending_opening(p, q, factor, H, mean):
    """What bending opens of a facet [Pa]."""
    return opened_by(bending_traction(p, q, factor, H), mean)


@device
def stretched(K, s, rub):
    """Energy over 1 - s of the spring of friction [J]."""
    return 0.0 if s >= 1.0 else 0.5 * scalar(rub, rub) / (K * (1.0 - s) ** 2)


@loop(parallel=False)
def crack_energy(k, part, s, gap, normal, openings, rub):
    """Elastic energy of a crack of integrity s across and along it, but for bending [J]; `openings` are F⁺."""
    across = along = 0.0
    for half in range(2):
        w, opening = (part, openings[0]) if half == 0 else (1.0 - part, openings[1])
        u = (1.0 - s) * w / k
        e = w * gap[0] - u * opening[0], w * gap[1] - u * opening[1], w * gap[2] - u * opening[2]
        normal_part = scalar(e, normal)
        across += 0.5 * k / w * normal_part * normal_part
        along += 0.5 * k / w * (scalar(e, e) - normal_part * normal_part)
        across += 0.5 * s * (1.0 - s) * w / k * scalar(opening, opening)
    return across, along + (1.0 - s) * stretched(k, s, rub)
