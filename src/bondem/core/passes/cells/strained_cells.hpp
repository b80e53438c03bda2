// Facets and walls of cells with stress-free strains that change: levers, and derivatives of the energy by strains.
#pragma once
#include "../boundary/strain_factors.hpp"
#include "walls.hpp"

namespace bondem {

// Growth 1 + ε* of the levers of facet k, and of wall w, at the present factors.
inline double growth_of(const CellStrains &strains, Index k) {
    using namespace strain_factor;
    double sum = strains.still(k);
    for (Index g = 0; g < strains.schedule.size(); g++) sum += strains.factor(now, g) * strains.part(g, k);
    return sum;
}
inline double wall_growth(const CellStrains &strains, Index w) {
    double sum = strains.wall_still(w);
    for (Index g = 0; g < strains.schedule.size(); g++)
        sum += strains.factor(strain_factor::now, g) * strains.wall_part(g, w);
    return sum;
}

// Sets the levers of facet k at the present factors; `stretch_wall` sets that of wall w.
inline void stretch_facet(const CellStrains &strains, const ElasticFacets &facets, Index k) {
    const double grown = growth_of(strains, k);
    for (Index axis = 0; axis < 3; axis++) {
        facets.lever_i(axis, k) = int32_t(nearest(grown * strains.base_i(axis, k) / facets.pitch(axis)));
        facets.lever_j(axis, k) = int32_t(nearest(grown * strains.base_j(axis, k) / facets.pitch(axis)));
    }
}
inline void stretch_wall(const CellStrains &strains, const WallConstraints &walls, Index w) {
    const double grown = wall_growth(strains, w);
    for (Index axis = 0; axis < 3; axis++) walls.arm(w, axis) = grown * strains.wall_base(w, axis);
}

// Adds ∂U/∂factor of the facets first … last - 1, by the stresses in the poses.
inline void sum_powers(Index first, Index last, const double *pose, const CellStrains &strains,
                       const ElasticFacets &facets) {
    const Index count = strains.schedule.size();
    const FacetColumns columns(facets);
    for (Index k = first; k < last; k++) {
        const double s = facets.integrity(k);
        if (s <= 0.0) continue;
        const Row<double> i = gather(pose, facets.i(k)), j = gather(pose, facets.j(k));
        const Ends<double> ends = ends_of(i, j, facets.period.data);
        const FacetShape<double> shape = columns.shape<double>(k);
        const OpenFacet<double> open = opened(ends, shape);
        const Vector f = facet_pull(ends, shape, s * facets.k(k), stresses_of(i, j, s));
        const double each = dot(f, open.arm_j - open.arm_i) / growth_of(strains, k);
        for (Index g = 0; g < count; g++) exact_sum(strains.power, g).add_shared(each * strains.part(g, k));
    }
}

// Adds ∂U/∂factor of walls to that of facets and cracks, and then the work of the strains [J].
inline void take_work(const Moving &all, const CellStrains &strains, const WallConstraints &walls, double &work) {
    for (Index w = 0; w < strains.wall_still.size(); w++) {
        const Quaternion<double> q = orientation(gather(all.pose.data, Short(walls.cell(w))));
        const Vector arm = turned_by(q, walls.arm.row<const Vector>(w));
        const Vector f = {walls.load(w, 0), walls.load(w, 1), walls.load(w, 2)};
        const double each = dot(f, arm) / wall_growth(strains, w);
        for (Index g = 0; g < strains.schedule.size(); g++)
            exact_sum(strains.power, g).subtract(each * strains.wall_part(g, w));
    }
    take_work(strains, work);
}

}  // namespace bondem
