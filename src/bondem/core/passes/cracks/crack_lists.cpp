// Lists of cracks in the order of their facets, and the halves of each cell, from the last facet to the first.
//
// What is added to a cell is added in that order, whatever place a crack has in a list, so that a pause changes no
// bit. Facets that follow each other are near each other, and so is what cracks of a list read and write.
#include "crack_lists.hpp"

#include "carried.hpp"

namespace bondem {
namespace {

// Lanes behind the end of a list repeat its last crack.
void fill(const Array<Index, 1> &list, const Array<Short, 1> &at_i, const Array<Short, 1> &at_j, Index count) {
    if (count == 0) return;
    for (Index e = count; e < count + lanes; e++) {
        list(e) = list(count - 1);
        at_i(e) = at_i(count - 1);
        at_j(e) = at_j(count - 1);
    }
}

}  // namespace

void fill_treated(const CrackLists &lists) {
    fill(lists.treated, lists.treated_i, lists.treated_j, lists.size(0));
    const Index cells = lists.size(2);
    if (cells > 0)
        for (Index q = cells; q < cells + lanes; q++) lists.cell(q) = lists.cell(cells - 1);
}

void list_cracks(const Turn &, const ElasticFacets &facets, const CohesiveCracks &cracks, const CrackLists &lists) {
    lists.size(3) = 0;
    if (cracks.size(1) == 0) return;
    cracks.size(1) = 0;
    for (Index q = 0; q < lists.size(2); q++) lists.head(lists.cell(q)) = 0;
    const Index m = cracks.integrity.size();
    // broken cracks stand behind the others, so that groups of lanes have one or the other
    Index treated[2] = {}, resting[2] = {}, cells = 0;
    for (Index k = 0; k < m; k++) {
        const Byte listed = cracks.listed(k);
        if (listed == 0) continue;
        const bool whole = cracks.integrity(k) != 0.0;
        treated[1] += whole & (listed == 1 + crack::active);
        resting[1] += whole & (listed == 1 + crack::resting);
    }
    const auto push = [&](Short p, Index number, const int32_t *lever) {
        if (lists.head(p) == 0) lists.cell(cells++) = p;
        put_node(lists, number, lists.head(p), lever);
        lists.head(p) = int32_t(number);
    };
    const auto put = [&](const Array<Index, 1> &list, const Array<Short, 1> &at_i, const Array<Short, 1> &at_j,
                         Index e,
                         Index k) {
        list(e) = k;
        at_i(e) = facets.i(k);
        at_j(e) = facets.j(k);
    };
    for (Index k = 0; k < m; k++) {
        const Byte listed = cracks.listed(k);
        if (listed == 0) continue;
        const bool broken = cracks.integrity(k) == 0.0;
        if (listed == 1 + crack::active) {
            const Index e = treated[broken]++;
            put(lists.treated, lists.treated_i, lists.treated_j, e, k);
            push(facets.i(k), 2 * e + 1, shape_of(cracks, k).lever_i);
            push(facets.j(k), 2 * e + 2, shape_of(cracks, k).lever_j);
        } else if (listed == 1 + crack::resting) {
            put(lists.resting, lists.resting_i, lists.resting_j, resting[broken]++, k);
        }
    }
    lists.size(0) = treated[1], lists.size(1) = resting[1], lists.size(2) = cells;
    fill_treated(lists);
    fill(lists.resting, lists.resting_i, lists.resting_j, resting[1]);
}

void link_cracks(const Turn &turn, const ElasticFacets &facets, const FacetForces &kept,
                 const FacetStrengths &strengths,
                 const CohesiveCracks &cracks, const CrackLists &lists) {
    for (Index d = 0; d < 3; d++) cracks.pitch(d) = facets.pitch(d);
    for (Index c = 0; c < cracks.size(0); c++) {
        const Index k = cracks.order(c);
        write_constants(facets, kept, strengths, cracks, k);
        treat(facets, cracks, k, int(history_of(cracks, k).status));
    }
    clear_half(lists, 0);
    cracks.size(1) = 1;
    list_cracks(turn, facets, cracks, lists);
}

void follow_levers(const Turn &, const CellStrains &strains, const ElasticFacets &facets, const CohesiveCracks &cracks) {
    if (!strains.due(1)) return;
    for (Index c = 0; c < cracks.size(0); c++) write_levers(facets, cracks, cracks.order(c));
}

void weigh_cracked_cells(const Turn &, const ElasticFacets &facets, const CellDilatation &cells,
                         const CellSlack &slack, const CohesiveCracks &cracks) {
    for (Index c = 0; c < cracks.size(0); c++) {
        weigh_cracked(cells, slack, cracks, facets.i(cracks.order(c)));
        weigh_cracked(cells, slack, cracks, facets.j(cracks.order(c)));
    }
}

void carry_cracks(const Turn &, const StressesOfCells &stresses, const CohesiveCracks &cracks,
                  const CrackLists &lists) {
    for (Index q = 0; q < lists.size(2); q++) carry_cracks_of(stresses, cracks, lists, lists.cell(q));
}

}  // namespace bondem
