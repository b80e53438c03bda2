#pragma once
#include "../../tables/quasistatic_tables.hpp"

namespace bondem {

// Finds the load factors at which whole facets of the material begin to crack and to soften.
Index find_stress_factors(Index threads, const LoadedFacets &loaded, const OnsetSearch &search);

}  // namespace bondem
