// Facets that fail without softening, and become free facets of both cells, which lowers λ_p (`laws/cell.hpp`).
//
// The failure of a facet changes the stress of its two cells, and with it the force of all their other facets.
// Therefore the motion of the neighbours of both cells is postponed too (`passes/damage/pipeline.hpp`). The sums of
// forces kept for these cells are corrected in the order of facets: loads before the failure are subtracted, and
// loads after the failure are added. Facets are evaluated between the two passes over facets, when stresses are known
// and no cell has moved. The candidates are found with the stresses of the step before.
#include "cell_passes.hpp"

#include "../../registered.hpp"
#include "facet_removal.hpp"

namespace bondem {
namespace {

void postpone_with_neighbours(const ElasticFacets &facets, const FacetRelease &release, const Postponed &postponed,
                              Index p) {
    for_each_facet_of(release, p, [&](Index k) {
        const Index other = other_cell(facets, k, p);
        if (facets.integrity(k) > 0.0 && !is_postponed(postponed, other))
            postpone_element(postponed, other, postponed_for::neighbour);
    });
    postpone_element(postponed, p, postponed_for::own_facet);
}

// Evaluates marked facets by a criterion at the present stresses; postpones cells that lose facets, and their
// neighbours.
template <class Criterion>
void judge_facets(const Range &range, const Moving &all, const ElasticFacets &facets, const FacetRelease &release,
                  const Strengths &strengths, const Candidates &candidates, const Postponed &postponed) {
    for (Index b = 0; b < candidates.count.size(); b++) {
        Range block = range;
        block.block = b;
        judge(
            block, candidates, [&](Index k) { return facets.integrity(k) > 0.0; },
            [&](Index k) { return verdict_of<Criterion>(all.pose.data, facets, strengths, k); },
            [&](Index k) {
                postpone_with_neighbours(facets, release, postponed, facets.i(k));
                postpone_with_neighbours(facets, release, postponed, facets.j(k));
            });
    }
}

// Finds the index of every facet by a criterion, at the stresses in the poses.
template <class Criterion>
Index index_facets(Index, const Poses &all, const ElasticFacets &facets, const Strengths &strengths,
                   const FailureIndices &found) {
    for (Index k = 0; k < strengths.station.size(); k++)
        found.index(k) = facets.integrity(k) > 0.0 ? verdict_of<Criterion>(all.pose.data, facets, strengths, k).index : 0.0;
    return 0;
}

// Finds the index of every facet by a criterion, under tractions.
template <class Criterion>
Index index_tractions(Index, const LoadedTractions &loaded, const Strengths &strengths, const FailureIndices &found) {
    for (Index k = 0; k < strengths.station.size(); k++) {
        const Vector n = loaded.normal.row<const Vector>(k), t = loaded.traction.row<const Vector>(k);
        found.index(k) = verdict_of<Criterion>(-loaded.area(k) * t, n, strengths, k).index;
    }
    return 0;
}

void weigh(const ElasticFacets &facets, const FacetRelease &release, Index p) {
    release.weight(p) = weight_left(release, p, [&](Index k) { return facets.integrity(k); });
}

// Finds the dilatation of a cell, and updates its stress.
Dilated dilate(const Moving &all, const ElasticFacets &facets, const WallConstraints &walls, const FacetRelease &release,
              Index p) {
    const auto left = [&](Index k) { return facets.integrity(k); };
    const Dilated now = dilated(all, facets, walls, release, p, release.weight(p), left);
    all.pose(p, stress_column) = now.stress;
    return now;
}

// Finds the dilatation of both cells of facet k.
OfCells<Dilated> dilate_both(const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                             const FacetRelease &release, Index k) {
    OfCells<Dilated> found;
#pragma unroll 1
    for (Index end = 0; end < 2; end++)
        (end == 0 ? found.i : found.j) = dilate(all, facets, walls, release, end == 0 ? facets.i(k) : facets.j(k));
    return found;
}

// Lists the cells of facets that fail, then their neighbours.
void list_changed(const ElasticFacets &facets, const FacetRelease &release, const Candidates &candidates,
                  const Postponed &postponed) {
    using namespace postponed_for;
    Index &count = release.changes(0);
    count = 0;
    const auto list = [&](Index p, Byte as) {
        if (postponed.flag(p) != as) return;
        postponed.flag(p) = Byte(as + listed);
        release.changed(count++) = Short(p);
    };
    for_each_failing(candidates, [&](Index k, Index) {
        list(facets.i(k), own_facet);
        list(facets.j(k), own_facet);
    });
    const Index losing = count;
    for (Index c = 0; c < losing; c++) {
        const Index p = release.changed(c);
        for_each_facet_of(release, p, [&](Index k) { list(other_cell(facets, k, p), neighbour); });
    }
}

Removal break_facet(const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                    const FacetRelease &release, Index k) {
    const FailingFacet failing = failing_facet(all, facets, k, dilate_both(all, facets, walls, release, k));
    put_integrity(facets, k, 0.0);
    weigh(facets, release, facets.i(k));
    weigh(facets, release, facets.j(k));
    const OfCells<Dilated> left = dilate_both(all, facets, walls, release, k);
    return failing.without(left.i.energy + left.j.energy);
}

}  // namespace

#define BONDEM_CRITERION(_, name, Criterion)                                     \
    BONDEM_PASS_AS(judge_facets_by_##name, of_events, "ends pose pose.stress; adds flag", judge_facets<Criterion>)  \
    BONDEM_CALL_AS(index_facets_by_##name, "", index_facets<Criterion>)         \
    BONDEM_CALL_AS(index_tractions_by_##name, "", index_tractions<Criterion>)
BONDEM_FACET_CRITERIA(BONDEM_CRITERION, )
#undef BONDEM_CRITERION

void take_off_changing(double sign, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                       const FacetRelease &release, const Postponed &postponed, Index p) {
    const bool loses = loses_facet(postponed, p);
    double *const row = &postponed.sum(p, 0);
    for_each_facet_of(release, p, [&](Index k) {
        if (facets.integrity(k) <= 0.0 || !(loses || loses_facet(postponed, other_cell(facets, k, p)))) return;
        const FacetLoads<double> loads = loads_of(all.pose.data, facets, k);
        const bool is_i = facets.i(k) == Short(p);
        take_off(row, is_i ? -sign : sign, loads.force, sign, is_i ? loads.on_i : loads.on_j);
    });
    if (!loses) return;
    for_each_wall_of(release, p, [&](Index g) {
        const double *load = &walls.load(g, 0);
        take_off(row, sign, {load[0], load[1], load[2]}, sign, {load[3], load[4], load[5]});
    });
}

void add_changed(const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                 const FacetRelease &release, const Postponed &postponed, Index p) {
    if (loses_facet(postponed, p))
        for_each_wall_of(release, p, [&](Index g) { load_support(all.pose, all.rest, walls, g); });
    take_off_changing(-1.0, all, facets, walls, release, postponed, p);
}

// Lists the cells whose loads change, and subtracts the loads of their facets and walls from the kept sums.
void withdraw_facets(const Range &, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                     const FacetRelease &release, const Candidates &candidates, const Postponed &postponed) {
    if (!any_fails(candidates)) return;
    list_changed(facets, release, candidates, postponed);
    for (Index c = 0; c < release.changes(0); c++)
        take_off_changing(1.0, all, facets, walls, release, postponed, release.changed(c));
}
BONDEM_PASS(withdraw_facets, of_events, "own load; ends flag pose.stress; still pose; adds flag sum")

// Removes the facets that fail, and updates the stresses of their cells.
void break_facets(const Range &range, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                  const FacetRelease &release, const Candidates &candidates, const EventLog &log) {
    remove(range, candidates, log, [&](Index k) { return break_facet(all, facets, walls, release, k); });
}
BONDEM_PASS(break_facets, of_events, "ends arm given wall weight; around pose; adds pose.stress weight")

// Adds the loads of the remaining facets and of walls to the kept sums.
void restore_facets(const Range &, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                    const FacetRelease &release, const Candidates &candidates, const Postponed &postponed) {
    if (!any_fails(candidates)) return;
    for (Index c = 0; c < release.changes(0); c++)
        add_changed(all, facets, walls, release, postponed, release.changed(c));
}
BONDEM_PASS(restore_facets, of_events, "own arm base wall; ends flag pose.stress; still pose; adds sum load")

// Updates the forces of walls on the rows of their cells.
void renew_wall_rows(const Range &, const WallConstraints &walls, const Rows &rows, const Candidates &candidates) {
    if (any_fails(candidates)) set_rows(walls, rows);
}
BONDEM_PASS(renew_wall_rows, of_rows, "own load; writes support")

// Computes the weights of all cells from their unbroken facets at the start of a run.
Index weigh_cells(Index, const ElasticFacets &facets, const FacetRelease &release) {
    for (Index p = 0; p < release.whole.size(); p++) weigh(facets, release, p);
    return 0;
}
BONDEM_CALL(weigh_cells, "")

}  // namespace bondem
