// Stress σ of cells of volume V from the forces f of their facets. Passes compute the moment V σ = sym Σ b⊗f of each
// cell, with the lever b from its centre to the facet and the symmetric part sym. Levers and forces are those of the
// same instant, along fixed axes. `facet_loads.cpp` sums b⊗f together with the forces.
#include "cell_passes.hpp"

#include "../../registered.hpp"
#include "facets.hpp"

namespace bondem {
namespace {

// Columns of the components of a moment and of the bending in a row of sums.
constexpr Index column_of[7] = {0, 1, 2, 4, 5, 6, 3};

void add(double *moment, const Symmetric3<double> &m, double bent) {
    const double all[7] = {m.xx, m.yy, m.zz, m.xy, m.xz, m.yz, bent};
    for (Index c = 0; c < 7; c++) moment[c] += all[c];
}

}  // namespace

// Adds moments of facets of other domains to the sums of shared cells, and sets their rows to zero.
void collect_facet_moments(const Range &range, const StepBlocks &blocks, const FacetForces &stored) {
    for (Index e = range.first; e < range.last; e++)
        for (Index q = blocks.parts + blocks.part(e); q < blocks.parts + blocks.part(e + 1); q++)
            for (Index c = 0; c < 8; c++) {
                stored.sums(range.row[e], c) += stored.sums(q, c);
                stored.sums(q, c) = 0.0;
            }
}
BONDEM_PASS(collect_facet_moments, parts_of_shared, "changes FacetForces.sums")

// Sets V σ and Σ `bending_square` of cells from their complete sums, which are set to zero.
void take_moments(const Range &range, const FacetForces &stored) {
    for (Index e = range.first; e < range.last; e++) {
        double *const sums = &stored.sums(range.row[e], 0);
        for (Index c = 0; c < 7; c++) stored.moment(range.element[e], c) = sums[column_of[c]];
        for (Index c = 0; c < 8; c++) sums[c] = 0.0;
    }
}
BONDEM_PASS(take_moments, elements_of_blocks, "changes sums; writes moment")

void sum_moments(const Range &range, const Moving &all, const ElasticFacets &facets, const FacetsOfCells &of_cells,
                 const FacetForces &stored) {
    const FacetColumns columns(facets);
    for (Index p = range.first; p < range.last; p++) {
        double *const moment = &stored.moment(p, 0);
        for (Index c = 0; c < 7; c++) moment[c] = 0.0;
        for_each_bond_of(of_cells, p, [&](Index k, bool is_i) {
            const Ends<double> ends = ends_of(all.pose.data, facets, k);
            const OpenFacet<double> open = opened(ends, columns.shape<double>(k));
            const Vector on_i = {stored.force(0, k), stored.force(1, k), stored.force(2, k)};
            const double bent = bending_square(ends, stored.bends(k), columns.stiffness(k, facets.integrity(k)).H);
            add(moment, is_i ? symmetric_product(open.arm_i, on_i) : symmetric_product(open.arm_j, -on_i), bent);
        });
    }
}
BONDEM_PASS(sum_moments, of_elements, "ends pose; adds moment")

}  // namespace bondem
