// Passes that sum the derivatives of the energy by stress-free strains at active cracks (`strained_cracks.hpp`).
#include "../../registered.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/crack_tables.hpp"
#include "strained_cracks.hpp"

namespace bondem {
namespace {

void sum_powers(const Moving &all, const CellStrains &strains, const ElasticFacets &facets,
                const CohesiveCracks &cracks) {
    for (Index c = 0; c < cracks.size(crack_number::cracks); c++) {
        const Index k = cracks.order(c);
        if (history_of(cracks, k).status == crack::active)
            add_power_of_crack(all, strains, facets, cracks, k);
    }
}

}  // namespace

// Adds ∂U/∂factor of the stress-free strains at active cracks, in steps that need it.
void sum_crack_powers(const Range &, const Moving &all, const CellStrains &strains, const ElasticFacets &facets,
                      const CohesiveCracks &cracks) {
    if (strains.due(strain_due::power)) sum_powers(all, strains, facets, cracks);
}
BONDEM_PASS(sum_crack_powers, of_cracks, "ends pose")

// Adds ∂U/∂factor of the stress-free strains by the forces of active cracks, before the first step of a call.
void begin_crack_powers(const Range &range, const Moving &all, const CellStrains &strains,
                        const ElasticFacets &facets, const CohesiveCracks &cracks) {
    if (range.clock.first) sum_powers(all, strains, facets, cracks);
}
BONDEM_PASS(begin_crack_powers, of_cracks, "ends pose")

}  // namespace bondem
