"""Facets that lose their integrity: tension by facets, with a fracture energy, friction where a crack has closed.

A facet of integrity s is each of its halves p in series with a spring s / (1 - s) k_p, whose opening u_p is
eliminated (k_p = 2 G A / d_p = k / w_p). With F_p = k δ + σ_p g_p / w_p, the force of that half as if it were whole,
g_p = R_p (A w M⁻¹n)_p and F⁺ = F less its part along the normal n where that presses,

    u_p = (1 - s) w_p F⁺_p / k,      V_p θ_p = Σ g_p·δ - (1 - s) g_p·F⁺_p / k
    f = Σ_p w_p [s F_p + (1 - s) min(F_p·n, 0) n] + q
    -∂U/∂s = Σ_p w_p |F⁺_p|² / 2 k + bending - friction spring ≥ 0

so that a closed crack carries pressure with Lamé's λ, as whole material does. q = (1 - s) k (δ_t - slip) is friction
on what is broken, cut at μ times the pressure on it; an open crack forgets it (Alfano and Sacco 2006).

Bending opens one edge of a facet more than the other. T_b = √(2 k U_b) / A is the rms of the tractions by which its
points differ, U_b the energy of bending of the whole facet, and what of it opens the facet is

    b = max(T_b - p, 0),     p = max(-σ3, 0) of the mean stress of both cells.

A facet of the material is put on the list of cracks where its traction, with b along n added, reaches the criterion.
From then on its integrity is a function of its present loads. Of the path only the least integrity so far is stored.
With t = F / A the traction that it would have if it were whole, and e_1, e_2, e_3 the present principal directions of
the mean stress of its cells, the facet is judged along each of them:

    T_a² = p_a² + b_a²,     b_a = b |n·e_a| / max_d |n·e_d|
    strength r f_t c_a,     c_a = max(|n·e_a|, 0.2),     r = T_a / (p_a + b_a)

with p_a = |t·e_a| where σ_a is a tension, and else what of t·e_a opens the facet, ⟨t·e_a sign(n·e_a)⟩. A facet
that is pulled and bent begins to soften at p_a + b_a = f_t c_a, as points at its edge do, and softens by the rms
of its points, whose energy T² is. Where t = σ n, T_a = σ_a |n·e_a|: every facet begins to soften at σ_1 = f_t,
whatever its direction. The integrity falls to the least that the softening curve gives for any direction, with
the last opening 2 G_f / f_t (of a straight line; over r) the same for all: s T_a falls from r f_t c_a to 0 as the
opening u = (1 - s) A T_a / k grows. A facet across which a crack opens along e_a dissipates G_f A c_a, which is
G_f per area projected on the crack. A load in another direction finds the strength that belongs to that
direction. (A facet that overhangs, t·e_a n·e_a < 0, softens with the others, and one that has begun is gone where
|F⁺| / A reaches the last opening: as the stress vanishes its directions say little.)

A facet of a material plane (an interface, joint or bedding) is judged by its own traction: T = √(⟨t·n⟩² + b²) from
the strength of the plane on, and, where it has a cohesion c, |t_s| + t_n tan φ from c on, which friction outlasts.
Its fracture energies count per own area: an opening that is inclined, |t|² = m T², ends at a last opening smaller
by m.

A facet dissipates -∂U/∂s times the loss of its integrity, and neither is ever negative: whatever makes the integrity
fall, dissipation is not negative. Softening follows one line, or two with a kink at κ times the strength: s T is the
larger of both, each of the form a - b (1 - s) T.

Jirásek and Zimmermann (1998) compare cracks that rotate with the principal axes with fixed ones, in smeared models.
"""

import math

from bondem._compile import device
from bondem.laws.cell_energy import cross, scalar

# Least |n·e| by which the strength of a facet is reduced: one along a crack keeps this share of it. Between 0.1 and
# 0.5 the fracture energy of bars differs by 3 %.
LEAST_SLOPE = 0.2
# Traction at which nothing is left of a facet that is too long for its fracture energy, over its strength.
SNAP = 1.05


@device
def plus(a, s, b):
    """Return a + s b."""
    return a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]


@device
def whole_force(k, part, gap, share, stress):
    """Return F of a half as if it were whole [N]: k δ + σ g / w, with `part` w its part of the compliance."""
    return plus((k * gap[0], k * gap[1], k * gap[2]), stress / part, share)


@device
def opening_force(force, normal):
    """Return F⁺, the part of F that opens or shears a crack, and its compressive part on the crack, at most 0 [N]."""
    along = min(scalar(force, normal), 0.0)
    return plus(force, -along, normal), along


