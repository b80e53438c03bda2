#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"

namespace bondem {

// Brings stress-free strains, and with them the levers of facets and walls, to the time of the clock.
void follow_cell_strains(const Turn &turn, const Timeline &timeline, const CellStrains &strains,
                         const ElasticFacets &facets, const WallConstraints &walls);
// Finds ∂U/∂factor by the stresses in the poses, where the time of the clock was not reached by a step.
void begin_strain_work(const Turn &turn, const Moving &all, const CellStrains &strains, const ElasticFacets &facets,
                       const WallConstraints &walls);
// Sums ∂U/∂factor of the facets of a portion, where it is needed.
void sum_strain_powers(const Turn &turn, const Moving &all, const CellStrains &strains, const ElasticFacets &facets);
// Adds the work of strains that have changed, when the forces after that are known.
void add_strain_work(const Turn &turn, const Moving &all, const CellStrains &strains, const WallConstraints &walls,
                     const Rows &rows);

}  // namespace bondem
