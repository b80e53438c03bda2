"""Facets that lose their integrity: tension by facets, with a fracture energy, friction where a crack has closed.

A facet of integrity s is each of its halves p in series with a spring s / (1 - s) k_p, whose opening u_p is
eliminated (k_p = 2 G A / d_p = k / w_p). With F_p = k δ + σ_p g_p / w_p, the force of that half as if it were whole,
g_p = R_p (A w M⁻¹n)_p and F⁺ = F less its part along the normal n where that presses,

    u_p = (1 - s) w_p F⁺_p / k,      V_p θ_p = Σ g_p·δ - (1 - s) g_p·F⁺_p / k
    f = Σ_p w_p [s F_p + (1 - s) min(F_p·n, 0) n] + q
    -∂U/∂s = Σ_p w_p |F⁺_p|² / 2 k + bending - friction spring ≥ 0

so that a closed crack bears pressure with Lamé's λ, as whole material does. q = (1 - s) k (δ_t - slip) is friction on
what is broken, cut at μ times the pressure on it; an open crack forgets it (Alfano and Sacco 2006).

Bending opens one edge of a facet more than the other. T_b = √(2 k U_b) / A is the rms of the tractions by which its
points differ, U_b the energy of bending of the whole facet, and what of it opens the facet is

    b = max(T_b - p, 0),     p = max(-σ3, 0) of the mean stress of both cells.

A facet begins where its traction, with b along n added, reaches the criterion; it softens by the rms of its points,

    T² = |F⁺|² / A² + b²,

so that U_b counts in T as it does in -∂U/∂s.

Softening is linear in the opening u = (1 - s) A T / k: from the traction t₀ that a facet has when it begins, to the
opening 2 G_f / f_t, the same for facets of all directions. Then each dissipates G_f per area projected on the crack.
Or it follows two lines with a kink at κ t₀: s T is the larger of both, each of the form a - b (1 - s) T.
"""

import math

from bondem._compile import device
from bondem.laws.cell_energy import cross, scalar


@device
def plus(a, s, b):
    """a + s b."""
    return a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]


@device
def whole_force(k, part, gap, share, stress):
    """F of a half as if it were whole [N]: k δ + σ g / w, with `part` w its part of the compliance."""
    return plus((k * gap[0], k * gap[1], k * gap[2]), stress / part, share)


@device
def opening_force(force, normal):
    """F⁺: what of F opens or shears a crack; and how much of it presses on the crack, at most 0 [N]."""
    along = min(scalar(force, normal), 0.0)
    return plus(force, -along, normal), along


@device
def softened(s, traction, onset, last, kink, steep):
    """Integrity of a facet under a traction T [Pa], at most s.

    Args:
        onset: t₀ [Pa].
        last: k u / A at the opening where nothing is left [Pa]; above `onset`, or 0 where it breaks at once.
        kink: κ, 0 for a straight line.
        steep: where the first line would reach nothing, over `last`; 1 for a straight line.
    """
    if traction <= onset:
        return s
    if traction >= last:
        return 0.0
    first = steep * last
    left = onset * (1.0 - traction / first) / (traction * (1.0 - onset / first))
    if kink > 0.0:
        slope = kink * onset / (last - (1.0 - kink) * first)
        left = max(left, slope * (last - traction) / (traction * (1.0 - slope)))
    return min(s, left)


@device
def rubbed(k, s, gap, normal, slip, limit):
    """Friction q on the broken part of a facet [N], and the slip that belongs to it [m].

    Args:
        slip: so far [m], in space.
        limit: μ times the pressure on that part [N].
    """
    across = plus(gap, -scalar(gap, normal), normal)
    stretch = plus(across, -1.0, plus(slip, -scalar(slip, normal), normal))
    stiff = (1.0 - s) * k
    size = stiff * math.sqrt(scalar(stretch, stretch))
    if size > limit:
        kept = limit / size
        return (
            (stiff * kept * stretch[0], stiff * kept * stretch[1], stiff * kept * stretch[2]),
            plus(across, -kept, stretch),
        )  # fmt: skip
    return (stiff * stretch[0], stiff * stretch[1], stiff * stretch[2]), plus(across, -1.0, stretch)


@device
def crack_couple(gap, force, one, other):
    """Torque of the turning normal on both cells together [N·m].

    δ × f less the couples of both halves: what is left for angular momentum to be conserved.
    """
    c = cross(gap, force)
    return c[0] - one[0] - other[0], c[1] - one[1] - other[1], c[2] - one[2] - other[2]
