// Facets that lose their integrity: the integrity under given loads, by strength and fracture energy.
//
// Let t be the traction that a facet of the material would have if it were intact, and n its normal. The crack of the
// facet has the axes e_1, e_2, e_3 (`laws/crack.hpp`). Each axis has its own criterion and its own integrity s_d.
// With the strength f_t of the facet, and ⟨x⟩ as x where positive, else 0,
//
//     T_d² = p_d² + b_d²        p_d = ⟨t·e_d⟩        b_d = b |n·e_d| / max |n·e|
//     strength r f_t c_d        c_d = max(|n·e_d|, 0.2)        r = T_d / (p_d + b_d)
//
// Bending opens one edge of a facet more than the other. U_b is the bending energy of the intact facet, k its
// stiffness, A its area, and T_b = √(2 k U_b) / A the rms of the tractions by bending. The part
// b = ⟨T_b - max_d ⟨-σ_dd⟩⟩ opens the facet, with σ the mean stress of its two cells.
//
// An integrity follows the softening curve, and never rises. With T = T_d, the product s T falls from the strength
// t_0 = r f_t c_d to 0 as the opening u = (1 - s) A T / k grows to the last opening. The last opening is
// 2 G_f / (r f_t) for a straight line, and the same for all facets. Every facet therefore begins to soften at
// σ_1 = f_t, and dissipates G_f A c_d, which is G_f per area projected on the crack. T_l is k u / A at the last
// opening. The curve is the larger of two straight lines of s T over (1 - s) T:
//
//     s = t_0 (1 - T / m T_l) / T (1 - t_0 / m T_l)
//     s = g (1 - T / T_l) / T (1 - g / T_l)        g = κ t_0 / (1 - (1 - κ) m)
//
// κ t_0 is the traction at the kink, and m the opening at which the first line would reach zero, over the last
// opening. With κ = 0 and m = 1 the curve is one straight line.
//
// `passes/cracks/crack_axes.hpp` chooses the axes of a crack. While the integrities along e_2 and e_3 are 1, these
// axes turn in the plane of the crack into the principal directions there. In a step, slip of the faces adds to p_d,
// and p_d of an intact axis has no part by shear of σ (`passes/cracks/softening_cracks.hpp`).
//
// A facet of a material plane (interface, joint, bedding) fails by its own traction. Either √(⟨t·n⟩² + b²) exceeds
// its strength, with b = ⟨T_b - ⟨-t·n⟩⟩, or |t_s| + t_n tan φ exceeds its cohesion. t_n and t_s are the normal and
// the shear part of t, and φ is the angle of friction. The fracture energies of such a facet count per area of the
// facet. In an inclined direction, where |t|² = q T², the last opening is therefore smaller by the factor q.
//
// Sources: 0019, 0028 and 0045 of docs/decisions. Cracks that keep their directions, several at a point at right
// angles, are those of the fixed smeared crack models (de Borst and Nauta 1985); Jirásek and Zimmermann (1998)
// compare them with cracks that rotate with the principal axes.
#pragma once
#include "principal.hpp"