@device
def softened(s, traction, onset, last, kink, steep):
    """Return the integrity of a facet under a traction T [Pa], at most s.

    Args:
        onset: t₀ [Pa].
        last: k u / A at the last opening [Pa]; above `onset`, or 0 for a brittle facet.
        kink: κ, 0 for a straight line.
        steep: T where the first line would reach zero, over `last`; 1 for a straight line.
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
def softens_at(s, onset, last, kink, steep):
    """Return the least traction T [Pa] at which the integrity of a facet falls below s, as of `softened`."""
    if last == 0.0:
        return onset if s == 1.0 else 0.0
    first = onset / (steep * last)
    least = onset / (s * (1.0 - first) + first)
    if kink > 0.0:
        slope = kink * onset / (last - (1.0 - kink) * steep * last)
        least = max(least, slope * last / (s * (1.0 - slope) + slope))
    return least


@device
def pulled_along(t, e, slope, stress):
    """Return p_a of a traction t [Pa] along e, where the principal stress is `stress` and n·e is `slope`."""
    pull = scalar(t, e)
    if stress > 0.0:
        return abs(pull)
    return max(pull if slope >= 0.0 else -pull, 0.0)


@device
def left_along(s, t, e, n, bent, stress, strength, last, kink, steep):
    """Return the integrity of a facet of traction t and normal n by its opening along e.

    `bent` is b over the largest |n·e_d|.
    """
    slope = scalar(n, e)
    pull = pulled_along(t, e, slope, stress)
    bent *= abs(slope)
    both = pull + bent
    if both == 0.0:
        return s
    T = math.sqrt(pull * pull + bent * bent)
    share = T / both
    return softened(s, T, strength * max(abs(slope), LEAST_SLOPE) * share, last / share, kink, steep)


@device
def left_in_bulk(s, t, n, bent, a, v, strength, last, kink, steep):
    """Return the integrity of a facet of the material, at most s.

    Args:
        t: traction that it would have if it were whole [Pa].
        n: normal of the facet.
        bent: b [Pa].
        a: mean stress of its cells in its principal directions, of which the diagonal is read [Pa], (3, 3).
        v: these directions, in columns, (3, 3).
        strength: f_t [Pa].
        last, kink, steep: parameters of `softened`.
    """
    most = 0.0
    for d in range(3):
        most = max(most, abs(scalar(n, (v[0, d], v[1, d], v[2, d]))))
    bent /= most
    for d in range(3):
        e = v[0, d], v[1, d], v[2, d]
        s = left_along(s, t, e, n, bent, a[d, d], strength, last, kink, steep)
    if 0.0 < s < 1.0:
        opening, _ = opening_force(t, n)
        if scalar(opening, opening) >= last * last:
            return 0.0
    return s


@device
def left_on_plane(s, t, n, bent, strength, last, cohesion, last_slip, friction, kink, steep):
    """Return the integrity of a facet of a material plane, at most s.

    Args:
        t: traction that it would have if it were whole [Pa].
        n: normal of the facet.
        bent: T_b [Pa]; the part of it that pressure on the facet does not close opens the facet.
        strength: strength in tension [Pa].
        last, kink, steep: parameters of `softened`, in tension.
        cohesion: c [Pa], inf for a plane that does not slip.
        last_slip: k u / A of the slip that exhausts the cohesion [Pa], inf for a constant cohesion.
        friction: tan φ.
    """
    across = scalar(t, n)
    square = max(scalar(t, t) - across * across, 0.0)
    bent = max(bent + min(across, 0.0), 0.0)
    pull = max(across, 0.0) ** 2 + bent * bent
    opened = math.sqrt(pull)
    if opened > strength:
        end = last
        if last > 0.0:  # G_f for the whole opening, of which `opened` is a part
            end = max(last * pull / (pull + square), SNAP * strength / steep)
        s = softened(s, opened, strength, end, kink, steep)
    if cohesion < math.inf:
        s = softened(s, math.sqrt(square) + friction * across, cohesion, last_slip, 0.0, 1.0)
    return s


@device
def rubbed(k, s, gap, normal, slip, limit):
    """Return the friction q on the broken part of a facet [N], and the corresponding slip [m].

    Args:
        slip: previous slip [m], in space.
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
    """Return the torque of the rotating normal on both cells together [N·m].

    It is δ × f less the couples of both halves, as the conservation of angular momentum requires.
    """
    c = cross(gap, force)
    return c[0] - one[0] - other[0], c[1] - one[1] - other[1], c[2] - one[2] - other[2]
