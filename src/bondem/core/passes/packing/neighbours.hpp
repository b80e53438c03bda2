#pragma once
#include "../../tables/packing_tables.hpp"

namespace bondem {

// Sorts spheres into the cells of their grid: fills `cell`, `first`, `member` and `place`.
Index sort_into_cells(Index threads, const SphereGrid &grid);
// Sorts them, and counts for each the others whose surfaces are at most `skin` apart: fills `start`, too.
Index sort_and_count_neighbours(Index threads, const SphereGrid &grid);
// Lists them, (start[n],).
Index list_neighbours(Index threads, const SphereGrid &grid, const NeighbourLists &lists);

}  // namespace bondem
