// Failure of facets of cells on a GPU, in the same stages as on the CPU (`passes/cells/facet_failure.cpp`). Passes
// with one thread per facet mark facets near failure, evaluate marked facets, and record events. Passes with one
// thread per cell remove failed facets, and change the loads of cells that lose facets and of their neighbours.
//
// Cells that lose facets and their neighbours start the next step later than the others. A flag marks such a cell;
// the CPU has lists of such cells instead. Facets that fail in the same step are removed in the order of their
// numbers. The energy that a facet releases is therefore computed without the facets removed before.
#pragma once
#include "../passes/cells/cell_passes.hpp"
#include "../passes/cells/facet_removal.hpp"
#include "breakage.hpp"
#include "cells.hpp"

namespace bondem {

// Marks facets by the stresses of the previous step, because stresses of this step need all facets.
inline void dilate_marked_facet(Index k, const Moving &all, const ElasticFacets &facets, const LoadsOfBonds &to,
                                const FailureBounds &bounds, const BondMarks &marks) {
    const Row<double> i = gather(all.pose.data, facets.i(k)), j = gather(all.pose.data, facets.j(k));
    const double squared = pull_squared(i, j, ends_of(i, j, facets.period.data), FacetColumns(facets), k);
    marks.mark(k) = bounds.of_force * squared >= double(bounds.limit(k)) ? marked::near : 0;
    dilate_facet(k, all, facets, to);
}

template <class Criterion>
BONDEM_INLINE void judge_facet(Index k, const DeviceSpan &span, const Moving &all, const ElasticFacets &facets,
                               const Strengths &strengths, const BondMarks &marks, const Candidates &candidates,
                               const Postponed &postponed) {
    if (marks.mark(k) == 0 || clock_of(span).first || !(facets.integrity(k) > 0.0)) return;
    if (!list_failing(k, verdict_of<Criterion>(all.pose.data, facets, strengths, k), marks, candidates)) return;
    postpone_element(postponed, facets.i(k), postponed_for::own_facet);
    postpone_element(postponed, facets.j(k), postponed_for::own_facet);
}
#define BONDEM_JUDGE(_, name, Criterion) constexpr auto judge_facet_by_##name = as<&judge_facet<Criterion>>;
BONDEM_FACET_CRITERIA(BONDEM_JUDGE, )
#undef BONDEM_JUDGE

inline void postpone_neighbour(Index p, const ElasticFacets &facets, const FacetRelease &release,
                               const Candidates &candidates, const Postponed &postponed) {
    if (!any_fails(candidates) || is_postponed(postponed, p)) return;
    bool neighbour = false;
    for_each_facet_of(release, p, [&](Index k) {
        neighbour |= facets.integrity(k) > 0.0 && loses_facet(postponed, other_cell(facets, k, p));
    });
    if (neighbour) postpone_element(postponed, p, postponed_for::neighbour);
}

inline void withdraw_facets_of_cell(Index p, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                                    const FacetRelease &release, const Candidates &candidates,
                                    const Postponed &postponed) {
    if (any_fails(candidates) && is_postponed(postponed, p))
        take_off_changing(1.0, all, facets, walls, release, postponed, p);
}
// Dilatation of both cells of facet k without the failed facets below a number.
BONDEM_INLINE OfCells<Dilated> dilated_cells(const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                                             const FacetRelease &release, const BondMarks &marks, Index k, Index up_to) {
    const auto left = [&](Index other) {
        return other < up_to && marks.mark(other) == marked::fails ? 0.0 : facets.integrity(other);
    };
    OfCells<Dilated> found;
#pragma unroll 1
    for (Index end = 0; end < 2; end++) {
        const Index p = end == 0 ? facets.i(k) : facets.j(k);
        (end == 0 ? found.i : found.j) = dilated(all, facets, walls, release, p, weight_left(release, p, left), left);
    }
    return found;
}
// Writes the event of failed facet number e; the facet keeps its integrity until all energies are known.
inline void write_facet_failure(Index e, const DeviceSpan &span, const Moving &all, const ElasticFacets &facets,
                                const WallConstraints &walls, const FacetRelease &release, const BondMarks &marks,
                                const Candidates &candidates, const EventLog &log) {
    if (e >= candidates.count(0)) return;
    const Index k = candidates.marked(e);
    OfCells<Dilated> cells[2];
#pragma unroll 1
    for (Index removed = 0; removed < 2; removed++)
        cells[removed] = dilated_cells(all, facets, walls, release, marks, k, k + removed);
    const FailingFacet failing = failing_facet(all, facets, k, cells[0]);
    write_failure(e, span, candidates, log, failing.without(cells[1].i.energy + cells[1].j.energy));
}
// Sets weight and stress of cell p without its failed facets, and the integrity of failed facets with i = p to zero.
inline void end_facets_of_cell(Index p, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                               const FacetRelease &release, const BondMarks &marks, const Candidates &candidates) {
    if (!any_fails(candidates)) return;
    const auto fails = [&](Index k) { return marks.mark(k) == marked::fails; };
    bool loses = false;
    for_each_facet_of(release, p, [&](Index k) { loses |= fails(k); });
    if (!loses) return;
    const auto left = [&](Index k) { return fails(k) ? 0.0 : facets.integrity(k); };
    release.weight(p) = weight_left(release, p, left);
    all.pose(p, stress_column) = dilated(all, facets, walls, release, p, release.weight(p), left).stress;
    for_each_facet_of(release, p, [&](Index k) {
        if (fails(k) && facets.i(k) == Short(p)) put_integrity(facets, k, 0.0);
    });
}
inline void restore_facets_of_cell(Index p, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                                   const FacetRelease &release, const Candidates &candidates,
                                   const Postponed &postponed) {
    if (any_fails(candidates) && is_postponed(postponed, p)) add_changed(all, facets, walls, release, postponed, p);
}
inline void renew_wall_row(Index r, const WallConstraints &walls, const RowOrder &order, const Rows &rows,
                           const Candidates &candidates) {
    if (any_fails(candidates)) sum_row(r, walls, order, rows);
}

}  // namespace bondem
