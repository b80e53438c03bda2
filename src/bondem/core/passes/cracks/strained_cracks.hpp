// Derivative ∂U/∂factor of the energy by the factor of a stress-free strain, at one crack (`cell_strains.cpp`).
#pragma once
#include "../cells/strained_cells.hpp"
#include "crack_rows.hpp"

namespace bondem {

// Adds ∂U/∂factor of each strain at the crack of facet k, by the force that the crack has [J].
inline void add_power_of_crack(const Moving &all, const CellStrains &strains, const ElasticFacets &facets,
                               const CohesiveCracks &cracks, Index k) {
    const OpenFacet<double> open = opened(ends_of(all.pose.data, facets, k), FacetColumns(facets).shape<double>(k));
    const Vector f = {cracks.pull(k, 0), cracks.pull(k, 1), cracks.pull(k, 2)};
    const double each = dot(f, open.arm_j - open.arm_i) / growth_of(strains, k);
    for (Index g = 0; g < strains.schedule.size(); g++) exact_sum(strains.power, g).add_shared(each * strains.part(g, k));
}

}  // namespace bondem
