// The second of two passes over facets in a step: forces and torques, by the stresses from `dilatation.cpp`.
#include "../../registered.hpp"
#include "../../tables/cell_tables.hpp"
#include "facets.hpp"

namespace bondem {
namespace {

BONDEM_INLINE Row<Lanes> moment_row(Vector3<Lanes> arm, Vector3<Lanes> force, Lanes bent) {
    const Symmetric3<Lanes> m = symmetric_product(arm, force);
    return {{m.xx, m.yy, m.zz, bent, m.xy, m.xz, m.yz, Lanes{}}};
}

}  // namespace

// Adds forces and torques of the facets of a block to the sums of their cells, whose stresses are known.
void add_facet_loads(const Range &range, const Moving &all, const ElasticFacets &facets, const StepBlocks &blocks) {
    add_loads_of_facets(range.first, range.last, all.pose.data, facets, blocks.row_i.data, blocks.row_j.data,
                        blocks.sums.data);
}
BONDEM_PASS(add_facet_loads, bonds_of_blocks, "ends pose pose.stress; adds sums")

// Adds and stores the forces of the facets of a block, and adds up the moments V σ of their cells. A facet without
// integrity has no force, also if an earlier one is stored.
void add_and_keep_facet_loads(const Range &range, const Moving &all, const ElasticFacets &facets,
                              const FacetForces &stored, const StepBlocks &blocks) {
    const FacetColumns columns(facets);
    const Short *const row_i = blocks.row_i.data, *const row_j = blocks.row_j.data;
    double *const force = stored.force.data;
    for_each_facets(range.first, range.last, all.pose.data, facets, columns.period,
                    [&](Index k) __attribute__((always_inline)) { return any_left(columns, k); },
                    [&](Index k, int known, const Row<Lanes> &a, const Row<Lanes> &b, const Ends<Lanes> &ends)
                        __attribute__((always_inline)) {
        const Lanes s = load(columns.integrity + k);
        const FacetShape<Lanes> shape = columns.shape<Lanes>(k);
        const FacetStiffness<Lanes> stiffness = columns.stiffness<Lanes>(k, s);
        const Vector3<Lanes> moment = bending_moment(ends, stiffness.H);
        const OpenFacet<Lanes> open = opened(ends, shape);
        const FacetLoads<Lanes> loads = facet_loads(ends, shape, open, moment, stiffness.k, stresses_of(a, b, s));
        const Vector3<Lanes> on_i = -loads.force;
        // cells of the group before may have moved since its forces were stored
        for (Index axis = 0; axis < 3; axis++) store_behind(force + axis * columns.m + k, on_i[axis], known);
        const Lanes bent = bending_square(ends, load(stored.bends.data + k), stiffness.H);
        add_rows(stored.sums.data, row_i + k, row_j + k, moment_row(open.arm_i, on_i, bent),
                 moment_row(open.arm_j, loads.force, bent), known);
        add_loads_of(blocks.sums.data, row_i + k, row_j + k, loads, known);
    });
}
BONDEM_PASS(add_and_keep_facet_loads, bonds_of_blocks, "ends pose pose.stress; adds FacetForces.sums StepBlocks.sums")

}  // namespace bondem
