// What is written down of a facet as it becomes a crack: constants side by side, because cracks are anywhere in a table.
#pragma once
#include "single_cracks.hpp"

namespace bondem {

inline void write_levers(const ElasticFacets &facets, const CohesiveCracks &cracks, Index c) {
    const Index k = cracks.facet(c);
    double *const a = constants_of(cracks, c);
    for (Index d = 0; d < 3; d++) {
        a[d] = facets.pitch(d) * double(facets.lever_i(d, k));
        a[8 + d] = facets.pitch(d) * double(facets.lever_j(d, k));
    }
}

inline void write_constants(const ElasticFacets &facets, const FacetForces &kept, const FacetStrengths &strengths,
                            const CohesiveCracks &cracks, Index c) {
    const Index k = cracks.facet(c);
    cracks.i(c) = facets.i(k);
    cracks.j(c) = facets.j(k);
    write_levers(facets, cracks, c);
    double *const a = constants_of(cracks, c), *const b = a + 8, *const n = a + 16, *const h = a + 24, *const plane = a + 32;
    for (Index d = 0; d < 3; d++) {
        a[3 + d] = facets.share_i(d, k);
        b[3 + d] = facets.share_j(d, k);
        n[d] = facets.normal(d, k);
    }
    a[6] = facets.k(k), a[7] = strengths.part(k);
    b[6] = strengths.area(k), b[7] = strengths.friction(k);
    n[3] = kept.bends(k), n[4] = facets.k(k), n[5] = strengths.area(k);
    n[6] = strengths.brittleness(k), n[7] = strengths.fastest(k);
    for (Index d = 0; d < 6; d++) h[d] = facets.H(d, k);
    h[6] = strengths.plane(k), h[7] = 0.0;
    plane[0] = strengths.cohesion(k), plane[1] = strengths.slip_brittleness(k), plane[2] = strengths.friction(k);
}

}  // namespace bondem
