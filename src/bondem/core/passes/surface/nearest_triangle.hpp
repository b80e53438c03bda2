#pragma once
#include "../../tables/surface_tables.hpp"

namespace bondem {

// Finds the nearest triangle of each point.
Index find_nearest_triangles(Index threads, const TriangleTree &tree, const Nearest &nearest);

}  // namespace bondem
