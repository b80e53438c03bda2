// Cracks that change between being treated one by one, being at rest, and having parted.
#pragma once
#include "single_cracks.hpp"

namespace bondem {

// Treats a resting crack one by one, at a place of the list: its halves, and the slip as it is now.
inline void begin_treating(const SingleCrack &one, const ElasticFacets &facets, const CohesiveCracks &cracks,
                           const CrackLists &lists, Index k, Index e) {
    treat(facets, cracks, k, crack::active);
    lists.flag(e) = crack::unchanged;
    const CrackFaces<double> &at = one.now.faces;
    const SwellingHalves<double> half = swelling_halves(one.stiffness, one.s, at);
    lists.half.row<Row<double>>(2 * e + 1) = row_of(half.i);
    lists.half.row<Row<double>>(2 * e + 2) = row_of(half.j);
    CrackStateRow &state = state_of(cracks, k);
    state.before = crack::fresh;
    const Vector slip = turned_by(inverse(one.ends.i), minus(at.gap, dot(at.gap, at.normal), at.normal));
    for (int d = 0; d < 3; d++) state.slip[d] = slip[d];
}
// Faces of a crack at rest have parted.
inline void part_resting(const ElasticFacets &facets, const CohesiveCracks &cracks, Index k) {
    treat(facets, cracks, k, crack::parted);
    shape_of(cracks, k).top = infinity;
}
// The crack of facet k, at place e, is no longer treated one by one.
inline void end_treating(const ElasticFacets &facets, const CohesiveCracks &cracks, const CrackLists &lists, Index k,
                         Index e, int status) {
    treat(facets, cracks, k, status);
    if (face_of(cracks, k).integrity == 0.0) shape_of(cracks, k).top = infinity;
    CrackStateRow &state = state_of(cracks, k);
    for (int d = 0; d < 3; d++) state.slip[d] = state.rub[d] = 0.0;
    for (Index d = 0; d < 4; d++) cracks.pull(k, d) = 0.0;
    clear_half(lists, 2 * e + 1);
    clear_half(lists, 2 * e + 2);
}

// ---- parting

// How much the stress of cell p, of this weight, changes with V θ, with one of its halves open [Pa/m³]. Halves that
// `gone` names are those of cracks that have left the list before.
template <class Gone>
inline double stiffness_without(const Moving &all, const CrackLists &lists, double weight, Short p, Index without,
                                Gone gone) {
    double softness = 0.0;
    for (Index h = lists.head(p); h > 0; h = lists.node(h, 0)) {
        if (gone(h)) continue;
        const SwellingHalf<double> half = half_of(lists.half.row<Row<double>>(h));
        const bool closed = h != without && half.closed + all.pose(p, stress_column) * half.pressed < 0.0;
        softness += half.loose * (closed ? half.square - half.pressed * half.along : half.square);
    }
    return weight / (1.0 + weight * softness);
}

// Energy of a broken facet whose faces no longer press on each other: of each half that of the force that presses,
// less the elastic energy that its cell gains from the change of its stress; and that of friction [J].
//
//     stiffness(p, number)    how much the stress of a cell changes with V θ, with the half of that number open
template <class Stiffness>
inline double energy_of_parting(const SingleCrack &one, const ElasticFacets &facets, const CohesiveCracks &cracks,
                                const CrackLists &lists, Index at, Index e, Stiffness stiffness) {
    const double *const rub = state_of(cracks, at).rub;
    const double k = one.stiffness.k, w = one.stiffness.part;
    const CrackHalves<double> half = crack_halves(one.stiffness, one.now.faces, one.stress);
    double lost = friction_energy(k, 0.0, Vector{rub[0], rub[1], rub[2]});
    const auto add = [&](Short p, double part, double press, Index number) {
        if (!(press < 0.0)) return;
        const double more = press / k * lists.half(number, 3);
        lost += 0.5 * (part * press * press / k - more * more * stiffness(p, number));
    };
    add(facets.i(at), w, half.i.press, 2 * e + 1);
    add(facets.j(at), 1.0 - w, half.j.press, 2 * e + 2);
    return lost;
}

}  // namespace bondem
