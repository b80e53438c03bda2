// Loads of facets and walls in the kept sums of cells whose facets fail, on the CPU and on a device.
#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/damage_tables.hpp"

namespace bondem {

// Subtracts the loads that a failure changes, times a sign, from the kept sum of postponed cell p: loads of a facet
// if either of its cells loses a facet, and loads of walls if cell p loses one.
void take_off_changing(double sign, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                       const FacetRelease &release, const Postponed &postponed, Index p);
// Adds the loads after the failure to the kept sum of postponed cell p, and updates the loads of its walls.
void add_changed(const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                 const FacetRelease &release, const Postponed &postponed, Index p);

}  // namespace bondem
