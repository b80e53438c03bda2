// Work of stress-free strains of cells, on the CPU and on a device.
#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"

namespace bondem {

// Sums ∂U/∂factor of the facets of a portion, where it is needed.
void sum_strain_powers(const Range &range, const Moving &all, const CellStrains &strains,
                       const ElasticFacets &facets);
// Adds the work of strains that have changed, once the forces after the change are known.
void add_strain_work(const Range &range, const Moving &all, const CellStrains &strains, const WallConstraints &walls,
                     const Rows &rows);

}  // namespace bondem
