// Loads of all beams in given poses, which solvers of statics call.
#pragma once
#include "../../steps.hpp"
#include "../../tables/beam_softening_tables.hpp"

namespace bondem {

// Adds forces and torques of all beams in given poses to the rows of the sums.
Index load_beams(Index threads, const Poses &all, const Beams &beams, const BeamSums &to);
// Adds forces and torques of all beams in given poses, where the beams differ in length only.
Index load_uniform_beams(Index threads, const Poses &all, const Beams &beams, const UniformBeams &uniform,
                         const BeamSums &to);

}  // namespace bondem
