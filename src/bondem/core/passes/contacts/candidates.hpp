#pragma once
#include "../../tables/contact_tables.hpp"
#include "../../tables/step_tables.hpp"

namespace bondem {

// Lists spheres of a sorted grid that are near and that no bond joins, and pairs of bonds that are wanted, with the memory
// of those that touch. Ends where there is no room for more.
Index list_pairs(Index threads, const SphereGrid &grid, const PairSources &from, const FoundPairs &found);
// Counts walls within the skin of each element.
Index count_wall_contacts(Index threads, const Poses &all, const Walls &walls, const WallSources &from);
// Lists them in their order, with the memory of those that touch.
Index list_wall_contacts(Index threads, const Poses &all, const Walls &walls, const WallSources &from, const FoundWalls &found);

}  // namespace bondem
