#pragma once
#include "../../steps.hpp"
#include "../../tables/beam_softening_tables.hpp"

namespace bondem {

// Adds forces and torques of all beams in any poses; rows of the sums are given.
Index load_beams(Index threads, const Poses &all, const Beams &beams, const BeamSums &to);
// Adds forces and torques of all beams in any poses that differ in length only.
Index load_uniform_beams(Index threads, const Poses &all, const Beams &beams, const UniformBeams &uniform,
                         const BeamSums &to);

}  // namespace bondem
