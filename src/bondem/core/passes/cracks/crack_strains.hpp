#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/crack_tables.hpp"

namespace bondem {

// Sets ∂U/∂factor of the stress-free strains at cracks that are treated one by one, where it is needed.
void sum_crack_powers(const Turn &turn, const Moving &all, const CellStrains &strains, const ElasticFacets &facets,
                      const CohesiveCracks &cracks);
// Sets ∂U/∂factor of the stress-free strains by the forces that cracks have, where the time of the clock was not
// reached by a step.
void begin_crack_powers(const Turn &turn, const Moving &all, const CellStrains &strains, const ElasticFacets &facets,
                        const CohesiveCracks &cracks);

}  // namespace bondem
