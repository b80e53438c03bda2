// Transitions of a crack between `active` (passes over cracks compute its force), `resting` (a facet of reduced
// stiffness) and `parted` (faces apart, no force). `crack_states.cpp` has the conditions.
#pragma once
#include "single_cracks.hpp"

namespace bondem {

// Sets the slip in the plane of the crack to the present place of its faces, where the spring of friction has no
// force. The slip along the normal of the crack stays.
inline void rest_friction(CrackStateRow &state, const SingleCrack &one) {
    const Vector across = one.now.across(), beside = minus(one.now.gap, dot(one.now.gap, across), across);
    const Vector slipped = turned_by(one.ends.i, Vector{state.slip[0], state.slip[1], state.slip[2]});
    const Vector slip = turned_by(inverse(one.ends.i), plus(beside, dot(slipped, across), across));
    for (int d = 0; d < 3; d++) state.slip[d] = slip[d], state.rub[d] = 0.0;
}
// Makes the resting crack of facet k active: status, flag at place e of the list of active cracks, halves, and the
// spring of friction without force. The caller writes the list.
inline void begin_treating(const SingleCrack &one, const ElasticFacets &facets, const CohesiveCracks &cracks,
                           const CrackLists &lists, Index k, Index e) {
    treat(facets, cracks, k, crack::active);
    lists.flag(e) = crack::unchanged;
    put_halves_of(lists, k, one.stiffness, one.now);
    state_of(cracks, k).fresh = 1.0;
    CrackPastRow &past = past_of(cracks, k);
    for (int d = 0; d < 4; d++) past.left[d] = frame_of(cracks, k).left[d], past.root[d] = 0.0;
    rest_friction(state_of(cracks, k), one);
}
// Sets a resting crack to `parted`; it never softens again.
inline void part_resting(const ElasticFacets &facets, const CohesiveCracks &cracks, Index k) {
    treat(facets, cracks, k, crack::parted);
    shape_of(cracks, k).top = infinity;
}
// Sets the active crack of facet k to `resting` or `parted`, and clears its slip, force and halves.
inline void end_treating(const ElasticFacets &facets, const CohesiveCracks &cracks, const CrackLists &lists, Index k,
                         int status) {
    treat(facets, cracks, k, status);
    // faces that were far apart touch as facets: along their own normal, not that of the crack
    const double *const n = face_of(cracks, k).normal;
    put_axes(cracks, k, {1.0, 0.0, 0.0, 0.0}, axes_along({n[0], n[1], n[2]}));
    if (cracks.integrity(k) == 0.0) shape_of(cracks, k).top = infinity;
    CrackStateRow &state = state_of(cracks, k);
    for (int d = 0; d < 3; d++) state.slip[d] = state.rub[d] = 0.0;
    for (Index d = 0; d < 4; d++) cracks.pull(k, d) = 0.0;
    for (Index side = 0; side < 2; side++) clear_half(lists, half_of(k, side));
}

// ---- parting

// Change of the stress of cell p, of a given weight, with V θ if its half `without` is open [Pa/m³]. removed(h) is
// true for halves of cracks that have ceased to be active earlier in this step.
template <class Removed>
inline double stiffness_without(const Moving &all, const CrackLists &lists, double weight, Short p, Index without,
                                Removed removed) {
    double softness = 0.0;
    for (Index h = lists.head(p); h > 0; h = lists.next(h)) {
        if (removed(h)) continue;
        SwellingHalf<double> half = half_at(lists, h);
        if (h == without) {  // open along all directions, which have lost everything
            const double *const g = half.along;
            softness += half.loose[0] * half.inverse * (g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
        } else {
            softness += swelling_of(half, all.pose(p, stress_column)).softness;
        }
    }
    return weight / (1.0 + weight * softness);
}

// Energy lost as the faces of a broken facet part [J]: for each half that of its pressing force, less the elastic
// energy that its cell gains from the change of its stress; and that of the spring of friction.
//
//     stiffness(p, number)    change of the stress of cell p with V θ, with the half of that number open [Pa/m³]
template <class Stiffness>
inline double energy_of_parting(const SingleCrack &one, const ElasticFacets &facets, const CohesiveCracks &cracks,
                                const CrackLists &lists, Index at, Stiffness stiffness) {
    const double *const rub = state_of(cracks, at).rub;
    const double k = one.stiffness.k, w = one.stiffness.part;
    const CrackHalves<double> half = crack_halves(one.stiffness, one.now, one.stress);
    double lost = friction_energy(k, 0.0, Vector{rub[0], rub[1], rub[2]});
    const auto add = [&](Short p, double part, double press, Index number) {
        if (!(press < 0.0)) return;
        const double more = press / k * half_at(lists, number).along[0];
        lost += 0.5 * (part * press * press / k - more * more * stiffness(p, number));
    };
    add(facets.i(at), w, half.i.press(), half_of(at, 0));
    add(facets.j(at), 1.0 - w, half.j.press(), half_of(at, 1));
    return lost;
}

}  // namespace bondem
