// A cracked facet: two halves in series with springs for the lost stiffness, and friction where the crack is closed.
//
// A facet of stiffness k has a half in each cell p. The half has the part w_p of the compliance, so its own stiffness
// is k / w_p. A crack has an orthonormal frame e_1, e_2, e_3 that turns with cell i, with e_1 as its normal. Along
// e_d half p keeps the fraction s⁺_d of a force that pulls, and s⁻_d of a force that presses. With s one of these
// fractions, springs of the stiffness s / (1 - s) k / w_p in series with the half represent the loss, and open by
// u_p. D is the gap of the two faces, ξ their slip, and σ_p = λ θ the stress of cell p with the dilatation θ. g_p is
// the vector of the facet in V_p θ_p = Σ g_p·D of an intact cell (R_p s_p in `cell.hpp`). With δ = D - ξ, and ⟨x⟩ = x
// where positive, else 0,
//
//     F_p = k δ + σ_p g_p / w_p                                                force of the intact half
//     L_p = Σ_d [(1 - s⁺_d) ⟨F_p·e_d⟩ + (1 - s⁻_d) min(F_p·e_d, 0)] e_d        lost part of this force
//     u_p = w_p L_p / k        V_p θ_p = Σ g_p·δ - g_p·L_p / k
//     f = Σ_p w_p (F_p - L_p) + q
//
//     s⁺_1 = s_1    s⁺_2 = γ s_2    s⁺_3 = γ s_3        s⁻_1 = 1    s⁻_2 = s⁻_3 = γ
//
// A crack of the material has an integrity s_d along each direction. Such a crack keeps the stress along its plane,
// as in the material beside it, and transmits pressure along e_1 as intact material does. The grip γ on traction
// along the crack is 1 until its faces are far apart. A facet of a material plane, or of a cell without cohesion, has
// e_1 = n and a single integrity: s_1 = γ = s and s_2 = s_3 = 1. Such a facet loses all but the pressure across it.
//
// Friction q = (1 - γ) k (D - ξ)_t, with the part t normal to e_1, acts on the broken part of such a facet. Cracks of
// the material have this friction at γ = 0. With this friction, δ is D - (ξ·e_1) e_1, and q has the slip along the
// crack. |q| is at most μ (1 - γ) Σ w_p ⟨-F_p·e_1⟩, so that an open crack has no friction (Alfano and Sacco 2006).
//
// Energy U: halves store ½ k / w |w δ - u|², and their springs ½ s (1 - s) w (F·e_d)² / k for s⁺ or s⁻. Friction
// stores ½ |q|² / (1 - γ) k, and bending s 2 v·H v as in `cell.hpp`, with s the least of s_1, s_2, s_3.
//
// Signs: f acts on cell i, -f on j; D is from i to j, so tension is positive. The couple of the frame that turns with
// cell i follows from the balance of angular momentum. The torques on both cells, without those of f and -f at the
// levers, add up to D × f.
//
// The dissipation of a crack in a step is Σ_d Δa_d r_d r'_d + Δs r_b r'_b. a_d is the share that the half keeps along
// e_d, s⁺_d in tension and s⁻_d in compression. r_d = ±√Σ_p ½ w_p (F_p·e_d)² / k is negative in compression, and
// r_b = √(2 v·H v). r' are the values a step ago. With this product the work by the trapezoidal rule is the change of
// energy and the dissipation. Where tension follows compression, the dissipation along e_d is zero.
#pragma once
#include "../select.hpp"
#include "cell.hpp"
#include "stress.hpp"

