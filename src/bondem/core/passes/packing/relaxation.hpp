#pragma once
#include "../../tables/packing_tables.hpp"

namespace bondem {

constexpr Index relaxation_block = 128;  // spheres whose sums are added first, whatever the number of threads

enum Relaxed : Index { converged, out_of_date, exhausted, loose };

// Minimises the overlap energy, as far as the neighbour lists are valid. Returns how it ended; after `out_of_date` make
// new lists and call again.
Index relax_spheres(Index threads, const Spheres &spheres, const PackingWalls &walls, const Near &near,
                    const Relaxing &relaxing);

}  // namespace bondem
