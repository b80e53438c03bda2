#pragma once
#include "../../laws/criteria/bond_criteria.hpp"
#include "../../steps.hpp"
#include "../../tables/beam_softening_tables.hpp"

namespace bondem {

// Adds forces and torques of the beams of a block to the sums of their elements.
void add_beam_loads(const Turn &turn, const Moving &all, const Beams &beams, const StepCut &cut);
// Adds forces and torques of beams that differ in length only.
void add_alike_beam_loads(const Turn &turn, const Moving &all, const Beams &beams, const AlikeBeams &alike,
                          const StepCut &cut);
// Adds forces and torques of the beams of a block, and marks beams near to failure.
void add_marked_beam_loads(const Turn &turn, const Moving &all, const Beams &beams, const StepCut &cut,
                           const FailureBounds &bounds, const Candidates &candidates);
// Adds forces and torques of beams that differ in length only, and marks beams near to failure.
void add_marked_alike_beam_loads(const Turn &turn, const Moving &all, const Beams &beams, const AlikeBeams &alike,
                                 const StepCut &cut, const FailureBounds &bounds, const Candidates &candidates);
// Adds forces and torques of beams that may soften, with the pressure on softened ones. Those that reach their criterion
// lose integrity before their loads are added, and are listed as those that fail in this step.
#define BONDEM_DECLARED(_, name, Criterion)                                                                              \
    void add_beam_loads_softening_by_##name(const Turn &turn, const Moving &all, const Beams &beams, const StepCut &cut, \
                                            const SofteningBounds &bounds, const Candidates &candidates);                \
    void add_alike_beam_loads_softening_by_##name(const Turn &turn, const Moving &all, const Beams &beams,               \
                                                  const AlikeBeams &alike, const StepCut &cut,                           \
                                                  const SofteningBounds &bounds, const Candidates &candidates);
BONDEM_SOFTENING_CRITERIA(BONDEM_DECLARED, )
#undef BONDEM_DECLARED
// Adds forces and torques of all beams in any poses; rows of the sums are given.
Index load_beams(Index threads, const Poses &all, const Beams &beams, const BeamSums &to);
Index load_alike_beams(Index threads, const Poses &all, const Beams &beams, const AlikeBeams &alike, const BeamSums &to);
// Adds forces and torques of the dashpots of beams to sums of their own.
void add_dashpot_loads(const Turn &turn, const Moving &all, const Beams &beams, const Dashpots &dashpots,
                       const StepCut &cut);

}  // namespace bondem
