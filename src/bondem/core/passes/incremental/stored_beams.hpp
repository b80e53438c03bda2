#pragma once
#include "../../steps.hpp"
#include "../../tables/incremental_tables.hpp"

namespace bondem {

// Integrates the stored forces and moments of the beams of a block over the step, and adds them to the sums of their
// elements.
void add_stored_loads(const Turn &turn, const Moving &all, const Beams &beams, const StoredLoads &stored,
                      const StepCut &cut);
// Sums normal, shear, bending and twisting energy of a portion [J].
void sum_stored_energies(const Turn &turn, const Moving &all, const Beams &beams, const StoredLoads &stored,
                         const Portions &portions);
// Finds what each beam does to its elements in any poses.
Index load_stored_beams(Index threads, const Poses &all, const Beams &beams, const StoredLoads &stored,
                        const LoadsOfEach &loads);

}  // namespace bondem
