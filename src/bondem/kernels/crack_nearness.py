"""How near a crack is to softening: the integrity that the softening curve leaves it, and whether it may rest."""

import math

import numpy as np

from bondem._compile import device, loop
from bondem.kernels.cell_pass import STRESS
from bondem.kernels.cell_stress import pair_stress
from bondem.kernels.cell_yield import principal_stresses
from bondem.kernels.crack_energy import bending_traction, opened_by
from bondem.kernels.crack_tables import ONSET, TOP
from bondem.kernels.single_facets import column, resistance
from bondem.laws.cell_energy import opened, scalar, turned_by
from bondem.laws.softening import LEAST_SLOPE, left_in_bulk, left_on_plane, opening_force, plus, softened, softens_at

# A resting crack wakes at these shares of the traction at which it softens, and of its force across it. Too early
# costs time only.
CALM, GRAZING = 0.98, 0.1


@device
def unsoftened_below(s, strength, last, plane, cohesion, friction, kink, steep):
    """Traction of a facet of integrity s below which it does not soften, whatever its direction [Pa]."""
    if s == 0.0:
        return math.inf
    if plane != 0:
        slips = cohesion / math.sqrt(1.0 + friction * friction)
        return min(strength, slips) if s == 1.0 or last > 0.0 else 0.0
    # a facet that is pulled and bent begins at 1/√2 of its strength, by the rms of its points
    return softens_at(s, 0.7 * LEAST_SLOPE * strength, last, kink, steep)


@device
def stays_at_rest(f, across, size, top):
    """Whether a resting crack is far from waking: whether it cannot soften, and is open.

    Args:
        f: its force as if it were whole [N].
        across: a vector along its normal, about.
        size: of the force, with what bending adds to it [N].
        top: force below which it does not soften [N].
    """
    along = scalar(f, across)
    return size < CALM * top and along > GRAZING * math.sqrt(scalar(f, f) * scalar(across, across))


@loop(parallel=False)
def integrity_at(cracks, c, k, s, t, n, bent, mean, a, v):
    """Integrity of crack c, of facet k, at most s, by the softening curve alone.

    Args:
        t: traction that it would have if it were whole [Pa].
        n: its normal.
        bent: T_b [Pa].
        mean: mean stress of its cells [Pa].
        a, v: (3, 3) to use.
    """
    strength, last, kink, steep = cracks.row[c, ONSET], cracks.last[k], cracks.kink, cracks.steep
    if last == 0.0 and s < 1.0:  # what breaks at once goes on
        return 0.0
    if strength == 0.0:  # a cell of it has no cohesion
        opening, _ = opening_force(t, n)
        return softened(s, math.sqrt(scalar(opening, opening) + bent * bent), 0.0, last, kink, steep)
    if cracks.plane[k] != 0:
        return left_on_plane(
            s, t, n, bent, strength, last, cracks.cohesion[k], cracks.last_slip[k], cracks.friction[k], kink, steep
        )
    bent = opened_by(bent, mean)
    principal_stresses(mean, a, v)
    return left_in_bulk(s, t, n, bent, a, v, strength, last, kink, steep)


@device
def wakes(pose, bonds, cells, cracks, c, place, a, v):
    """Whether the resting crack c is about to soften or close; `place` is its `frame`, a and v are (3, 3) to use."""
    k, top = np.int64(cracks.facet[c]), cracks.row[c, TOP]
    i, j, K, A = bonds.i[k], bonds.j[k], cells.k[k], cracks.area[k]
    d, p, q, arm_i, arm_j, one, other = place
    gap, one, other = opened(d, turned_by(p, arm_i), turned_by(q, arm_j)), turned_by(p, one), turned_by(q, other)
    f = plus(plus((K * gap[0], K * gap[1], K * gap[2]), pose[i, STRESS], one), pose[j, STRESS], other)
    across, bent = plus(one, 1.0, other), 0.0
    if top < math.inf:
        bent = bending_traction(p, q, cells.bends[k], resistance(cells, 1.0, k))
    if stays_at_rest(f, across, math.sqrt(scalar(f, f) + (A * bent) ** 2), top):
        return False
    if top == math.inf or not stays_at_rest(f, across, 0.0, top):
        return True
    s, near = cracks.integrity[k], 1.0 / CALM
    t, n = (near / A * f[0], near / A * f[1], near / A * f[2]), turned_by(p, column(cells.normal, k))
    return integrity_at(cracks, c, k, s, t, n, near * bent, pair_stress(cracks.tensor, i, j), a, v) < s
