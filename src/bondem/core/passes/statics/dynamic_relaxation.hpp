#pragma once
#include "../../tables/statics_tables.hpp"

namespace bondem {

enum RelaxationEnding : Index { balanced, all_steps_done };

// Takes steps until the forces of beams balance the loads; rows of the sums are those of the elements, and zero.
Index relax_beams(Index threads, const Beams &beams, const BeamSums &sums, const DynamicRelaxation &relaxation,
                  const RelaxationSpan &span);
// The same for beams that differ in length only.
Index relax_alike_beams(Index threads, const Beams &beams, const AlikeBeams &alike, const BeamSums &sums,
                        const DynamicRelaxation &relaxation, const RelaxationSpan &span);

}  // namespace bondem
