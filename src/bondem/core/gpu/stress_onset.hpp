// Facets that begin to crack by a failure criterion that is a function of the stress, on a GPU. Passes have one
// thread per cell, facet or candidate.
//
// Candidates are facets in tension beside a cell whose stress is near the criterion. Candidates are listed in any
// order. The function is evaluated to find candidates that fail; the facet number of candidates that do not fail is
// set to -1. For candidates that fail, the function is evaluated again, with the mean stress of both cells, to find
// the strength in the direction of their cracks. A user's function is evaluated on the CPU between two passes.
#pragma once
#include "../laws/criteria/cone.hpp"
#include "../laws/criteria/mean_stress.hpp"
#include "../passes/cracks/stress_onset_of_facets.hpp"
#include "ranges.hpp"

namespace bondem {

constexpr Index does_not_fail = -1;

template <class Criterion>
BONDEM_INLINE void judge_one_cell(Index p, const DeviceSpan &span, const StressesOfCells &stresses,
                                  const StressFunction &by, const CandidateFacets &onset, const CrackOnset &cracks) {
    if (clock_of(span).dt > 0.0) judge_cell_by<Criterion>(stresses, by, onset, cracks, p);
}
constexpr auto judge_cell_by_mean_stress = as<&judge_one_cell<MeanStress>>;
constexpr auto judge_cell_by_cone = as<&judge_one_cell<Cone>>;
inline void judge_cell_by_size(Index p, const DeviceSpan &span, const StressesOfCells &stresses,
                               const CandidateFacets &onset, const CrackOnset &cracks) {
    if (clock_of(span).dt > 0.0) judge_cell_of_user(stresses, onset, cracks, p);
}

inline void clear_candidates(Index, const CandidateFacets &onset) { onset.number(0) = 0; }
inline void find_stress_candidate(Index k, const DeviceSpan &span, const Moving &all, const ElasticFacets &facets,
                                  const FacetForces &stored, const StressesOfCells &stresses, const CrackOnset &cracks,
                                  const CandidateFacets &onset) {
    const Byte judged = most(cracks.judged(facets.i(k)), cracks.judged(facets.j(k)));
    if (!(clock_of(span).dt > 0.0) || judged == 0 || cracks.listed(k) != 0) return;
    if (judged == 2) {
        cracks.marked(k) = 2;
        count_up(cracks.found(k / bonds_of_portion));
        return;
    }
    with_candidate(all, facets, stored, stresses, onset, k, [&](const Stress<double> &s) {
        write_candidate(onset, count_up(onset.number(0)), k, s);
    });
}

template <class Criterion>
BONDEM_INLINE void index_candidate(Index c, const StressCandidates &candidates, const StressFunction &by) {
    if (c < candidates.number(0) && candidates.bond(c) != does_not_fail)
        candidates.found(c) = Criterion::index(stress_in(candidates, c), by.parameter.data);
}
constexpr auto index_candidate_by_mean_stress = as<&index_candidate<MeanStress>>;
constexpr auto index_candidate_by_cone = as<&index_candidate<Cone>>;

inline void mark_failing_facet(Index c, const Moving &all, const ElasticFacets &facets, const FacetForces &stored,
                               const StressesOfCells &stresses, const CrackOnset &cracks, const CandidateFacets &onset) {
    if (c >= onset.number(0)) return;
    const Index k = onset.bond(c);
    if (onset.found(c) < 1.0) {
        onset.bond(c) = does_not_fail;
        return;
    }
    cracks.marked(k) = 1;
    count_up(cracks.found(k / bonds_of_portion));
    write_candidate(onset, c, k, stress_along(all, facets, stored, stresses, onset, k));
}
inline void find_strength_along(Index c, const CandidateFacets &onset) {
    if (c < onset.number(0) && onset.bond(c) != does_not_fail) keep_strength_along(onset, c);
}

}  // namespace bondem
