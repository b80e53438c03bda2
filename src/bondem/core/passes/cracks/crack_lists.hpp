#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/crack_tables.hpp"

namespace bondem {

// Takes over the cracks of a state as a run begins: constants, weights of cells, lists, and what cracks carry.
void link_cracks(const Turn &turn, const ElasticFacets &facets, const FacetForces &kept,
                 const FacetStrengths &strengths,
                 const CohesiveCracks &cracks, const CrackLists &lists);
// Finds the weights of the cells of all cracks, as a run begins.
void weigh_cracked_cells(const Turn &turn, const ElasticFacets &facets, const CellDilatation &cells,
                         const CellSlack &slack, const CohesiveCracks &cracks);
// Takes over the levers of facets, where strains of cells have changed them.
void follow_levers(const Turn &turn, const CellStrains &strains, const ElasticFacets &facets, const CohesiveCracks &cracks);
// Repeats the last of the lists of cracks that are treated one by one, for lanes behind it.
void fill_treated(const CrackLists &lists);
// Makes the lists of cracks anew where they are out of date.
void list_cracks(const Turn &turn, const ElasticFacets &facets, const CohesiveCracks &cracks,
                 const CrackLists &lists);
// Sums b⊗f of the cracks of each cell from their forces of the last step.
void carry_cracks(const Turn &turn, const StressesOfCells &stresses, const CohesiveCracks &cracks,
                  const CrackLists &lists);

}  // namespace bondem
