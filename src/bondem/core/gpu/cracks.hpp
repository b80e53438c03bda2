// Cracks on a GPU. Passes have one thread per facet, which computes its crack, or one per cell, which adds up the
// loads of the cracks of its facets. The number of a facet is also the row of its crack in tables. An active crack is
// evaluated in every step. A resting crack is treated as a facet of reduced stiffness. A cracked facet has two
// halves, one per cell (`laws/crack.hpp`). The thread of a cell links the halves of its active cracks in a list.
//
// Flags of a facet state how its crack changes in a step: `flag` for an active crack, `waking` for a resting crack.
// The thread of a cell adds the changes in the same order as the CPU.
#pragma once
#include "../passes/contacts/face_contacts.hpp"
#include "../passes/contacts/handover.hpp"
#include "../passes/cracks/carried.hpp"
#include "../passes/cracks/crack_axes.hpp"
#include "../passes/cracks/crack_passes.hpp"
#include "../passes/cracks/loaded_cracks.hpp"
#include "../passes/cracks/opening_cracks.hpp"
#include "../passes/cracks/resting_cracks.hpp"
#include "../passes/cracks/softening_cracks.hpp"
#include "heap_sort.hpp"
#include "ranges.hpp"

namespace bondem {

BONDEM_INLINE bool takes_time(const DeviceSpan &span) { return clock_of(span).dt > 0.0; }
// True if a crack is no longer active from this step on.
BONDEM_INLINE bool leaves(Byte flag) { return flag == crack::calmed || flag == crack::parts; }
BONDEM_INLINE void make_outdated(const CrackLists &lists, const ElasticFacets &facets, Index k) {
    put_shared(lists.outdated(facets.i(k)), Byte(1));
    put_shared(lists.outdated(facets.j(k)), Byte(1));
}

// ---- the beginning of a run

inline void begin_all_levers(Index, const ElasticFacets &facets, const CohesiveCracks &cracks) {
    for (Index d = 0; d < 3; d++) cracks.pitch(d) = facets.pitch(d);
    cracks.size(crack_number::out_of_date) = 1;
}
inline void restore_crack(Index k, const ElasticFacets &facets, const FacetForces &stored,
                          const FacetStrengths &strengths, const CohesiveCracks &cracks) {
    if (cracks.listed(k) == 0) return;
    write_constants(facets, stored, strengths, cracks, k);
    treat(facets, cracks, k, int(history_of(cracks, k).status));
}
inline void weigh_cell(Index p, const CellDilatation &cells, const CellSlack &slack, const CohesiveCracks &cracks) {
    weigh_cracked(cells, slack, cracks, p);
}
inline void carry_cell(Index p, const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists) {
    if (lists.head(p) == 0) return;
    carry_cracks_of(stresses, cracks, lists, p);
    find_leader(cracks, lists, p);
}
// Copies the levers of a facet that strains of cells have changed.
inline void follow_lever(Index k, const CellStrains &strains, const ElasticFacets &facets, const CohesiveCracks &cracks) {
    if (strains.due(strain_due::levers) && cracks.listed(k) != 0) write_levers(facets, cracks, k);
}

// ---- the halves of each cell, from the last facet to the first

template <class Facets>
BONDEM_INLINE void link_cell(Index p, const CohesiveCracks &cracks, const CrackLists &lists, const Facets &of) {
    int32_t first = 0;
    for_each_bond_of(of, p, [&](Index k, bool is_i) {
        if (!is_treated(cracks, k)) return;
        const Index half = half_of(k, is_i ? 0 : 1);
        lists.next(half) = first;
        first = int32_t(half);
    });
    lists.head(p) = first;
}
inline void link_halves(Index p, const CohesiveCracks &cracks, const CrackLists &lists, const BondsOfElements &of) {
    if (get_shared(cracks.size(crack_number::out_of_date)) != 0) link_cell(p, cracks, lists, of);
}

// ---- opening

constexpr auto begin_base = one_element<begin_bases>;
inline void measure_crack(Index k, const DeviceSpan &span, const Moving &all, const ElasticFacets &facets,
                          const CellSlack &slack, const StressesOfCells &stresses, const CohesiveCracks &cracks,
                          const CrackLists &lists) {
    if (k == 0) cracks.size(crack_number::out_of_date) = 0;  // all halves are linked
    lists.flag(k) = lists.waking(k) = crack::unchanged;
    if (!is_treated(cracks, k)) return;
    measure_each(OneCrack(facets, k), all, facets, slack, stresses, cracks, lists, 0, takes_time(span));
}
inline void relax_cell(Index p, const Moving &all, const CellDilatation &cells, const CrackLists &lists) {
    lists.outdated(p) = 0;
    if (lists.head(p) != 0) relax(OneCell{Short(p)}, all, cells, lists);
}
inline void relax_outdated_cell(Index p, const Moving &all, const CellDilatation &cells, const CohesiveCracks &cracks,
                                const CrackLists &lists) {
    if (lists.outdated(p) == 0) return;
    find_leader(cracks, lists, p);
    relax_cell(p, all, cells, lists);
}

// ---- rest

inline void watch_resting_crack(Index k, const DeviceSpan &span, const Moving &all, const ElasticFacets &facets,
                                const FacetStrengths &strengths, const CohesiveCracks &cracks, const CrackLists &lists) {
    if (cracks.listed(k) != 1 + crack::resting || !takes_time(span)) return;
    watch_each(OneCrack(facets, k), all, facets.period.data, strengths, cracks, lists, 0);
}
inline void wake_crack(Index k, const Moving &all, const ElasticFacets &facets, const CohesiveCracks &cracks,
                       const CrackLists &lists) {
    if (lists.waking(k) != crack::wakes) return;
    const SingleCrack one(all.pose, facets, cracks, k);
    if (one.is_separate() && turned_away(one.now, one.area, slide_of(cracks, k))) {
        part_resting(facets, cracks, k);
        lists.waking(k) = crack::parts;
        return;
    }
    begin_treating(one, facets, cracks, lists, k, k);
    make_outdated(lists, facets, k);
}
// Adds the share of cracks with changes(k) in V θ of cell p without cracks, times a sign; true if a crack changes.
template <class Changes>
BONDEM_INLINE bool change_base(Index p, const Moving &all, const ElasticFacets &facets, const CellSlack &slack,
                               const CohesiveCracks &cracks, const CrackLists &lists, double sign, Changes changes) {
    bool any = false;
    for_each_bond_of(slack, p, [&](Index k, bool is_i) {
        if (!changes(k)) return;
        any = true;
        const CrackFaces<double> at = SingleCrack(all.pose, facets, cracks, k).now;
        lists.base(p) += sign * cracks.integrity(k) * dot(is_i ? at.share_i : at.share_j, at.gap);
    });
    return any;
}
inline void take_woken(Index p, const DeviceSpan &span, const Moving &all, const ElasticFacets &facets,
                       const CellDilatation &cells, const CellSlack &slack, const CohesiveCracks &cracks,
                       const CrackLists &lists) {
    if (lists.outdated(p) == 0 || !takes_time(span)) return;
    const auto woken = [&](Index k) { return lists.waking(k) == crack::wakes; };
    if (!change_base(p, all, facets, slack, cracks, lists, -1.0, woken)) return;
    weigh_cracked(cells, slack, cracks, p);
    link_cell(p, cracks, lists, slack);
}

// ---- softening

inline void soften_crack(Index k, const DeviceSpan &span, const Moving &all, const ElasticFacets &facets,
                         const FacetStrengths &strengths, const StressesOfCells &stresses, const CohesiveCracks &cracks,
                         const CrackLists &lists) {
    if (!is_treated(cracks, k) || !takes_time(span)) return;
    soften_each(OneCrack(facets, k), all, facets, strengths, stresses, cracks, lists, 0);
    if (lists.flag(k) != crack::unchanged) make_outdated(lists, facets, k);
}

// ---- parting and rest

// Adds the energy lost by a crack that parts, without the cracks that leave before it on the CPU: unbroken
// ones, and broken ones of a lower number.
inline void part_crack(Index k, const Moving &all, const ElasticFacets &facets, const CellSlack &slack,
                       const CohesiveCracks &cracks, const CrackLists &lists) {
    if (lists.flag(k) != crack::parts) return;
    const auto left_before = [&](Index other) {
        return leaves(lists.flag(other)) && (cracks.integrity(other) > 0.0 || other < k);
    };
    const auto stiffness = [&](Short p, Index half) {
        const double weight = weight_with(slack, cracks, p, [&](Index other) {
            return treated_as_facet(cracks, other) || left_before(other);
        });
        return stiffness_without(all, lists, weight, p, half, [&](Index h) { return left_before(facet_of(h)); });
    };
    const double lost = energy_of_parting(SingleCrack(all.pose, facets, cracks, k), facets, cracks, lists, k, stiffness);
    exact_sum(lists.lost, 0).add_shared(lost);
    history_of(cracks, k).spent += lost;
}
inline void leave_crack(Index k, const ElasticFacets &facets, const CohesiveCracks &cracks, const CrackLists &lists) {
    const Byte flag = lists.flag(k);
    if (leaves(flag))
        end_treating(facets, cracks, lists, k, flag == crack::parts ? crack::parted : crack::resting);
}
inline void take_leaving(Index p, const DeviceSpan &span, const Moving &all, const ElasticFacets &facets,
                         const CellDilatation &cells, const CellSlack &slack, const CohesiveCracks &cracks,
                         const CrackLists &lists) {
    if (lists.outdated(p) == 0 || !takes_time(span)) return;
    const auto left = [&](Index k) { return leaves(lists.flag(k)); };
    if (change_base(p, all, facets, slack, cracks, lists, 1.0, left)) weigh_cracked(cells, slack, cracks, p);
}
// ---- forces and dissipated energy

inline void load_crack(Index k, const DeviceSpan &span, const Moving &all, const ElasticFacets &facets,
                       const FacetStrengths &strengths, const StressesOfCells &stresses, const CohesiveCracks &cracks,
                       const CrackLists &lists, const FallenCracks &fallen) {
    const bool treated = is_treated(cracks, k);
    if (!treated && !leaves(lists.flag(k))) return;
    if (treated) lists.flag(k) = crack::unchanged;
    ExactSum lost = {};
    load_each(OneCrack(facets, k), all, facets.period.data, strengths, stresses, cracks, lists, 0, takes_time(span), lost);
    if (treated) exact_sum(lists.lost, 0).add_shared(lost);
    if (lists.flag(k) == crack::fell) fallen.fallen(count_up(fallen.number(0))) = k;
}
inline void sum_cracks_of_cell(Index p, const StressesOfCells &stresses, const CohesiveCracks &cracks,
                               const CrackLists &lists) {
    if (lists.head(p) != 0) sum_cracks_of(stresses, cracks, lists, p, [] {});
}
inline void slide_crack_of(Index k, const DeviceSpan &span, const Moving &all, const ElasticFacets &facets,
                           const CohesiveCracks &cracks, const CrackLists &lists) {
    if (is_treated(cracks, k) && takes_time(span)) slide_crack(all, facets, cracks, lists, k);
}
constexpr auto add_crack_load = listed_element<add_crack_loads>;

// Adds the dissipation of cracks to the released energy, and logs cracks without integrity in the order of facets.
inline void log_all_cracks(Index, const DeviceSpan &span, const Moving &all, const ElasticFacets &facets,
                           const CohesiveCracks &cracks, const CrackLists &lists, const EventLog &log,
                           const FallenCracks &of) {
    if (!takes_time(span)) return;
    log.released(0) += exact_sum(lists.lost, 0).take();
    log.written(log_count::before) = log.written(log_count::events);
    const auto key = [&](Index e) { return of.fallen(e); };
    sort_by_heap(of.number(0), key, [&](Index a, Index b) { exchange(of.fallen(a), of.fallen(b)); });
    for (Index e = 0; e < of.number(0); e++) log_crack(clock_of(span), all, facets, cracks, log, of.fallen(e));
    of.number(0) = 0;
}

}  // namespace bondem
