#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/crack_tables.hpp"

namespace bondem {

// Finds the resting cracks that are about to soften or close, and treats them one by one again.
void watch_resting_cracks(const Turn &turn, const Moving &all, const ElasticFacets &facets,
                          const FacetStrengths &strengths, const CohesiveCracks &cracks, const CrackLists &lists);
void wake_cracks(const Turn &turn, const Moving &all, const ElasticFacets &facets, const CellDilatation &cells,
                 const CellSlack &slack, const CohesiveCracks &cracks, const CrackLists &lists);
// Lets integrities fall, and finds the cracks that go to rest.
void soften_cracks(const Turn &turn, const Moving &all, const ElasticFacets &facets, const FacetStrengths &strengths,
                   const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists);
// Lets the cracks rest or part that are to.
void leave_cracks(const Turn &turn, const Moving &all, const ElasticFacets &facets, const CellDilatation &cells,
                  const CellSlack &slack, const CohesiveCracks &cracks, const CrackLists &lists);
// Sums the forces of the cracks of each cell, and lets their faces slip by them.
void slide_cracks(const Turn &turn, const Moving &all, const ElasticFacets &facets, const StressesOfCells &stresses,
                  const CohesiveCracks &cracks, const CrackLists &lists);

}  // namespace bondem
