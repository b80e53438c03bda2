// Changes of the status of cracks in a step (`active`, `resting` or `parted`), their softening, and their slip.
//
// Passes over cracks compute the force of an active crack. A broken crack, or a crack with the same integrity along
// all axes, equals a facet of reduced stiffness to rounding while it is open and does not soften. Such a crack is
// resting: passes over facets compute its force. An active crack becomes resting below 0.9 of the traction at which
// it softens. A resting crack becomes active at 0.98 of this traction, or when it closes. A broken crack whose faces
// no longer face each other is parted: it transmits no force, and its cells touch like other cells.
#include "../../registered.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/crack_tables.hpp"
#include "crack_passes.hpp"
#include "resting_cracks.hpp"
#include "slides.hpp"
#include "softening_cracks.hpp"

namespace bondem {
namespace {

// Adds the contribution of facet k, times a sign, to V θ of its cells without active cracks; updates their weights.
void hand_over(const SingleCrack &one, const ElasticFacets &facets, const CellDilatation &cells,
               const CellSlack &slack,
               const CohesiveCracks &cracks, const CrackLists &lists, Index k, double sign) {
    const Short i = facets.i(k), j = facets.j(k);
    const double s = sign * cracks.integrity(k);
    const CrackFaces<double> &at = one.now;
    lists.base(i) += s * dot(at.share_i, at.gap);
    lists.base(j) += s * dot(at.share_j, at.gap);
    weigh_cracked(cells, slack, cracks, i);
    weigh_cracked(cells, slack, cracks, j);
    lists.outdated(i) = lists.outdated(j) = 1;
}

// Inserts a half into the list of its cell, which descends by the number of the half.
void insert_half(const CrackLists &lists, Short p, Index half) {
    if (lists.head(p) == 0) lists.cell(lists.size(list_count::cells)++) = p;
    Index before = 0, next = lists.head(p);
    while (next > half) {
        before = next;
        next = lists.next(next);
    }
    lists.next(half) = int32_t(next);
    (before == 0 ? lists.head(p) : lists.next(before)) = int32_t(half);
}

// Prefetches the rows of halves in the order in which the cells first … last - 1 of a list read them.
struct HalvesAhead {
    const CrackLists &lists;
    Index q, last, half = 0;

