// A cracked facet: two halves in series with springs that stand for what has been lost, and friction where it has
// closed.
//
// Half p of a facet of stiffness k has the part w_p of its compliance, so its own stiffness is k / w_p. Integrity s
// puts a spring s / (1 - s) k / w_p in series with it, whose opening u_p is eliminated. With δ the gap of the two
// faces, σ_p = λ θ of the cell, g_p = R_p (A w m)_p its share in the swelling, and n the normal of the reference
// turned with both cells, in the middle,
//
//     F_p = k δ + σ_p g_p / w_p        the force of that half as if it were whole
//     F⁺ = F - min(F·n, 0) n           what of it opens or shears
//     u_p = (1 - s) w_p F⁺_p / k       V_p θ_p = Σ g_p·δ - (1 - s) g_p·F⁺_p / k
//     f = Σ_p w_p [s F_p + (1 - s) min(F_p·n, 0) n] + q
//     -∂U/∂s = Σ_p w_p |F⁺_p|² / 2 k + bending - friction spring ≥ 0
//
// so a closed crack carries pressure with Lamé's λ, as whole material does. q = (1 - s) k (δ_t - slip) is friction on
// what is broken, cut at μ times the pressure on it. An open crack has no friction (Alfano and Sacco 2006).
//
// Energy U: halves store ½ k / w |w δ - u|², their springs ½ s (1 - s) w |F⁺|² / k, friction ½ |q|² / (1 - s) k, and
// bending s 2 v·H v with v the vector part of q_i* q_j.
//
// Signs: f acts on cell i, -f on j; δ is from i to j, so tension is positive. The couples of the turning normals
// follow from the balance of angular momentum: all torques and δ × f together are zero.
//
// What a crack dissipates in a step is -∂U/∂s times its loss of integrity. The product of the openings before and
// after, the geometric mean of both rates, is exact where the opening does not turn: then works by the trapezoidal
// rule, energy and dissipation add up to zero.
#pragma once
#include "../select.hpp"
#include "cell.hpp"
#include "stress.hpp"

