// Breakage of facets of cells on a device: a thread marks and judges one facet; a thread each postpones the cells next to
// those of facets that fail, and exchanges the loads of one postponed cell; one thread removes the facets, in their order.
//
// The stages are those of the CPU (`passes/cells/facet_failure.cpp`), which has lists of cells where each thread here asks
// for what its cell is postponed.
#pragma once
#include "../passes/cells/facet_failure.hpp"
#include "../passes/cells/facet_neighbours.hpp"
#include "../passes/cells/facet_verdicts.hpp"
#include "breakage.hpp"
#include "cells.hpp"

namespace bondem {

// Marks facets by the stresses of the step before, as stresses of this step need all facets.
inline void dilate_marked_facet(Index k, const Moving &all, const ElasticFacets &facets, const LoadsOfBonds &to,
                                const FailureBounds &bounds, const BondMarks &marks) {
    const Row<double> i = gather(all.pose.data, facets.i(k)), j = gather(all.pose.data, facets.j(k));
    const double squared = pull_squared(i, j, ends_of(i, j, facets.period.data), FacetColumns(facets), k);
    marks.mark(k) = bounds.of_force * squared >= double(bounds.limit(k));
    dilate_facet(k, all, facets, to);
}

inline void judge_facet_by_mohr_coulomb(Index k, const DeviceSpan &span, const Moving &all, const ElasticFacets &facets,
                                        const Strengths &strengths, const BondMarks &marks, const Candidates &candidates,
                                        const Postponed &postponed) {
    if (marks.mark(k) == 0 || clock_of(span).first || !(facets.integrity(k) > 0.0)) return;
    if (!list_failing(k, verdict_of<MohrCoulomb>(all.pose.data, facets, strengths, k), candidates)) return;
    hold(postponed, facets.i(k), postponed_for::own_facet);
    hold(postponed, facets.j(k), postponed_for::own_facet);
}
inline void postpone_neighbour(Index p, const ElasticFacets &facets, const FacetRelease &release,
                               const Candidates &candidates, const Postponed &postponed) {
    if (!any_fails(candidates) || is_held(postponed, p)) return;
    bool neighbour = false;
    for_each_facet_of(release, p, [&](Index k) {
        neighbour |= facets.integrity(k) > 0.0 && loses_facet(postponed, other_cell(facets, k, p));
    });
    if (neighbour) hold(postponed, p, postponed_for::neighbour);
}

inline void withdraw_facets_of_cell(Index p, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                                    const FacetRelease &release, const Candidates &candidates,
                                    const Postponed &postponed) {
    if (any_fails(candidates) && is_held(postponed, p))
        take_off_changing(1.0, all, facets, walls, release, postponed, p);
}
inline void break_all_facets(Index, const DeviceSpan &span, const Moving &all, const ElasticFacets &facets,
                             const WallConstraints &walls, const FacetRelease &release, const Candidates &candidates,
                             const EventLog &log) {
    break_facets(turn_of(span, 0), all, facets, walls, release, candidates, log);
}
inline void restore_facets_of_cell(Index p, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                                   const FacetRelease &release, const Candidates &candidates,
                                   const Postponed &postponed) {
    if (any_fails(candidates) && is_held(postponed, p)) add_changed(all, facets, walls, release, postponed, p);
}
inline void renew_wall_row(Index r, const WallConstraints &walls, const RowOrder &order, const Rows &rows,
                           const Candidates &candidates) {
    if (any_fails(candidates)) sum_row(r, walls, order, rows);
}

}  // namespace bondem
