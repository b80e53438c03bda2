// Facets that lose their integrity: from strength and fracture energy to the integrity that loads leave.
//
// With t the traction that a facet would have if it were whole, n its normal, and e_1, e_2, e_3 the present principal
// directions of the mean stress of its two cells, the criterion of a facet is evaluated along each of them:
//
//     T_a² = p_a² + b_a²        b_a = b |n·e_a| / max_d |n·e_d|
//     p_a = |t·e_a| where σ_a > 0, else ⟨t·e_a sign(n·e_a)⟩
//     strength r f_t c_a        c_a = max(|n·e_a|, 0.2)        r = T_a / (p_a + b_a)
//
// Bending opens one edge of a facet more than the other: T_b = √(2 k U_b) / A is the rms of the tractions by which
// its points differ, U_b the energy of bending of the whole facet, and b = ⟨T_b - ⟨-σ_3⟩⟩ what of it opens the facet.
//
// The integrity s is the least that the softening curve gives along any direction, and never rises: s T falls from
// the strength t_0 to 0 as the opening u = (1 - s) A T / k grows to its last one, 2 G_f / f_t (of a straight line;
// over r), which is the same for all facets. So every facet begins to soften at σ_1 = f_t, and dissipates G_f A c_a,
// which is G_f per area projected on the crack. With T_l = k u / A at the last opening, the curve is the larger of
// two lines, each of the form a - b (1 - s) T,
//
//     s = t_0 (1 - T / m T_l) / T (1 - t_0 / m T_l)
//     s = g (1 - T / T_l) / T (1 - g / T_l)        g = κ t_0 / (1 - (1 - κ) m)
//
// with the kink at κ t_0 and m the opening where the first line would reach zero, over the last one. κ = 0 and m = 1
// are a straight line.
//
// A facet of a material plane (interface, joint, bedding) fails by its own traction: √(⟨t·n⟩² + b²) from the
// strength of the plane on, and |t_s| + t_n tan φ from the cohesion c on. Its fracture energies count per own area:
// an opening that is inclined, |t|² = q T², ends at a last opening smaller by q.
//
// Sources: decisions 0019 and 0028. Jirásek and Zimmermann (1998) compare cracks that rotate with the principal axes
// with fixed ones, in smeared models.
#pragma once
#include "principal.hpp"

