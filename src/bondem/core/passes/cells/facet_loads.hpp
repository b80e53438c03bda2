#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"

namespace bondem {

// Adds forces and torques of the facets of a block to the sums of their cells, whose stresses are known.
void add_facet_loads(const Turn &turn, const Moving &all, const ElasticFacets &facets, const StepCut &cut);
// Adds and keeps the forces of the facets of a block, and adds up the moments V σ of their cells. A facet without
// integrity has no force, whatever was kept of it before.
void add_and_keep_facet_loads(const Turn &turn, const Moving &all, const ElasticFacets &facets, const FacetForces &kept,
                              const StepCut &cut);

}  // namespace bondem
