#pragma once
#include "../../steps.hpp"
#include "../../tables/non_local_tables.hpp"

namespace bondem {

// Turns the stresses of a step ago with their elements.
void turn_stresses(const Turn &turn, const Moving &all, const LaggedStresses &stresses);
// Adds to shared elements what bonds of other domains have for their stresses, and leaves zeros there.
void collect_moments(const Turn &turn, const StepCut &cut, const LaggedStresses &stresses);
// Finds the stresses of a portion, and bounds of their principal stresses; leaves zeros in the moments.
void find_stresses(const Turn &turn, const Moving &all, const LaggedStresses &stresses);
// Finds the stresses of the elements of a block, and bounds of their principal stresses; leaves zeros in the moments.
void find_stresses_of_block(const Turn &turn, const Moving &all, const LaggedStresses &stresses);
// Turns the stresses of all elements in any poses.
Index turn_all_stresses(Index threads, const Poses &all, const LaggedStresses &stresses);

}  // namespace bondem
