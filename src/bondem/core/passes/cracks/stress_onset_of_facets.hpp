// Facets that begin to crack by a function of the stress, such as the cone of Drucker and Prager.
//
// Facets in tension are candidates. For a candidate the function evaluates a stress σ* (`laws/agreed_stress.hpp`),
// with the opening part of bending added to the normal traction. σ* is multiplied by the strength without scatter
// over that of the facet. A facet fails if the index, the value of the function, is at least 1. The function then
// also evaluates the mean stress of the two cells, raised by bending. The largest principal stress of this mean over
// its index is the strength in the direction in which the facet cracks.
//
// Facets of a cell without cracks are evaluated only if the stress of the cell is near to the criterion. The stress
// is near if it reaches the criterion at a reduced strength, by itself or with an added tension from all sides. This
// tension allows for the difference between σ* and the stress, and for the bending of facets. For a function of the
// user, the stress is near if its size √(σ:σ) with the added tension is large enough.
#pragma once
#include "../../laws/agreed_stress.hpp"
#include "../../tables/stress_onset_tables.hpp"
#include "../cells/facets.hpp"
#include "../damage/stress_criteria.hpp"
#include "crack_places.hpp"
#include "stress_state.hpp"

namespace bondem {

// ---- cells

// Tension from all sides that facets of a cell may have beyond its stress [Pa].
inline double more_tension(const StressesOfCells &stresses, Index p, const Stress<double> &s) {
    constexpr double beyond = 0.2;  // how far σ* of a facet may be beyond the stresses of its cells, over their size
    const double bent = root(positive(stresses.tensor(p, tensor_column::bending))) + least(trace(s) / 3.0, 0.0);
    return beyond * root(square_of(s)) + positive(bent);
}

// Sets `judged` of cell p to 1 if its facets are evaluated, else to 0.
template <class Criterion>
inline void judge_cell_by(const StressesOfCells &stresses, const StressFunction &by, const CandidateFacets &onset,
                          const CrackOnset &cracks, Index p) {
    const double scale = onset.tension / onset.hot;
    const auto reaches = [&](const Stress<double> &s) {
        if (scale * root(square_of(s)) < onset.least) return false;
        return !(Criterion::index(scale * s, by.parameter.data) < 1.0);
    };
    const Stress<double> s = tensor_of(stresses, p);
    const double more = more_tension(stresses, p, s);
    cracks.judged(p) = cracks.cracked(p) != 0 || reaches(s) ||
                       reaches({s.xx + more, s.yy + more, s.zz + more, s.xy, s.xz, s.yz});
}
inline void judge_cell_of_user(const StressesOfCells &stresses, const CandidateFacets &onset, const CrackOnset &cracks,
                               Index p) {
    constexpr double root_three = 1.7320508075688772;
    const Stress<double> s = tensor_of(stresses, p);
    const double size = root(square_of(s)) + root_three * more_tension(stresses, p, s);
    cracks.judged(p) = cracks.cracked(p) != 0 || onset.tension / onset.hot * size >= onset.least;
}

// ---- facets

// A facet in space, with its opening by bending.
struct JudgedFacet {
    Vector normal;
    Stress<double> mean;
    double opened;  // by bending, beyond the pressure of its cells [Pa]

    JudgedFacet(const Moving &all, const ElasticFacets &facets, const FacetForces &stored,
                const StressesOfCells &stresses, Index k) {
        const Ends<double> ends = ends_of(all.pose.data, facets, k);
        normal = present_normal(ends, normal_of(facets, k));
        mean = mean_of(tensor_of(stresses, facets.i(k)), tensor_of(stresses, facets.j(k)));
        const double bent = bending_traction(ends, stored.bends(k), FacetColumns(facets).stiffness(k, 1.0).H);
        opened = opened_at_most(bent, mean) > 0.0 ? positive(bent - largest_pressure(principal(mean))) : 0.0;
    }
};

// True if the stresses of a facet are far below the criterion, by bounds that need no angle.
inline bool is_far_below(const StressesOfCells &stresses, const CandidateFacets &onset, Index i, Index j, Index k, Vector t) {
    constexpr double root_two = 1.4142135623730951;
    constexpr double near_bound = 0.8;  // share of the bound that stresses have to reach; T_b in it is that of the last step
    const double size = 0.5 * (stresses.tensor(i, tensor_column::size) + stresses.tensor(j, tensor_column::size));
    const double bends = least(stresses.tensor(i, tensor_column::bending), stresses.tensor(j, tensor_column::bending));
    const double bound = (1.0 + root_two) * size + root_two * (length(t) + root(positive(bends)));
    return onset.scale(k) * bound < near_bound * onset.least;
}

// Calls on(σ*) if facet k is a candidate, with σ* times f_t without scatter over that of the facet.
template <class On>
inline void with_candidate(const Moving &all, const ElasticFacets &facets, const FacetForces &stored,
                           const StressesOfCells &stresses, const CandidateFacets &onset, Index k, On on) {
    const Vector t = (1.0 / onset.area(k)) * Vector{stored.force(0, k), stored.force(1, k), stored.force(2, k)};
    if (is_far_below(stresses, onset, facets.i(k), facets.j(k), k, t)) return;
    const JudgedFacet facet(all, facets, stored, stresses, k);
    const PulledTraction<double> pull = pulled_traction(t, facet.normal, facet.opened);
    if (pull.along <= 0.0) return;
    const Stress<double> s = agreed_stress(facet.mean, facet.normal, pull.t);
    if (onset.scale(k) * root(square_of(s)) < onset.least) return;
    on(onset.scale(k) * s);
}
// The stress whose index gives the strength of a facet that fails.
inline Stress<double> stress_along(const Moving &all, const ElasticFacets &facets, const FacetForces &stored,
                                   const StressesOfCells &stresses, const CandidateFacets &onset, Index k) {
    const JudgedFacet facet(all, facets, stored, stresses, k);
    return onset.scale(k) * bent_stress(facet.mean, facet.normal, facet.opened);
}
// Stores the strength of the facet of candidate c.
inline void keep_strength_along(const CandidateFacets &onset, Index c) {
    const double largest = largest_of(principal(stress_in(onset, c)));
    const Index k = onset.bond(c);
    const double index = onset.found(c);
    // far below the criterion the index does not determine a strength
    onset.along(k) = index > 0.5 && largest > 0.0 ? largest / (onset.scale(k) * index) : onset.tension / onset.scale(k);
}

}  // namespace bondem