namespace bondem {

// Least |n·e| by which the strength of a facet is reduced: one along a crack keeps this share of it.
constexpr double least_slope = 0.2;
// Traction at which nothing is left of a facet that is too long for its fracture energy, over its strength.
constexpr double snap = 1.05;

struct CurveShape {
    double kink, steep;  // κ and m [-]
};
// A facet as its softening curve has it.
template <class T> struct Softening {
    T strength;  // [Pa]; 0 where a cell of the facet has no cohesion
    T brittleness;  // 1 / T_l [1/Pa]; inf for a facet that breaks at once, 0 for one that never does
};

template <class T> BONDEM_INLINE T second_line(T onset, const CurveShape &curve) {
    return curve.kink / (1.0 - (1.0 - curve.kink) * curve.steep) * onset;
}
// The integrity of a facet under a traction T [Pa], at most s.
template <class T> BONDEM_INLINE T softened(T s, T traction, T onset, T brittleness, const CurveShape &curve) {
    const T first = brittleness * (1.0 / curve.steep);
    T left = onset * (1.0 - traction * first) / (traction * (1.0 - onset * first));
    if (curve.kink > 0.0) {
        const T g = second_line(onset, curve);
        left = most(left, g * (1.0 - traction * brittleness) / (traction * (1.0 - g * brittleness)));
    }
    const T fallen = select(traction * brittleness >= all<T>(1.0), T{}, least(s, left));
    return select(traction <= onset, s, fallen);
}
// The least traction at which the integrity of a facet falls below s [Pa].
template <class T> BONDEM_INLINE T softens_at(T s, T onset, T brittleness, const CurveShape &curve) {
    const T first = onset * brittleness * (1.0 / curve.steep), one = all<T>(1.0);
    T found = onset / (s * (1.0 - first) + first);
    if (curve.kink > 0.0) {
        const T g = second_line(onset, curve), slope = g * brittleness;
        found = most(found, g / (s * (1.0 - slope) + slope));
    }
    return select(brittleness < all<T>(infinity), found, select(s == one, onset, T{}));
}

// The force or traction f less its part along the normal where that presses: F⁺ opens or shears a crack.
template <class T> BONDEM_INLINE Vector3<T> opening_part(Vector3<T> f, Vector3<T> normal, T along) {
    return minus(f, least(along, T{}), normal);
}

// p_a of a traction t along e, where the principal stress is `stress` and n·e is `slope` [Pa].
template <class T> BONDEM_INLINE T pulled_along(Vector3<T> t, Vector3<T> e, T slope, T stress) {
    const T pull = dot(t, e), zero = {};
    return select(stress > zero, absolute(pull), positive(select(slope >= zero, pull, -pull)));
}

// A facet of the material of traction t and normal n; `bent` is b [Pa]. The integrity that is left, at most s.
template <class T>
BONDEM_INLINE T left_in_bulk(T s, Vector3<T> t, Vector3<T> n, T bent, const PrincipalStress<T> &principal,
                             const Softening<T> &facet, const CurveShape &curve) {
    const T whole = s, zero = {}, one = all<T>(1.0);
    T slope[3], largest = {};
    for (int d = 0; d < 3; d++) {
        slope[d] = dot(n, principal.direction[d]);
        largest = most(largest, absolute(slope[d]));
    }
    const T share_of_bending = bent / largest;
    for (int d = 0; d < 3; d++) {
        const T pull = pulled_along(t, principal.direction[d], slope[d], principal.stress[d]);
        const T steepness = absolute(slope[d]), bending = share_of_bending * steepness, both = pull + bending;
        const T traction = root(pull * pull + bending * bending), share = traction / both;
        const T onset = facet.strength * most(steepness, all<T>(least_slope)) * share;
        s = select(both == zero, s, softened(s, traction, onset, facet.brittleness * share, curve));
    }
    // one that has begun is gone where its opening is the last one: as the stress vanishes its directions say little
    const Vector3<T> opening = opening_part(t, n, dot(t, n));
    const Mask<T> gone = (zero < s) & (s < one) & (root(dot(opening, opening)) * facet.brittleness >= one);
    return select(whole == zero, whole, select(gone, zero, s));
}

// What a material plane has besides its strength in tension.
template <class T> struct PlaneStrength {
    T cohesion;  // c [Pa], inf for a plane that does not slip
    T brittleness;  // 1 / T_l of the slip that exhausts the cohesion [1/Pa], 0 for a constant cohesion
    T friction;  // tan φ
};
// A facet of a material plane; `bent` is T_b [Pa], of which pressure on the facet closes a part.
template <class T>
BONDEM_INLINE T left_on_plane(T s, Vector3<T> t, Vector3<T> n, T bent, const Softening<T> &facet,
                              const PlaneStrength<T> &plane, const CurveShape &curve) {
    const T across = dot(t, n), square = positive(dot(t, t) - across * across), zero = {};
    const T bending = positive(bent + least(across, zero)), pull = positive(across);
    const T opened = pull * pull + bending * bending, traction = root(opened);
    // G_f is for the whole opening, of which `traction` is a part
    const T ends = least(facet.brittleness * (opened + square) / opened, (curve.steep / snap) / facet.strength);
    const T brittleness = select(facet.brittleness < all<T>(infinity), ends, facet.brittleness);
    s = select(traction > facet.strength, softened(s, traction, facet.strength, brittleness, curve), s);
    const T slides = root(square) + plane.friction * across;
    const T slid = softened(s, slides, plane.cohesion, plane.brittleness, CurveShape{0.0, 1.0});
    return select(plane.cohesion < all<T>(infinity), slid, s);
}

// Criterion of a facet.
template <class T> struct CrackStrength {
    Softening<T> tension;
    PlaneStrength<T> plane;
    Mask<T> on_plane;
};
// A facet's loads as if it were whole.
template <class T> struct FacetTraction {
    Vector3<T> t, normal;  // [Pa], [-]
    T bent;  // T_b [Pa]
};
// The integrity of a facet under its present loads, at most s, by the softening curve alone.
template <class T>
BONDEM_INLINE T integrity_left(T s, const FacetTraction<T> &load, const PrincipalStress<T> &principal,
                               const CrackStrength<T> &by, const CurveShape &curve) {
    const T zero = {}, b = positive(load.bent - largest_pressure(principal));
    T left = left_in_bulk(s, load.t, load.normal, b, principal, by.tension, curve);
    if (any(by.on_plane)) {
        const T plane = left_on_plane(s, load.t, load.normal, load.bent, by.tension, by.plane, curve);
        left = select(by.on_plane, plane, left);
    }
    const Mask<T> loose = by.tension.strength == zero;
    if (any(loose)) {
        const Vector3<T> opening = opening_part(load.t, load.normal, dot(load.t, load.normal));
        const T size = root(dot(opening, opening) + load.bent * load.bent);
        left = select(loose, softened(s, size, zero, by.tension.brittleness, curve), left);
    }
    // what breaks at once continues
    const Mask<T> breaks = (by.tension.brittleness == all<T>(infinity)) & (s < all<T>(1.0));
    return select(breaks, zero, left);
}
// The traction below which a facet of integrity s does not soften, whatever its direction [Pa].
template <class T> BONDEM_INLINE T unsoftened_below(T s, const CrackStrength<T> &by, const CurveShape &curve) {
    const T zero = {}, one = all<T>(1.0), strength = by.tension.strength;
    const Mask<T> brittle = by.tension.brittleness == all<T>(infinity);
    // a facet that is pulled and bent begins at 1/√2 of its strength, by the rms of its points
    const T bulk = softens_at(s, 0.7 * least_slope * strength, by.tension.brittleness, curve);
    const T slips = by.plane.cohesion / root(1.0 + by.plane.friction * by.plane.friction);
    const T plane = select(brittle & (s < one), zero, least(strength, slips));
    return select(s == zero, all<T>(infinity), select(by.on_plane, plane, bulk));
}

}  // namespace bondem
