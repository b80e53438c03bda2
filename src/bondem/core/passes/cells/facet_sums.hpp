// Forces and torques of facets added to the sums of their cells, for passes of a step and for any poses.
#pragma once
#include "facets.hpp"

namespace bondem {

BONDEM_INLINE void add_loads_of_facets(double *sums, const Short *row_i, const Short *row_j,
                                       const FacetLoads<Lanes> &loads, int known) {
    const Vector3<Lanes> f = loads.force, a = loads.on_i, b = loads.on_j;
    const Lanes zero = {};
    add_rows(sums, row_i, row_j, {{-f.x, -f.y, -f.z, zero, a.x, a.y, a.z, zero}}, {{f.x, f.y, f.z, zero, b.x, b.y, b.z, zero}},
             known);
}

// Adds the loads of the facets first … last - 1, in their order.
BONDEM_INLINE void add_loads_of_facets(Index first, Index last, const double *pose, const ElasticFacets &facets,
                                       const Short *row_i, const Short *row_j, double *const __restrict sums) {
    const FacetColumns columns(facets);
    for_each_facets(first, last, pose, facets, columns.period,
                    [&](Index k, int known, const Row<Lanes> &a, const Row<Lanes> &b, const Ends<Lanes> &ends)
                        __attribute__((always_inline)) {
        const Lanes s = load(columns.integrity + k);
        const FacetLoads<Lanes> loads = facet_loads(ends, columns.shape<Lanes>(k), columns.stiffness<Lanes>(k, s),
                                                    stresses_of(a, b, s));
        add_loads_of_facets(sums, row_i + k, row_j + k, loads, known);
    });
}

}  // namespace bondem
