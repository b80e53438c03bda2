// Volume changes V θ of cells (volume times dilatation), added up over their facets, and the stresses of cells.
#pragma once
#include "facets.hpp"

namespace bondem {

BONDEM_INLINE void stress_cell(const Array<double, 2> &pose, const CellDilatation &cells, Index p) {
    pose(p, stress_column) = cells.weight(p) * (cells.swelling(p) + cells.given(p));
    cells.swelling(p) = 0.0;
}

#if defined(BONDEM_LANES)

// Marking of facets that cannot fail, without effect.
struct NoFacetMarks {
    BONDEM_INLINE bool counts(const FacetColumns &, Index) { return true; }
    template <class... Facet> BONDEM_INLINE void mark(const Facet &...) {}
};

// Marking in bodies with many broken facets: groups of facets without integrity are left out.
struct LeftFacets : NoFacetMarks {
    BONDEM_INLINE bool counts(const FacetColumns &columns, Index k) { return any_left(columns, k); }
};

// Adds contributions of the facets first … last - 1 to V θ of their cells, and marks facets near to failure.
template <class Pose, class Marking>
BONDEM_INLINE void accumulate(Index first, Index last, Pose pose, const ElasticFacets &facets,
                              const CellDilatation &cells, Marking &marking) {
    double *const __restrict swelling = cells.swelling.data;
    const Short *const to_i = cells.to_i.data, *const to_j = facets.j.data;
    const FacetColumns columns(facets);
    for_each_facets(first, last, pose, facets, columns.period,
                    [&](Index k) __attribute__((always_inline)) { return marking.counts(columns, k); },
                    [&](Index k, int known, const auto &a, const auto &b, const auto &ends) __attribute__((always_inline)) {
        const auto grown = dilatation(ends, columns.shape<LanesOf<Pose>>(k));
        const Lanes s = load(columns.integrity + k), on_i = s * written(grown.i), on_j = s * written(grown.j);
        const auto add = [&](int n) __attribute__((always_inline)) {
            swelling[to_j[k + n]] += on_j[n];
            swelling[to_i[k + n]] += on_i[n];
        };
        if (__builtin_expect(known == 0, 1)) {
#pragma clang loop unroll(full)
            for (int n = 0; n < lanes; n++) add(n);
        } else {
            for (int n = known; n < lanes; n++) add(n);
        }
        marking.mark(k, known, a, b, ends, columns);
    });
}

#endif

}  // namespace bondem
