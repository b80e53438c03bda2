#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"

namespace bondem {

// Adds to the sums of moments of shared cells what facets of other domains have for them, and leaves zeros there.
void collect_facet_moments(const Turn &turn, const StepCut &cut, const FacetForces &kept);
// Sets V σ and Σ `bending_square` of cells, whose sums are complete and left at zero.
void take_moments(const Turn &turn, const FacetForces &kept);
// Finds V σ of cells from the forces that are kept, as a run begins, to the bits of the sums of a step.
void sum_moments(const Turn &turn, const Moving &all, const ElasticFacets &facets, const FacetsOfCells &of_cells,
                 const FacetForces &kept);

}  // namespace bondem
