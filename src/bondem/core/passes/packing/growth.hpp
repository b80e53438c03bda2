#pragma once
#include "../../tables/packing_tables.hpp"

namespace bondem {

enum Grown : Index { grown, list_out_of_date, too_many_events };

// Lets spheres fly and grow, as far as the neighbour lists are valid; all are advanced to the end. Returns how it ended;
// after `list_out_of_date` make new lists and call again. Without a grid of depths.
Index fly_and_grow(Index threads, const Spheres &spheres, const PackingWalls &walls, const Near &near,
                   const Growing &growing, const Flight &flight);

}  // namespace bondem
