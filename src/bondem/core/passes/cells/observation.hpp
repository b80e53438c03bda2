#pragma once
#include "../../tables/cell_tables.hpp"

namespace bondem {

// Turns vectors with their elements.
Index turn_vectors(Index threads, const TurnedVectors &all);
// Adds the moments sym b⊗f of forces about the centres of their owners, times a sign.
Index add_moments(Index threads, const MomentsOfForces &all);

}  // namespace bondem
