#pragma once
#include "../../tables/quasistatic_tables.hpp"

namespace bondem {

// Finds the gaps of facets, and adds V θ to their cells.
Index open_weakened_facets(Index threads, const WeakenedFacets &facets, const SmallMotions &motions);
// Finds the loads of facets at the stresses of their cells, and adds their moments to those of the cells.
Index load_weakened_facets(Index threads, const WeakenedFacets &facets, const SmallMotions &motions,
                           const FacetLoading &loading);

}  // namespace bondem