    HalvesAhead(const CrackLists &lists, Index first, Index last) : lists(lists), q(first), last(last) {
        constexpr int ahead = 12;
        for (int n = 0; n < ahead; n++) ask();
    }
    BONDEM_INLINE void ask() {
        if (half == 0) {
            if (q == last) return;
            half = lists.head.data[lists.cell.data[q++]];
        }
        prefetch(lists.half.data + 16 * half);
        prefetch(lists.half.data + 16 * half + 8);
        half = lists.next.data[half];
    }
};

// Makes a resting crack active. In this step the crack is the last one in the list of active cracks; the next step
// lists all of them in the order of facets.
void wake(const SingleCrack &one, const ElasticFacets &facets, const CohesiveCracks &cracks, const CrackLists &lists,
          Index k) {
    const Index e = lists.size(list_count::treated)++;
    lists.treated(e) = k;
    lists.treated_i(e) = facets.i(k);
    lists.treated_j(e) = facets.j(k);
    if (e % crack::of_portion == 0) lists.flagged(e / crack::of_portion) = 0;
    begin_treating(one, facets, cracks, lists, k, e);
    insert_half(lists, facets.i(k), half_of(k, 0));
    insert_half(lists, facets.j(k), half_of(k, 1));
}

}  // namespace

// Finds the resting cracks that are about to soften or close.
void watch_resting_cracks(const Range &range, const Moving &all, const ElasticFacets &facets,
                          const FacetStrengths &strengths, const CohesiveCracks &cracks, const CrackLists &lists) {
    if (!(range.clock.dt > 0.0)) return;
    const Index count = lists.size(list_count::resting);
    over_places(range, count, [&](Index first, Index last, Index portion) {
        lists.woken(portion) = 0;
        for (Index e = first; e < last; e++) lists.waking(e) = crack::unchanged;
        for (Index e = first; e < last; e += lanes)
            watch_each(CrackGroup{lists.resting, lists.resting_i, lists.resting_j, e, count}, all,
                       facets.period.data, strengths, cracks, lists, portion);
    });
}
BONDEM_PASS(watch_resting_cracks, of_cracks, "ends pose pose.stress")

// Makes resting cracks active if they are about to soften or close; parts those whose faces have turned away.
void wake_cracks(const Range &range, const Moving &all, const ElasticFacets &facets, const CellDilatation &cells,
                 const CellSlack &slack, const CohesiveCracks &cracks, const CrackLists &lists) {
    if (!(range.clock.dt > 0.0)) return;
    const Index count = lists.size(list_count::resting), before = lists.size(list_count::treated);
    for (Index q = 0; q < portions(count, crack::of_portion); q++) {
        if (lists.woken(q) == 0) continue;
        for (Index e = q * crack::of_portion; e < least(count, (q + 1) * crack::of_portion); e++) {
            if (lists.waking(e) != crack::wakes) continue;
            const Index k = lists.resting(e);
            const SingleCrack one(all.pose, facets, cracks, k);
            if (one.is_separate() && turned_away(one.now, one.area, slide_of(cracks, k))) {
                part_resting(facets, cracks, k);
                lists.parted(lists.size(list_count::parted)++) = k;
                continue;
            }
            wake(one, facets, cracks, lists, k);
            hand_over(one, facets, cells, slack, cracks, lists, k, -1.0);
        }
    }
    if (lists.size(list_count::treated) > before) fill_treated(lists);
}
BONDEM_PASS(wake_cracks, of_cracks, "ends pose; adds CellDilatation.weight base half outdated")

// Lowers the integrities of cracks, and finds cracks that become resting.
void soften_cracks(const Range &range, const Moving &all, const ElasticFacets &facets,
                   const FacetStrengths &strengths, const StressesOfCells &stresses, const CohesiveCracks &cracks,
                   const CrackLists &lists) {
    if (!(range.clock.dt > 0.0)) return;
    const Index count = lists.size(list_count::treated);
    over_places(range, count, [&](Index first, Index last, Index portion) {
        for (Index e = first; e < last; e += lanes)
            soften_each(CrackGroup{lists.treated, lists.treated_i, lists.treated_j, e, count}, all, facets, strengths,
                        stresses, cracks, lists, portion);
    });
}
BONDEM_PASS(soften_cracks, of_cracks, "ends pose pose.stress tensor; adds half")

// Sums the forces of the cracks of each cell, and finds the slip of their faces under these forces.
void sum_cracks(const Range &range, const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists) {
    const bool changes = range.clock.dt > 0.0;
    over_places(range, lists.size(list_count::cells), [&](Index first, Index last, Index) {
        HalvesAhead ahead(lists, first, last);
        for (Index q = first; q < last; q++) {
            const Short p = lists.cell(q);
            sum_cracks_of(stresses, cracks, lists, p, [&]() __attribute__((always_inline)) { ahead.ask(); });
            const double *const b = &lists.slip(p, 0);
            const bool slips = b[0] != 0.0 || b[1] != 0.0 || b[2] != 0.0;
            double &state = lists.slip(p, crack::slipping);
            if (changes) state = slips ? crack::slips : state == crack::slips ? crack::slipped : crack::sticks;
        }
    });
}
BONDEM_PASS(sum_cracks, of_cracks, "own half; adds carried slip sum")

// Applies the slip of both cells to the faces of cracks.
void slide_cracks(const Range &range, const Moving &all, const ElasticFacets &facets, const CohesiveCracks &cracks,
                  const CrackLists &lists) {
    if (!(range.clock.dt > 0.0)) return;
    over_places(range, lists.size(list_count::treated), [&](Index first, Index last, Index) {
        const double *const slipping = lists.slip.data + crack::slipping;
        for (Index e = first; e < last; e++)
            if (slipping[4 * lists.treated_i.data[e]] + slipping[4 * lists.treated_j.data[e]] != crack::sticks)
                slide_crack(all, facets, cracks, lists, lists.treated(e));
    });
}
BONDEM_PASS(slide_cracks, of_cracks, "ends pose slip")

// Ends the active status of cracks that `soften_cracks` has found to rest, or `measure_cracks` to part.
void leave_cracks(const Range &range, const Moving &all, const ElasticFacets &facets, const CellDilatation &cells,
                  const CellSlack &slack, const CohesiveCracks &cracks, const CrackLists &lists) {
    if (!(range.clock.dt > 0.0)) return;
    const Index count = lists.size(list_count::treated);
    for (Index q = 0; q < portions(count, crack::of_portion); q++) {
        if (lists.flagged(q) == 0) continue;
        for (Index e = q * crack::of_portion; e < least(count, (q + 1) * crack::of_portion); e++) {
            const Byte flag = lists.flag(e);
            if (flag == crack::unchanged) continue;
            const Index k = lists.treated(e);
            if (flag == crack::fell) {
                lists.outdated(facets.i(k)) = lists.outdated(facets.j(k)) = 1;
                lists.flag(e) = crack::unchanged;
                continue;
            }
            const SingleCrack one(all.pose, facets, cracks, k);
            if (flag == crack::parts) {
                const double lost = energy_of_parting(one, facets, cracks, lists, k, [&](Short p, Index half) {
                    return stiffness_without(all, lists, cells.weight(p), p, half, [](Index) { return false; });
                });
                exact_sum(lists.lost, 0).add(lost);
                history_of(cracks, k).spent += lost;
                end_treating(facets, cracks, lists, k, crack::parted);
                lists.parted(lists.size(list_count::parted)++) = k;
            } else {
                end_treating(facets, cracks, lists, k, crack::resting);
            }
            hand_over(one, facets, cells, slack, cracks, lists, k, 1.0);
        }
    }
}
BONDEM_PASS(leave_cracks, of_cracks, "ends pose; energy CellDilatation.weight half pose.stress; adds CellDilatation.weight base half outdated")

}  // namespace bondem
