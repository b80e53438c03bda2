// Stress-free strains at cracks: ∂U/∂ε* = f · (R_j b_j - R_i b_i) with the force f of the crack, as of other facets.
#include "crack_strains.hpp"

#include "../cells/facets.hpp"
#include "../cells/strain_growth.hpp"
#include "crack_rows.hpp"

namespace bondem {
namespace {

void sum_powers(const Moving &all, const CellStrains &strains, const ElasticFacets &facets,
                const CohesiveCracks &cracks) {
    const Index count = strains.schedule.size();
    const FacetColumns columns(facets);
    for (Index g = 0; g < count; g++) strains.cracked(g) = 0.0;
    for (Index c = 0; c < cracks.size(0); c++) {
        const Index k = cracks.order(c);
        if (history_of(cracks, k).status != crack::active) continue;
        const OpenFacet<double> open = opened(ends_of(all.pose.data, facets, k), columns.shape<double>(k));
        const Vector f = {cracks.pull(k, 0), cracks.pull(k, 1), cracks.pull(k, 2)};
        const double each = dot(f, open.arm_j - open.arm_i) / growth_of(strains, k);
        for (Index g = 0; g < count; g++) strains.cracked(g) += each * strains.part(g, k);
    }
}

}  // namespace

void sum_crack_powers(const Turn &, const Moving &all, const CellStrains &strains, const ElasticFacets &facets,
                      const CohesiveCracks &cracks) {
    if (strains.due(0)) sum_powers(all, strains, facets, cracks);
}
void begin_crack_powers(const Turn &turn, const Moving &all, const CellStrains &strains, const ElasticFacets &facets,
                        const CohesiveCracks &cracks) {
    if (turn.clock.first) sum_powers(all, strains, facets, cracks);
}

}  // namespace bondem