namespace bondem {

template <class T> struct FacetCompliance {
    T k;  // [N/m]
    T part;  // w of cell i; that of j is 1 - w [-]
};
// Its two faces now.
template <class T> struct CrackFaces {
    Vector3<T> gap, normal;  // δ [m], n [-]
    Vector3<T> share_i, share_j;  // g [m²]
    Vector3<T> arm_i, arm_j;  // levers [m]
    Vector3<T> normal_i;  // the normal of the reference turned with cell i [-]
};
// And the cosine between the normals of both, for faces that turn away from each other.
template <class T> struct FacedFaces {
    CrackFaces<T> faces;
    T facing;
};
template <class T>
BONDEM_INLINE FacedFaces<T> crack_faces(const Ends<T> &ends, const FacetShape<T> &shape, Vector3<T> normal) {
    const OpenFacet<T> open = opened(ends, shape);
    const Vector3<T> n = turned_by(ends.i, normal), m = turned_by(ends.j, normal), both = n + m;
    return {{open.gap, (1.0 / length(both)) * both, turned_by(ends.i, shape.share_i), turned_by(ends.j, shape.share_j),
             open.arm_i, open.arm_j, n},
            dot(n, m)};
}

// Faces whose normals are further apart than this cosine do not press on each other as planes.
constexpr double least_facing = 0.7;
// Whether the faces of a crack of a facet of this area no longer face each other: they are further apart than √A, or have
// slid by more than `slide` √A.
template <class T> BONDEM_INLINE Mask<T> turned_away(const FacedFaces<T> &now, T area, double slide) {
    const Vector3<T> gap = now.faces.gap, n = now.faces.normal;
    const T d = dot(gap, n), along = positive(d);
    const Vector3<T> across = minus(gap, d, n);
    return (now.facing < all<T>(least_facing)) | (along * along > area) | (dot(across, across) > slide * slide * area);
}

// F of a half as if it were whole, its opening part, and its pressing part along the normal, at most 0 [N].
template <class T> struct CrackHalf {
    Vector3<T> opening;
    T press;
};
template <class T> BONDEM_INLINE CrackHalf<T> crack_half(T k, T part, Vector3<T> gap, Vector3<T> share, T stress,
                                                         Vector3<T> n) {
    const Vector3<T> whole = plus(k * gap, stress / part, share);
    const T press = least(dot(whole, n), T{});
    return {minus(whole, press, n), press};
}
template <class T> struct CrackHalves {
    CrackHalf<T> i, j;
};
template <class T>
BONDEM_INLINE CrackHalves<T> crack_halves(const FacetCompliance<T> &facet, const CrackFaces<T> &at,
                                          OfCells<T> stress) {
    return {crack_half(facet.k, facet.part, at.gap, at.share_i, stress.i, at.normal),
            crack_half(facet.k, T(1.0 - facet.part), at.gap, at.share_j, stress.j, at.normal)};
}
// The force that a facet would have if it were whole [N].
template <class T>
BONDEM_INLINE Vector3<T> whole_force(T k, const CrackFaces<T> &at, OfCells<T> stress) {
    return plus(plus(k * at.gap, stress.i, at.share_i), stress.j, at.share_j);
}

// What a half adds to V θ of its cell, a piecewise linear function of the stress σ of the cell:
// swollen - loose (pulled + σ square), and where closed + σ pressed < 0, + loose (closed + σ pressed) along.
template <class T> struct SwellingHalf {
    T swollen, pulled;  // g·δ [m³], k g·δ [N·m²]
    T square, along, pressed;  // g² / w [m⁴], g·n, g·n / w [m²]
    T closed;  // k δ·n [N]
    T loose;  // (1 - s) / k [m/N]
    T turns;  // σ where it closes or opens [Pa]
};
template <class T>
BONDEM_INLINE SwellingHalf<T> swelling_half(T k, T part, T s, Vector3<T> gap, Vector3<T> share, Vector3<T> n) {
    const T swollen = dot(share, gap), along = dot(share, n), inverse = 1.0 / part;
    const T closed = k * dot(gap, n), pressed = along * inverse;
    return {swollen, k * swollen, dot(share, share) * inverse, along, pressed, closed, (1.0 - s) / k,
            -closed / pressed};
}

// Energy of the bending of a whole facet [J], and its torque on i [N·m].
template <class T> struct FacetBending {
    T energy;
    Vector3<T> torque;
};
template <class T> BONDEM_INLINE FacetBending<T> facet_bending(const Ends<T> &ends, const Symmetric3<T> &H) {
    const RelativeTurn<T> turn = relative_turn(ends.i, ends.j);
    const Vector3<T> resisted = H * turn.v, h = turned_by(ends.i, resisted);
    const Vector3<T> c = plus_cross(turn.w * h, turn.space, h);
    return {2.0 * dot(turn.v, resisted), c + c};
}
// T_b [Pa]; `factor` is 4 k / A².
template <class T> BONDEM_INLINE T bending_traction(const Ends<T> &ends, T factor, const Symmetric3<T> &H) {
    return root(positive(bending_square(ends, factor, H)));
}

// Friction q on what is broken [N], and the slip that belongs to it [m]; `limit` is μ times the pressure on it [N].
template <class T> struct CrackFriction {
    Vector3<T> force, slip;
};
template <class T>
BONDEM_INLINE CrackFriction<T> crack_friction(T k, T s, Vector3<T> gap, Vector3<T> n, Vector3<T> slip, T limit) {
    const Vector3<T> across = minus(gap, dot(gap, n), n), stretch = across - minus(slip, dot(slip, n), n);
    const T stiff = (1.0 - s) * k, size = stiff * length(stretch);
    const T kept = select(size > limit, limit / size, all<T>(1.0));
    return {(stiff * kept) * stretch, minus(across, kept, stretch)};
}

// What a crack does to its cells, but for bending.
template <class T> struct CrackLoads {
    Vector3<T> force;  // on i; its opposite on j [N]
    Vector3<T> on_i, on_j;  // torques [N·m]
    CrackFriction<T> friction;
    T rate;  // -∂U/∂s without bending and friction [J]
};
// Couple of a half whose normal turns with its cell: (w δ - u) × σ g / w.
template <class T>
BONDEM_INLINE Vector3<T> half_couple(T k, T w, T s, Vector3<T> gap, Vector3<T> share, T stress, Vector3<T> opening) {
    return (stress / w) * cross(minus(w * gap, T((1.0 - s) * w / k), opening), share);
}
template <class T>
BONDEM_INLINE CrackLoads<T> crack_loads(const FacetCompliance<T> &facet, const CrackFaces<T> &at, T s,
                                        OfCells<T> stress,
                                        Vector3<T> slip, T friction) {
    const T k = facet.k, w = facet.part, v = 1.0 - w;
    const CrackHalves<T> half = crack_halves(facet, at, stress);
    const T along = w * half.i.press + v * half.j.press;
    const CrackFriction<T> rub = crack_friction(k, s, at.gap, at.normal, slip, T(-friction * (1.0 - s) * along));
    const Vector3<T> sheared = plus(plus(rub.force, T(s * w), half.i.opening), T(s * v), half.j.opening);
    const Vector3<T> f = plus(sheared, along, at.normal);
    const Vector3<T> ci = half_couple(k, w, s, at.gap, at.share_i, stress.i, half.i.opening);
    const Vector3<T> cj = half_couple(k, v, s, at.gap, at.share_j, stress.j, half.j.opening);
    // the normal n = (n_i + n_j) / |n_i + n_j| turns with both cells, and the slip with cell i
    const Vector3<T> both = cross(at.gap, f) - ci - cj, slid = cross(rub.slip, rub.force), turning = both - slid;
    const T half_inverse = 0.5 / dot(at.normal_i, at.normal);  // 1 / |n_i + n_j|
    const Vector3<T> t = half_inverse * cross(at.normal_i, cross(turning, at.normal));
    const T rate = 0.5 / k * (w * dot(half.i.opening, half.i.opening) + v * dot(half.j.opening, half.j.opening));
    return {f, cross(at.arm_i, f) + ci + slid + t, cross(f, at.arm_j) + cj + turning - t, rub, rate};
}

// What a crack has dissipated in a step, and what friction has [J].
template <class T> struct CrackLosses {
    T cracked, rubbed;
};
// Integrity, -∂U/∂s and friction force before and now, and the slip that came between.
template <class T> struct CrackStep {
    T s_before, s;
    T rate_before, rate;
    Vector3<T> rub_before, rub, came;
};
template <class T> BONDEM_INLINE CrackLosses<T> crack_losses(T k, const CrackStep<T> &step) {
    const T fell = step.s_before - step.s, zero = {}, one = all<T>(1.0);
    const Vector3<T> stretch = (1.0 / (k * (1.0 - step.s))) * step.rub;
    // the spring of friction stores Δs times the product of its stretches before and after
    const T taken = select(step.s_before < one, T(0.5 * dot(step.rub_before, stretch) / (1.0 - step.s_before)),
                           T(0.5 * k * dot(stretch + step.came, stretch)));
    const T cracked = (root(positive(step.rate_before * step.rate)) - taken) * fell;
    return {select(fell > zero, cracked, zero), 0.5 * (dot(step.rub_before, step.came) + dot(step.rub, step.came))};
}

// Elastic energy across and along a crack, but for bending [J].
template <class T> struct CrackEnergy {
    T across, along;
};
// That of the spring of friction.
template <class T> BONDEM_INLINE T friction_energy(T k, T s, Vector3<T> rub) {
    const T stiff = k * (1.0 - s);
    return select(stiff > T{}, T(0.5 * dot(rub, rub) / stiff), T{});
}
template <class T>
BONDEM_INLINE CrackEnergy<T> crack_energy(const FacetCompliance<T> &facet, const CrackFaces<T> &at, T s,
                                          const CrackHalves<T> &half, Vector3<T> rub) {
    const T k = facet.k;
    CrackEnergy<T> sum = {};
    const auto add = [&](T w, Vector3<T> opening) __attribute__((always_inline)) {
        const Vector3<T> e = minus(w * at.gap, T((1.0 - s) * w / k), opening);
        const T normal = dot(e, at.normal), across = normal * normal, stiff = 0.5 * k / w;
        sum.across = sum.across + stiff * across + 0.5 * s * (1.0 - s) * w / k * dot(opening, opening);
        sum.along = sum.along + stiff * (dot(e, e) - across);
    };
    add(facet.part, half.i.opening);
    add(T(1.0 - facet.part), half.j.opening);
    sum.along = sum.along + friction_energy(k, s, rub);
    return sum;
}

}  // namespace bondem
