#pragma once
#include "../../tables/tessellation_tables.hpp"

namespace bondem {

// Areas, centroids and second moments of polygons.
Index measure_polygons(Index threads, const PolygonMeasures &polygons);
// Volumes and moments of solids.
Index measure_solids(Index threads, const Solids &solids, const Bulk &bulk);

}  // namespace bondem