namespace bondem {

// Stiffness of a facet, and the part of cell i in its compliance.
template <class T> struct FacetCompliance {
    T k;  // [N/m]
    T part;  // w of cell i; that of j is 1 - w [-]
};
// Integrities s_1, s_2, s_3 of a crack, and its grip.
template <class T> struct CrackIntegrity {
    T s[3], grip;

    BONDEM_INLINE T open(int d) const { return d == 0 ? s[0] : T(grip * s[d]); }
    BONDEM_INLINE T shut(int d) const { return d == 0 ? all<T>(1.0) : grip; }
    BONDEM_INLINE T least_left() const { return least(least(s[0], s[1]), s[2]); }
};
// Three mutually orthogonal directions.
template <class T> struct CrackAxes {
    Vector3<T> e[3];
};
// Crack axes in space from the stored quaternion, whose scalar part is negative for a left-handed set.
template <class T> BONDEM_INLINE CrackAxes<T> axes_of(Quaternion<T> cell, Quaternion<T> stored) {
    const Rotation<T> r = matrix_of(product(cell, stored));
    const T one = all<T>(1.0), side = select(stored.w < T{}, -one, one);
    return {{{r.x.x, r.y.x, r.z.x}, {r.x.y, r.y.y, r.z.y}, {side * r.x.z, side * r.y.z, side * r.z.z}}};
}
// The quaternion that stores axes given in the frame of the cell.
inline Quaternion<double> stored_axes(const CrackAxes<double> &axes) {
    const Vector a = axes.e[0], b = axes.e[1], c = cross(a, b);
    const double side = dot(c, axes.e[2]) < 0.0 ? -1.0 : 1.0, trace = a.x + b.y + c.z;
    Quaternion<double> q;
    if (trace > 0.0) {
        q = {1.0 + trace, b.z - c.y, c.x - a.z, a.y - b.x};
    } else if (a.x >= b.y && a.x >= c.z) {
        q = {b.z - c.y, 1.0 + a.x - b.y - c.z, b.x + a.y, c.x + a.z};
    } else if (b.y >= c.z) {
        q = {c.x - a.z, b.x + a.y, 1.0 + b.y - a.x - c.z, c.y + b.z};
    } else {
        q = {a.y - b.x, c.x + a.z, c.y + b.z, 1.0 + c.z - a.x - b.y};
    }
    constexpr double some = 1e-200;  // so that w has a sign
    q.w = q.w < 0.0 ? least(q.w, -some) : most(q.w, some);
    const double size = root(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z), one = (q.w < 0.0 ? -side : side) / size;
    return {one * q.w, one * q.x, one * q.y, one * q.z};
}
// Axes with a given first direction and arbitrary others.
inline CrackAxes<double> axes_along(Vector e) {
    const Vector other = absolute(e.x) < 0.6 ? Vector{1.0, 0.0, 0.0} : Vector{0.0, 1.0, 0.0};
    const Vector a = minus(other, dot(other, e), e), b = (1.0 / length(a)) * a;
    return {{e, b, cross(e, b)}};
}

// A crack in its present state.
template <class T> struct CrackFaces {
    Vector3<T> gap, strained;  // gap of the faces, and δ [m]
    Vector3<T> normal;  // of the facet, turned with cell i [-]
    T facing;  // cosine between the normals of both cells
    Vector3<T> share_i, share_j;  // g [m²]
    Vector3<T> arm_i, arm_j;  // levers [m]
    CrackAxes<T> at;  // axes in space
    CrackIntegrity<T> left;  // integrities and grip
    Mask<T> rubs;  // true where friction acts on the broken part, whose spring then has the slip

    BONDEM_INLINE const Vector3<T> &across() const { return at.e[0]; }
};
template <class T>
BONDEM_INLINE CrackFaces<T> crack_faces(const Ends<T> &ends, const FacetShape<T> &shape, Vector3<T> normal,
                                        Quaternion<T> axes, const CrackIntegrity<T> &left, Mask<T> rubs,
                                        Vector3<T> slip) {
    const OpenFacet<T> open = opened(ends, shape);
    const Vector3<T> n = turned_by(ends.i, normal), m = turned_by(ends.j, normal);
    const CrackAxes<T> at = axes_of(ends.i, axes);
    // with a spring of friction, the slip along the crack is that of the spring
    const Vector3<T> slipped = turned_by(ends.i, slip), across = dot(slipped, at.e[0]) * at.e[0];
    return {open.gap, open.gap - select<T>(rubs, across, slipped), n, dot(n, m),
            turned_by(ends.i, shape.share_i), turned_by(ends.j, shape.share_j), open.arm_i, open.arm_j, at, left, rubs};
}

// Cosine between the normals of two faces below which they do not press on each other as planes.
constexpr double least_facing = 0.7;
// True if the faces of a crack of area A no longer face each other: the cosine of their normals is below
// `least_facing`, they are further apart than √A, or they have slid by more than `slide` √A.
template <class T> BONDEM_INLINE Mask<T> turned_away(const CrackFaces<T> &now, T area, double slide) {
    const T d = dot(now.gap, now.across()), along = positive(d);
    const Vector3<T> beside = minus(now.gap, d, now.across());
    return (now.facing < all<T>(least_facing)) | (along * along > area) | (dot(beside, beside) > slide * slide * area);
}

// A half of a crack: the force of the whole half along each direction, and its lost part [N].
template <class T> struct CrackHalf {
    T along[3];
    Vector3<T> lost;

    BONDEM_INLINE T press() const { return least(along[0], T{}); }
};
template <class T>
BONDEM_INLINE CrackHalf<T> crack_half(T k, T part, const CrackFaces<T> &at, Vector3<T> share, T stress) {
    const Vector3<T> whole = plus(k * at.strained, stress / part, share);
    CrackHalf<T> half = {};
    const T zero = {}, one = all<T>(1.0);
    for (int d = 0; d < 3; d++) {
        const T F = half.along[d] = dot(whole, at.at.e[d]);
        half.lost = plus(half.lost, T(select(F > zero, T(one - at.left.open(d)), T(one - at.left.shut(d))) * F), at.at.e[d]);
    }
    return half;
}
template <class T> struct CrackHalves {
    CrackHalf<T> i, j;
};
template <class T>
BONDEM_INLINE CrackHalves<T> crack_halves(const FacetCompliance<T> &facet, const CrackFaces<T> &at, OfCells<T> stress) {
    return {crack_half(facet.k, facet.part, at, at.share_i, stress.i),
            crack_half(facet.k, T(1.0 - facet.part), at, at.share_j, stress.j)};
}
// The force that a facet would have if it were whole [N].
template <class T> BONDEM_INLINE Vector3<T> whole_force(T k, const CrackFaces<T> &at, OfCells<T> stress) {
    return plus(plus(k * at.strained, stress.i, at.share_i), stress.j, at.share_j);
}

// Contribution of a half to V θ of its cell, a piecewise linear function of the stress σ of the cell:
//
//     swollen - Σ_d loose_d F_d g_d        F_d = pulled_d + σ inverse g_d
//
// with (1 - s⁺_d) / k for loose_d where F_d pulls, and (1 - s⁻_d) / k where it presses.
template <class T> struct SwellingHalf {
    T swollen, inverse;  // g·δ [m³], 1 / w [-]
    T pulled[3], along[3];  // k δ·e_d [N], g·e_d [m²]
    T loose[3], grip;  // (1 - s⁺_d) / k, (1 - γ) / k [m/N]
    T turns[3];  // σ where it closes or opens [Pa]
    T unused;

    BONDEM_INLINE T force(int d, T stress) const { return pulled[d] + stress * inverse * along[d]; }
    BONDEM_INLINE T loosened(int d, T force) const {
        const T shut = d == 0 ? T{} : grip;
        return select(force > T{}, loose[d], shut);
    }
};
template <class T>
BONDEM_INLINE SwellingHalf<T> swelling_half(T k, T part, const CrackFaces<T> &at, Vector3<T> share) {
    SwellingHalf<T> half = {};
    const T one = all<T>(1.0), soft = one / k;
    half.swollen = dot(share, at.strained);
    half.inverse = one / part;
    for (int d = 0; d < 3; d++) {
        half.pulled[d] = k * dot(at.strained, at.at.e[d]);
        half.along[d] = dot(share, at.at.e[d]);
        half.loose[d] = (one - at.left.open(d)) * soft;
    }
    half.grip = (one - at.left.grip) * soft;
    for (int d = 0; d < 3; d++) {  // no turning point where pull and pressure have equal compliance
        const Mask<T> equal = half.loose[d] == (d == 0 ? T{} : half.grip);
        half.turns[d] = select(equal, all<T>(infinity), T(-half.pulled[d] / (half.along[d] * half.inverse)));
    }
    return half;
}
// Contribution of a half at the stress of its cell [m³], and its decrease with that stress [m³/Pa].
template <class T> struct Swelling {
    T swelling, softness;
};
template <class T> BONDEM_INLINE Swelling<T> swelling_of(const SwellingHalf<T> &half, T stress) {
    Swelling<T> sum = {half.swollen, T{}};
    for (int d = 0; d < 3; d++) {
        const T F = half.force(d, stress), loose = half.loosened(d, F) * half.along[d];
        sum.swelling -= loose * F;
        sum.softness += loose * half.along[d] * half.inverse;
    }
    return sum;
}

// T_b, the rms of tractions by bending [Pa]; `factor` is 4 k / A².
template <class T> BONDEM_INLINE T bending_traction(const Ends<T> &ends, T factor, const Symmetric3<T> &H) {
    return root(positive(bending_square(ends, factor, H)));
}

// Friction q on the broken part [N], and its slip [m]; `limit` is μ times the pressure on that part [N].
template <class T> struct CrackFriction {
    Vector3<T> force, slip;
};
template <class T>
BONDEM_INLINE CrackFriction<T> crack_friction(T k, T grip, Vector3<T> gap, Vector3<T> n, Vector3<T> slip, T limit) {
    const Vector3<T> across = tangential(gap, n), stretch = across - tangential(slip, n);
    const T stiff = (1.0 - grip) * k, size = stiff * length(stretch);
    const T share = select(size > limit, limit / size, all<T>(1.0));
    return {(stiff * share) * stretch, minus(across, share, stretch)};
}

// Roots r of the energies that an intact facet would store, ± along each direction, and by bending [√J].
template <class T> struct CrackRoots {
    T along[3], bent;
};
template <class T> BONDEM_INLINE T signed_root(T square, T sign) {
    const T size = root(square);
    return select(sign < T{}, -size, size);
}
template <class T>
BONDEM_INLINE CrackRoots<T> crack_roots(const FacetCompliance<T> &facet, const CrackHalves<T> &half, T bending) {
    const T half_k = 0.5 / facet.k, w = facet.part, v = 1.0 - w;
    CrackRoots<T> found = {{}, root(positive(bending))};  // rounding may make the energy of bending negative
    for (int d = 0; d < 3; d++) {
        const T i = half.i.along[d], j = half.j.along[d];
        found.along[d] = signed_root(T(half_k * (w * i * i + v * j * j)), T(w * i + v * j));
    }
    return found;
}

// Force and torques of a crack on its cells, without bending.
template <class T> struct CrackLoads {
    Vector3<T> force;  // on i; its opposite on j [N]
    Vector3<T> on_i, on_j;  // torques [N·m]
    CrackFriction<T> friction;
};
// Couple of a half whose share turns with its cell: (w δ - u) × σ g / w.
template <class T>
BONDEM_INLINE Vector3<T> half_couple(T k, T w, const CrackFaces<T> &at, Vector3<T> share, T stress, Vector3<T> lost) {
    return (stress / w) * cross(minus(w * at.strained, T(w / k), lost), share);
}
template <class T>
BONDEM_INLINE CrackLoads<T> crack_loads(const FacetCompliance<T> &facet, const CrackFaces<T> &at,
                                        const CrackHalves<T> &half, OfCells<T> stress, Vector3<T> slip, T friction) {
    const T k = facet.k, w = facet.part, v = 1.0 - w, broken = 1.0 - at.left.grip, zero = {};
    const T limit = -friction * broken * (w * half.i.press() + v * half.j.press());
    CrackFriction<T> rub = {};
    if (any(at.rubs)) {
        const Vector3<T> none = {};
        rub = crack_friction(k, at.left.grip, at.gap, at.across(), slip, limit);
        rub = {select<T>(at.rubs, rub.force, none), select<T>(at.rubs, rub.slip, none)};
    }
    // each direction separately, so that the force is exactly zero at zero integrity
    Vector3<T> f = rub.force;
    for (int d = 0; d < 3; d++) {
        const auto passed = [&](T F) { return select(F > zero, T(at.left.open(d) * F), T(at.left.shut(d) * F)); };
        f = plus(f, T(w * passed(half.i.along[d]) + v * passed(half.j.along[d])), at.at.e[d]);
    }
    const Vector3<T> couple = half_couple(k, v, at, at.share_j, stress.j, half.j.lost);
    return {f, cross(at.arm_i + at.gap, f) - couple, cross(f, at.arm_j) + couple, rub};
}

// Energy dissipated in a step by a crack, and by its friction [J].
template <class T> struct CrackLosses {
    T cracked, rubbed;
};
// Integrities, roots of energies and friction force before and after a step, and the slip in between.
template <class T> struct CrackStep {
    CrackIntegrity<T> before, now;
    CrackRoots<T> roots_before, roots;
    Vector3<T> rub_before, rub, increment;
};
template <class T> BONDEM_INLINE CrackLosses<T> crack_losses(T k, const CrackStep<T> &step) {
    const T zero = {}, one = all<T>(1.0), fell = step.before.grip - step.now.grip;
    T cracked = (step.before.least_left() - step.now.least_left()) * (step.roots_before.bent * step.roots.bent);
    for (int d = 0; d < 3; d++) {
        const T energy = step.roots_before.along[d] * step.roots.along[d];
        const Mask<T> pulls = step.roots.along[d] > zero, straight = step.now.s[d] == one;
        const auto share = [&](const CrackIntegrity<T> &left) { return select(pulls, left.open(d), left.shut(d)); };
        cracked += (share(step.before) - share(step.now)) * select(straight, energy, positive(energy));
    }
    const Vector3<T> stretch = (1.0 / (k * (1.0 - step.now.grip))) * step.rub;
    // the spring of friction stores ½ k Δγ times the product of its stretches before and after
    const T taken = select(step.before.grip < one, T(0.5 * dot(step.rub_before, stretch) / (1.0 - step.before.grip)),
                           T(0.5 * k * dot(stretch + step.increment, stretch)));
    return {cracked - select(fell > zero, T(taken * fell), zero),
            0.5 * (dot(step.rub_before, step.increment) + dot(step.rub, step.increment))};
}

// Elastic energy across and along a crack, without bending [J].
template <class T> struct CrackEnergy {
    T across, along;
};
// Elastic energy of the spring of friction [J].
template <class T> BONDEM_INLINE T friction_energy(T k, T grip, Vector3<T> rub) {
    const T stiff = k * (1.0 - grip);
    return select(stiff > T{}, T(0.5 * dot(rub, rub) / stiff), T{});
}
template <class T>
BONDEM_INLINE CrackEnergy<T> crack_energy(const FacetCompliance<T> &facet, const CrackFaces<T> &at,
                                          const CrackHalves<T> &half, Vector3<T> rub) {
    const T k = facet.k, zero = {}, one = all<T>(1.0);
    const Vector3<T> none = {};
    CrackEnergy<T> sum = {};
    const auto add = [&](T w, const CrackHalf<T> &of) __attribute__((always_inline)) {
        const Vector3<T> e = minus(w * at.strained, T(w / k), of.lost);
        const T normal = dot(e, at.across()), across = normal * normal, stiff = 0.5 * k / w;
        sum.across = sum.across + stiff * across;
        for (int d = 0; d < 3; d++) {
            const T F = of.along[d], s = select(F > zero, at.left.open(d), at.left.shut(d));
            sum.across = sum.across + 0.5 * s * (one - s) * w / k * F * F;
        }
        sum.along = sum.along + stiff * (dot(e, e) - across);
    };
    add(facet.part, half.i);
    add(T(1.0 - facet.part), half.j);
    sum.along = sum.along + friction_energy(k, at.left.grip, select<T>(at.rubs, rub, none));
    return sum;
}

}  // namespace bondem
