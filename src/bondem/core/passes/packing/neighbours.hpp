#pragma once
#include "../../tables/packing_tables.hpp"

namespace bondem {

// Sorts spheres into the cells of their grid: fills `cell`, `first` and `member`.
Index sort_into_cells(Index threads, const SphereGrid &grid);
// Counts the spheres whose surfaces are at most `skin` apart: fills `start`.
Index count_neighbours(Index threads, const SphereGrid &grid);
// Lists them, (start[n],).
Index list_neighbours(Index threads, const SphereGrid &grid, const NeighbourLists &lists);

}  // namespace bondem
