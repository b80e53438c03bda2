// Lists of active and resting cracks (`crack_states.cpp`), and for each cell of the halves of its active cracks
// (`laws/crack.hpp`).
//
// Unbroken cracks precede broken ones, each in the order of their facets: consecutive facets are near each other, and
// so are their data. The halves of a cell are linked from the last facet to the first. Contributions to a cell are
// added in this order, so that no bit depends on when a list is made.
#include "crack_passes.hpp"

#include "../../registered.hpp"
#include "carried.hpp"
#include "crack_axes.hpp"

namespace bondem {
namespace {

// Repeats the last crack of a list in the lanes after its end.
void fill(const Array<Index, 1> &list, const Array<Short, 1> &at_i, const Array<Short, 1> &at_j, Index count) {
    if (count == 0) return;
    for (Index e = count; e < count + lanes; e++) {
        list(e) = list(count - 1);
        at_i(e) = at_i(count - 1);
        at_j(e) = at_j(count - 1);
    }
}

// Calls on(k) for each listed facet. Eight facets without cracks, whose bytes are one number 0, are skipped at once.
typedef uint64_t EightBytes __attribute__((aligned(1), may_alias));
template <class On> inline void for_each_listed(const CohesiveCracks &cracks, On on) {
    const Byte *const listed = cracks.listed.data;
    for (Index k = 0, m = cracks.integrity.size(); k < m;) {
        if (k + 8 <= m && *reinterpret_cast<const EightBytes *>(listed + k) == 0) {
            k += 8;
            continue;
        }
        for (const Index last = least(k + 8, m); k < last; k++)
            if (listed[k] != 0) on(k);
    }
}

}  // namespace

void fill_treated(const CrackLists &lists) {
    fill(lists.treated, lists.treated_i, lists.treated_j, lists.size(list_count::treated));
    const Index cells = lists.size(list_count::cells);
    if (cells > 0)
        for (Index q = cells; q < cells + lanes; q++) lists.cell(q) = lists.cell(cells - 1);
}

// Rebuilds the lists of cracks if they are out of date.
void list_cracks(const Range &, const ElasticFacets &facets, const CohesiveCracks &cracks, const CrackLists &lists) {
    lists.size(list_count::parted) = 0;
    if (cracks.size(crack_number::out_of_date) == 0) return;
    cracks.size(crack_number::out_of_date) = 0;
    for (Index q = 0; q < lists.size(list_count::cells); q++) lists.head(lists.cell(q)) = 0;
    // broken cracks are behind the others, so that groups of lanes have one or the other
    Index treated[2] = {}, resting[2] = {}, cells = 0;
    for (Index k = 0, m = cracks.integrity.size(); k < m; k++) {
        const bool whole = cracks.integrity(k) != 0.0;
        treated[1] += whole & is_treated(cracks, k);
        resting[1] += whole & (cracks.listed(k) == 1 + crack::resting);
    }
    const auto push = [&](Short p, Index half) {
        int32_t &head = lists.head(p);
        lists.cell(cells) = p;
        cells += head == 0;
        lists.next(half) = head;
        head = int32_t(half);
    };
    const auto put = [&](const Array<Index, 1> &list, const Array<Short, 1> &at_i, const Array<Short, 1> &at_j,
                         Index e, Index k) {
        list(e) = k;
        at_i(e) = facets.i(k);
        at_j(e) = facets.j(k);
    };
    for_each_listed(cracks, [&](Index k) {
        const bool broken = cracks.integrity(k) == 0.0;
        if (is_treated(cracks, k)) {
            put(lists.treated, lists.treated_i, lists.treated_j, treated[broken]++, k);
            push(facets.i(k), half_of(k, 0));
            push(facets.j(k), half_of(k, 1));
        } else if (cracks.listed(k) == 1 + crack::resting) {
            put(lists.resting, lists.resting_i, lists.resting_j, resting[broken]++, k);
        }
    });
    lists.size(list_count::treated) = treated[1];
    lists.size(list_count::resting) = resting[1];
    lists.size(list_count::cells) = cells;
    fill_treated(lists);
    fill(lists.resting, lists.resting_i, lists.resting_j, resting[1]);
}
BONDEM_PASS(list_cracks, of_cracks, "")

// Prepares the cracks of a state at the start of a run: constants, weights of cells, lists, and forces of cracks.
void link_cracks(const Range &range, const ElasticFacets &facets, const FacetForces &stored,
                 const FacetStrengths &strengths,
                 const CohesiveCracks &cracks, const CrackLists &lists) {
    for (Index d = 0; d < 3; d++) cracks.pitch(d) = facets.pitch(d);
    for (Index c = 0; c < cracks.size(crack_number::cracks); c++) {
        const Index k = cracks.order(c);
        write_constants(facets, stored, strengths, cracks, k);
        treat(facets, cracks, k, int(history_of(cracks, k).status));
    }
    clear_half(lists, 0);
    cracks.size(crack_number::out_of_date) = 1;
    list_cracks(range, facets, cracks, lists);
    // slips in the step before are unknown
    for (Index p = 0; p < lists.slip.size(); p++) lists.slip(p, crack::slipping) = crack::slips;
}
BONDEM_PASS(link_cracks, of_cracks, "adds half slip")

// Copies levers of facets that strains of cells have changed.
void follow_levers(const Range &, const CellStrains &strains, const ElasticFacets &facets, const CohesiveCracks &cracks) {
    if (!strains.due(strain_due::levers)) return;
    for (Index c = 0; c < cracks.size(crack_number::cracks); c++) write_levers(facets, cracks, cracks.order(c));
}
BONDEM_PASS(follow_levers, of_cracks, "")

// Computes the weights of the cells of all cracks at the start of a run.
void weigh_cracked_cells(const Range &, const ElasticFacets &facets, const CellDilatation &cells,
                         const CellSlack &slack, const CohesiveCracks &cracks) {
    for (Index c = 0; c < cracks.size(crack_number::cracks); c++) {
        weigh_cracked(cells, slack, cracks, facets.i(cracks.order(c)));
        weigh_cracked(cells, slack, cracks, facets.j(cracks.order(c)));
    }
}
BONDEM_PASS(weigh_cracked_cells, of_cracks, "adds CellDilatation.weight")

// Sums b⊗f of the cracks of each cell from their forces of the last step, and finds its leading crack.
void carry_cracks(const Range &, const StressesOfCells &stresses, const CohesiveCracks &cracks,
                  const CrackLists &lists) {
    for (Index q = 0; q < lists.size(list_count::cells); q++) {
        carry_cracks_of(stresses, cracks, lists, lists.cell(q));
        find_leader(cracks, lists, lists.cell(q));
    }
}
BONDEM_PASS(carry_cracks, of_cracks, "adds carried leader")

}  // namespace bondem
