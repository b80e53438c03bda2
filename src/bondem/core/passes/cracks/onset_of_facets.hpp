// Conditions for facets to begin to crack. Facets of a material plane begin by their own traction (`plane_begins`).
// Any other facet has to be in tension or shear, and σ1 of a stress σ* has to reach its strength.
//
// σ* is the mean stress σ of both cells, corrected to agree with the traction t of the facet
// (`laws/agreed_stress.hpp`). The opening part of bending (`laws/softening.hpp`) is first added to the normal part of
// t. The bound (1 + √2) |σ| + √2 (|t| + T_b) of σ1, with |σ|² = σ:σ and the rms T_b of the tractions by bending,
// excludes most facets before σ* is computed.
#pragma once
#include "../../laws/agreed_stress.hpp"
#include "single_cracks.hpp"

namespace bondem {

// A facet in space: its normal, the mean stress of its cells, and T_b.
template <class T> struct FacetInBody {
    Vector3<T> normal;
    Symmetric3<T> mean;
    T bent;
};

// True if a facet of traction t begins to crack; `bent` is the opening traction of bending.
template <class T>
BONDEM_INLINE Mask<T> reaches_strength(Vector3<T> t, Vector3<T> n, const Symmetric3<T> &mean, T bent, T strength) {
    const PulledTraction<T> pull = pulled_traction(t, n, bent);
    const T along = pull.along, zero = {};
    // the traction of a pressed facet has a principal stress beyond the strength by itself
    const Mask<T> sheared = dot(pull.t, pull.t) - along * along >= strength * (strength - along);
    return ((along > zero) | sheared) & opposite(is_below(agreed_stress(mean, n, pull.t), strength));
}
// True if a facet begins to crack. A bound is compared first: `size` is the sum of |σ| of both cells, `bends` the
// lesser of their Σ T_b² in the last step. place() returns the facet, and is called only if the bound is reached.
template <class T, class Place>
BONDEM_INLINE Mask<T> begins_to_crack(Vector3<T> t, T size, T bends, T strength, Place place) {
    constexpr double root_two = 1.4142135623730951;
    constexpr double near_strength = 0.8;  // share of the strength that the bound has to reach
    const T bound = (0.5 * (1.0 + root_two)) * size + root_two * (root(dot(t, t)) + root(positive(bends)));
    Mask<T> begin = bound >= near_strength * strength;
    if (!any(begin)) return begin;
    const FacetInBody<T> at = place();
    const T most_open = opened_at_most(at.bent, at.mean);
    // an upper bound of the opening traction; a larger one never prevents cracking
    begin &= reaches_strength(t, at.normal, at.mean, most_open, strength);
    if (!any(begin)) return begin;
    const T open = select(most_open > T{}, positive(T(at.bent - largest_pressure(principal(at.mean)))), T{});
    begin &= reaches_strength(t, at.normal, at.mean, open, strength);
    return begin;
}

// Facet k in space: its normal, the mean stress of its cells, and T_b.
inline FacetInBody<double> facet_in_body(const Moving &all, const ElasticFacets &facets, const FacetForces &stored,
                                         const Symmetric3<double> &mean, Vector normal, Index k) {
    const Ends<double> ends = ends_of(all.pose.data, facets, k);
    const Symmetric3<double> H = FacetColumns(facets).stiffness(k, 1.0).H;
    return {turned_by(ends.i, normal), mean, bending_traction(ends, stored.bends(k), H)};
}
inline Vector traction_of(const FacetForces &stored, const FacetStrengths &strengths, Index k) {
    const double one = 1.0 / strengths.area(k);
    return {one * stored.force(0, k), one * stored.force(1, k), one * stored.force(2, k)};
}

// True if facet k of a material plane begins to crack.
inline bool plane_begins(const Moving &all, const ElasticFacets &facets, const FacetForces &stored,
                         const FacetStrengths &strengths, Index k) {
    const Ends<double> ends = ends_of(all.pose.data, facets, k);
    const double bent = bending_traction(ends, stored.bends(k), FacetColumns(facets).stiffness(k, 1.0).H);
    const Softening<double> facet = {strengths.strength(k), strengths.brittleness(k)};
    const PlaneStrength<double> plane = {strengths.cohesion(k), strengths.slip_brittleness(k), strengths.friction(k)};
    const CurveShape curve = {strengths.kink, strengths.steep};
    const Vector n = present_normal(ends, normal_of(facets, k));
    return left_on_plane(1.0, traction_of(stored, strengths, k), n, bent, facet, plane, curve) < 1.0;
}

}  // namespace bondem
