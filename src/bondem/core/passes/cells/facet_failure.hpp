#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/damage_tables.hpp"

namespace bondem {

// Takes the loads that a failure changes, times a sign, off the kept sum of postponed cell p: those of its facets, where
// it or the other cell loses a facet, and those of its walls where it loses one.
void take_off_changing(double sign, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                       const FacetRelease &release, const Postponed &postponed, Index p);
// Adds them as they are after the failure; the loads of its walls are brought up to date.
void add_changed(const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                 const FacetRelease &release, const Postponed &postponed, Index p);

}  // namespace bondem
