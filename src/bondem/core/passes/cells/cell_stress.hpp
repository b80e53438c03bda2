// Moments V σ of cells at the start of a run, on the CPU and on a device.
#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"

namespace bondem {

// Finds V σ of cells from stored forces at the start of a run, with the bits of the sums of a step.
void sum_moments(const Range &range, const Moving &all, const ElasticFacets &facets, const FacetsOfCells &of_cells,
                 const FacetForces &stored);

}  // namespace bondem
