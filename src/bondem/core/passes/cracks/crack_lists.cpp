// Lists of cracks in the order in which they began, and the halves of each cell, from the last crack to the first.
//
// What is added to a cell is added in that order, whatever place a crack has in a list, so that a pause changes no bit.
#include "crack_lists.hpp"

#include "carried.hpp"
#include "constants.hpp"

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

void fill_treated(const CohesiveCracks &, const CrackLists &lists) {
    fill(lists.treated, lists.treated_i, lists.treated_j, lists.size(0));
    const Index cells = lists.size(2);
    if (cells > 0)
        for (Index q = cells; q < cells + lanes; q++) lists.cell(q) = lists.cell(cells - 1);
}

void list_cracks(const Turn &, const CohesiveCracks &cracks, const CrackLists &lists) {
    if (cracks.size(1) == 0) return;
    cracks.size(1) = 0;
    for (Index q = 0; q < lists.size(2); q++) lists.head(lists.cell(q)) = 0;
    Index treated = 0, resting = 0, cells = 0;
    const auto push = [&](Short p, Index number) {
        if (lists.head(p) == 0) lists.cell(cells++) = p;
        lists.after(number) = lists.head(p);
        lists.head(p) = int32_t(number);
    };
    for (Index c = 0; c < cracks.size(0); c++) {
        const Byte status = cracks.listed(cracks.facet(c));
        if (status == 1 + crack::active) {
            lists.treated(treated) = c;
            lists.treated_i(treated) = cracks.i(c);
            lists.treated_j(treated) = cracks.j(c);
            push(cracks.i(c), 2 * treated + 1);
            push(cracks.j(c), 2 * treated + 2);
            treated++;
        } else if (status == 1 + crack::resting) {
            lists.resting(resting) = c;
            lists.resting_i(resting) = cracks.i(c);
            lists.resting_j(resting) = cracks.j(c);
            resting++;
        }
    }
    lists.size(0) = treated, lists.size(1) = resting, lists.size(2) = cells;
    fill_treated(cracks, lists);
    fill(lists.resting, lists.resting_i, lists.resting_j, resting);
}

void link_cracks(const Turn &turn, const ElasticFacets &facets, const FacetForces &kept, const FacetStrengths &strengths,
                 const CohesiveCracks &cracks, const CrackLists &lists) {
    for (Index c = 0; c < cracks.size(0); c++) {
        const Index k = Index(cracks.row(c, crack::facet));
        cracks.facet(c) = k;
        cracks.row(c, crack::integrity) = cracks.integrity(k);
        write_constants(facets, kept, strengths, cracks, c);
        treat(facets, cracks, c, int(cracks.row(c, crack::status)));
    }
    clear_half(lists, 0);
    cracks.size(1) = 1;
    list_cracks(turn, cracks, lists);
}

void follow_levers(const Turn &, const ElasticFacets &facets, const CohesiveCracks &cracks) {
    for (Index c = 0; c < cracks.size(0); c++) write_levers(facets, cracks, c);
}

void weigh_cracked_cells(const Turn &, const CellDilatation &cells, const CellSlack &slack, const CohesiveCracks &cracks) {
    for (Index c = 0; c < cracks.size(0); c++) {
        weigh_cracked(cells, slack, cracks, cracks.i(c));
        weigh_cracked(cells, slack, cracks, cracks.j(c));
    }
}

void carry_cracks(const Turn &, const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists) {
    for (Index q = 0; q < lists.size(2); q++) {
        const Index p = lists.cell(q);
        Carried sum = {};
        for (Index h = lists.head(p); h > 0; h = lists.after(h)) {
            const Index c = lists.treated((h - 1) >> 1);
            double f[4];
            for (int d = 0; d < 4; d++) f[d] = h & 1 ? cracks.pull(c, d) : -cracks.pull(c, d);
            sum.add(constants_of(cracks, c) + (h & 1 ? 0 : 8), f);
        }
        sum.put(stresses, p);
    }
}

}  // namespace bondem
