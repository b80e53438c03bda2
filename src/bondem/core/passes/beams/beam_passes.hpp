// Declarations of passes over beams that other source files or a GPU call.
#pragma once
#include "../../steps.hpp"
#include "../../tables/beam_softening_tables.hpp"

namespace bondem {

// Counts unbroken beams of a portion beyond safe angles (c1 or c2 < 0.7, w² < 0.75) and valid ones (0, 0.25); c, w as
// in `laws/beam.hpp`. Reports poses that are not finite.
void check_beams(const Range &range, const Moving &all, const Beams &beams, const Ledger &ledger);
// Sums normal, shear, bending and twisting energy of the beams of a portion [J].
void sum_beam_energies(const Range &range, const Moving &all, const Beams &beams, const Ledger &ledger);
// Adds forces and torques of all beams in given poses to the rows of the sums.
Index load_beams(Index threads, const Poses &all, const Beams &beams, const BeamSums &to);
// Adds forces and torques of all beams in given poses, where the beams differ in length only.
Index load_uniform_beams(Index threads, const Poses &all, const Beams &beams, const UniformBeams &uniform,
                         const BeamSums &to);

}  // namespace bondem