namespace bondem {

// Least factor |n·e| on the strength of a facet, that of a facet along a crack.
constexpr double least_slope = 0.2;
// Traction of zero integrity over the strength, for a facet that is too long for its fracture energy.
constexpr double snap = 1.05;

struct CurveShape {
    double kink, steep;  // κ and m [-]
};
// Softening curve of a facet.
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

// Integral ∫ T² (-ds) along the curve, from a traction to its end [Pa²]: a / (1 - b) times the length of each line.
inline double absorbed_from(double traction, double onset, double last, const CurveShape &curve) {
    const double end = curve.steep * last, first = onset / (1.0 - onset / end);
    if (!(curve.kink > 0.0)) return first * positive(last - traction);
    const double corner = curve.kink * onset + (1.0 - curve.kink) * end, g = second_line(onset, curve);
    return first * positive(corner - traction) + g / (1.0 - g / last) * positive(last - most(traction, corner));
}

// The force or traction f less its part along the normal where that presses: F⁺ opens or shears a crack.
template <class T> BONDEM_INLINE Vector3<T> opening_part(Vector3<T> f, Vector3<T> normal, T along) {
    return minus(f, least(along, T{}), normal);
}

// Pull of a traction t along intact e [Pa]: |t·e| if the principal `stress` there pulls, else ⟨t·e⟩ for e towards n.
template <class T> BONDEM_INLINE T pulled_along(Vector3<T> t, Vector3<T> e, T slope, T stress) {
    const T pull = dot(t, e), zero = {};
    return select(stress > zero, absolute(pull), positive(select(slope >= zero, pull, -pull)));
}

// Traction of pull and bending along a direction of a crack, and the two factors r c_d of the strength there.
template <class T> struct LoadAlong {
    T traction, share, slope;  // T_d [Pa], r, c_d [-]
};
template <class T> BONDEM_INLINE LoadAlong<T> load_along(T pull, T bending, T slope) {
    const T both = pull + bending, traction = root(pull * pull + bending * bending), zero = {};
    return {traction, select(both > zero, traction / both, all<T>(1.0)), most(slope, all<T>(least_slope))};
}
// Strength and brittleness of a facet along a direction of its crack.
template <class T> BONDEM_INLINE Softening<T> strength_along(const Softening<T> &facet, const LoadAlong<T> &load) {
    return {facet.strength * load.slope * load.share, facet.brittleness * load.share};
}
// The integrity along a direction of a crack, at most s.
template <class T>
BONDEM_INLINE T left_along(T s, const LoadAlong<T> &load, const Softening<T> &facet, const CurveShape &curve) {
    const T zero = {};
    const Softening<T> own = strength_along(facet, load);
    const T left = select(load.traction > zero, softened(s, load.traction, own.strength, own.brittleness, curve), s);
    // brittle failure continues once begun
    return select((facet.brittleness == all<T>(infinity)) & (s < all<T>(1.0)), zero, left);
}
// Largest traction that a direction of integrity s transmits, over its strength, for r = 1 [-].
template <class T>
BONDEM_INLINE T borne_of(T s, T slope, const Softening<T> &facet, const CurveShape &curve) {
    const T onset = facet.strength * slope, one = all<T>(1.0);
    return select(s < one, least(one, T(s * softens_at(s, onset, facet.brittleness, curve) / onset)), one);
}

// Parameters of a material plane besides its tensile strength.
template <class T> struct PlaneStrength {
    T cohesion;  // c [Pa], inf for a plane that does not slip
    T brittleness;  // 1 / T_l of the slip that exhausts the cohesion [1/Pa], 0 for a constant cohesion
    T friction;  // tan φ
};
// Loads of a facet of a plane: the traction that opens it [Pa], 1 / T_l along that opening [1/Pa], and the traction
// that slides it [Pa]. `bent` is T_b [Pa], of which pressure on the facet closes a part.
template <class T> struct PlaneLoad {
    T traction, brittleness, slides;
};
template <class T>
BONDEM_INLINE PlaneLoad<T> load_on_plane(Vector3<T> t, Vector3<T> n, T bent, const Softening<T> &facet, T friction,
                                         double steep) {
    const T across = dot(t, n), square = positive(dot(t, t) - across * across), zero = {};
    const T bending = positive(bent + least(across, zero)), pull = positive(across);
    const T opened = pull * pull + bending * bending;
    // G_f is for the whole opening, of which √`opened` is a part
    const T ends = least(facet.brittleness * (opened + square) / opened, (steep / snap) / facet.strength);
    return {root(opened), select(facet.brittleness < all<T>(infinity), ends, facet.brittleness),
            root(square) + friction * across};
}
template <class T>
BONDEM_INLINE T left_on_plane(T s, Vector3<T> t, Vector3<T> n, T bent, const Softening<T> &facet,
                              const PlaneStrength<T> &plane, const CurveShape &curve) {
    const PlaneLoad<T> load = load_on_plane(t, n, bent, facet, plane.friction, curve.steep);
    const T left = softened(s, load.traction, facet.strength, load.brittleness, curve);
    s = select(load.traction > facet.strength, left, s);
    const T slid = softened(s, load.slides, plane.cohesion, plane.brittleness, CurveShape{0.0, 1.0});
    return select(plane.cohesion < all<T>(infinity), slid, s);
}

// Criterion of a facet.
template <class T> struct CrackStrength {
    Softening<T> tension;
    PlaneStrength<T> plane;
    Mask<T> on_plane;
};
// Loads of a facet at full integrity.
template <class T> struct FacetTraction {
    Vector3<T> t, normal;  // [Pa], [-]
    T bent;  // T_b [Pa]
};
// The integrity of a facet of a material plane, or of a cell without cohesion, under its present loads, at most s.
template <class T>
BONDEM_INLINE T integrity_left(T s, const FacetTraction<T> &load, const CrackStrength<T> &by, const CurveShape &curve) {
    const T zero = {};
    T left = left_on_plane(s, load.t, load.normal, load.bent, by.tension, by.plane, curve);
    const Mask<T> loose = by.tension.strength == zero;
    if (any(loose)) {
        const Vector3<T> opening = opening_part(load.t, load.normal, dot(load.t, load.normal));
        const T size = root(dot(opening, opening) + load.bent * load.bent);
        left = select(loose, softened(s, size, zero, by.tension.brittleness, curve), left);
    }
    // brittle failure continues once begun
    const Mask<T> breaks = (by.tension.brittleness == all<T>(infinity)) & (s < all<T>(1.0));
    return select(breaks, zero, left);
}
// The traction below which a facet of a plane does not soften in any direction [Pa].
template <class T> BONDEM_INLINE T unsoftened_below(T s, const CrackStrength<T> &by) {
    const T zero = {}, one = all<T>(1.0), strength = by.tension.strength;
    const Mask<T> brittle = by.tension.brittleness == all<T>(infinity);
    const T slips = by.plane.cohesion / root(1.0 + by.plane.friction * by.plane.friction);
    const T plane = select(brittle & (s < one), zero, least(strength, slips));
    return select(s == zero, all<T>(infinity), plane);
}

}  // namespace bondem
