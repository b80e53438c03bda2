// Loads of one facet at the stresses in the poses, and the index of a failure criterion, which reaches 1 at failure.
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

// Index and mode of a facet by the normal and the shear part of `f`, the force on cell j [N].
template <class Criterion> inline Verdict<double> verdict_of(Vector f, Vector n, const Strengths &strengths, Index k) {
    const double along = -dot(f, n), across = length(plus(f, along, n));
    return Criterion::verdict(BondLoads<double>{along, across, 0.0, 0.0, 0.0, 0.0}, coefficients_of(strengths, k));
}
template <class Criterion>
inline Verdict<double> verdict_of(const double *pose, const ElasticFacets &facets, const Strengths &strengths, Index k) {
    const Vector n = present_normal(ends_of(pose, facets, k), normal_of(facets, k));
    return verdict_of<Criterion>(loads_of(pose, facets, k).force, n, strengths, k);
}

}  // namespace bondem
