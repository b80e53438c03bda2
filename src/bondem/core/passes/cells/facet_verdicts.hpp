// Loads of one facet at the stresses in the poses, and the index of a criterion.
#pragma once
#include "../../laws/criteria/bond_criteria.hpp"
#include "../damage/pipeline.hpp"
#include "facets.hpp"

namespace bondem {

inline FacetLoads<double> loads_of(const double *pose, const ElasticFacets &facets, Index k) {
    const FacetColumns columns(facets);
    const Row<double> i = gather(pose, facets.i(k)), j = gather(pose, facets.j(k));
    const double s = facets.integrity(k);
    return facet_loads(ends_of(i, j, facets.period.data), columns.shape<double>(k), columns.stiffness(k, s),
                       stresses_of(i, j, s));
}

// A criterion sees the normal and the shear force of a facet.
template <class Criterion>
inline Verdict<double> verdict_of(const double *pose, const ElasticFacets &facets, const Strengths &strengths, Index k) {
    const Vector f = loads_of(pose, facets, k).force, n = present_normal(ends_of(pose, facets, k), normal_of(facets, k));
    const double along = -dot(f, n), *const c = &strengths.coefficient(k, 0);
    const double across = length(plus(f, along, n));
    return Criterion::verdict(BondLoads<double>{along, across, 0.0, 0.0, 0.0, 0.0},
                              Coefficients<double>{c[0], c[1], c[2], c[3]});
}

}  // namespace bondem
