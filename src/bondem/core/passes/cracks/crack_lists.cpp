// Lists of cracks in the order in which they began, and the halves of each cell, from the last crack to the first.
//
// What is added to a cell is added in that order, whatever place a crack has in a list, so that a pause changes no bit.
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

void list_cracks(const Turn &, const CohesiveCracks &cracks, const CrackLists &lists) {
    if (cracks.size(1) == 0) return;
    cracks.size(1) = 0;
    for (Index q = 0; q < lists.size(2); q++) lists.head(lists.cell(q)) = 0;
    const Index count = cracks.size(0);
    const auto status_of = [&](Index c) { return int(cracks.listed(cracks.facet(c))) - 1; };
    const auto is_broken = [&](Index c) { return cracks.integrity(cracks.facet(c)) == 0.0; };
    // broken cracks stand behind the others, so that groups of lanes have one or the other
    Index treated[2] = {}, resting[2] = {}, cells = 0;
    for (Index c = 0; c < count; c++) {
        const int status = status_of(c);
        const bool broken = is_broken(c);
        treated[1] += status == crack::active && !broken;
        resting[1] += status == crack::resting && !broken;
    }
    const Index unbroken = resting[1];
    const auto push = [&](Short p, Index number, const int32_t *lever) {
        if (lists.head(p) == 0) lists.cell(cells++) = p;
        put_node(lists, number, lists.head(p), lever);
        lists.head(p) = int32_t(number);
    };
    const auto put = [&](const Array<Index, 1> &list, const Array<Short, 1> &at_i, const Array<Short, 1> &at_j, Index e,
                         Index c) {
        list(e) = c;
        at_i(e) = cracks.i(c);
        at_j(e) = cracks.j(c);
    };
    for (Index c = 0; c < count; c++) {
        const int status = status_of(c);
        if (status == crack::active) {
            const Index e = treated[is_broken(c)]++;
            put(lists.treated, lists.treated_i, lists.treated_j, e, c);
            push(cracks.i(c), 2 * e + 1, shape_of(cracks, c).lever_i);
            push(cracks.j(c), 2 * e + 2, shape_of(cracks, c).lever_j);
        } else if (status == crack::resting) {
            put(lists.resting, lists.resting_i, lists.resting_j, resting[is_broken(c)]++, c);
        }
    }
    lists.size(0) = treated[1], lists.size(1) = resting[1], lists.size(2) = cells, lists.size(3) = unbroken;
    fill_treated(lists);
    fill(lists.resting, lists.resting_i, lists.resting_j, resting[1]);
}

void link_cracks(const Turn &turn, const ElasticFacets &facets, const FacetForces &kept, const FacetStrengths &strengths,
                 const CohesiveCracks &cracks, const CrackLists &lists) {
    for (Index d = 0; d < 3; d++) cracks.pitch(d) = facets.pitch(d);
    for (Index c = 0; c < cracks.size(0); c++) {
        cracks.facet(c) = Index(history_of(cracks, c).facet);
        write_constants(facets, kept, strengths, cracks, c);
        treat(facets, cracks, c, int(history_of(cracks, c).status));
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
        for (Index h = lists.head(p); h > 0; h = lists.node(h, 0)) {
            const double *const pull = &cracks.pull(lists.treated((h - 1) >> 1), 0);
            double f[4];
            for (int d = 0; d < 4; d++) f[d] = h & 1 ? pull[d] : -pull[d];
            sum.add(&lists.node(h, 1), f);
        }
        sum.put(stresses, cracks.pitch.data, p);
    }
}

}  // namespace bondem
