#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/crack_tables.hpp"

namespace bondem {

// Finds the resting cracks that are about to soften or close.
void watch_resting_cracks(const Turn &turn, const Moving &all, const ElasticFacets &facets,
                          const FacetStrengths &strengths, const CohesiveCracks &cracks, const CrackLists &lists);
// Treats resting cracks one by one again that are about to soften or close.
void wake_cracks(const Turn &turn, const Moving &all, const ElasticFacets &facets, const CellDilatation &cells,
                 const CellSlack &slack, const CohesiveCracks &cracks, const CrackLists &lists);
// Lowers the integrities of cracks, and finds those that go to rest.
void soften_cracks(const Turn &turn, const Moving &all, const ElasticFacets &facets, const FacetStrengths &strengths,
                   const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists);
// Puts cracks to rest, or parts their faces, as `soften_cracks` has found.
void leave_cracks(const Turn &turn, const Moving &all, const ElasticFacets &facets, const CellDilatation &cells,
                  const CellSlack &slack, const CohesiveCracks &cracks, const CrackLists &lists);
// Sums the forces of the cracks of each cell, and lets their faces slip by them.
void slide_cracks(const Turn &turn, const Moving &all, const ElasticFacets &facets, const StressesOfCells &stresses,
                  const CohesiveCracks &cracks, const CrackLists &lists);

}  // namespace bondem
