#pragma once
#include "../../steps.hpp"

namespace bondem {

// Adds to the sums of shared elements what bonds of other domains have for them, and leaves zeros there.
void collect_sums(const Turn &turn, const StepCut &cut);
// Adds to the sums of shared elements what dashpots of other domains have for them, and leaves zeros there.
void collect_dashpots(const Turn &turn, const StepCut &cut, const Dashpots &dashpots);
// Adds the forces of dashpots to those of springs; they stay, as the power that they take is found later.
void add_dashpots(const Turn &turn, const StepCut &cut, const Dashpots &dashpots);

}  // namespace bondem
