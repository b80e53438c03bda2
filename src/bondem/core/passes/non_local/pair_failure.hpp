#pragma once
#include "../../tables/damage_tables.hpp"
#include "non_local_bonds.hpp"

namespace bondem {

// Marks the bonds of a block that reach their criterion by bounds of the principal stresses of both elements.
void mark_pairs(const Turn &turn, const Beams &beams, const LaggedStresses &stresses, const Strengths &strengths,
                const Candidates &candidates);
// Finds which of the marked bonds of a block fail, and holds their elements.
void judge_pairs(const Turn &turn, const Beams &beams, const LaggedStresses &stresses, const Strengths &strengths,
                 const Candidates &candidates, const Postponed &postponed);
// Removes the bonds that fail: their force from the kept sums, and the energy of their springs.
void break_pairs(const Turn &turn, const Moving &all, const Beams &beams, const NonLocalBonds &bonds,
                 const Candidates &candidates, const Postponed &postponed, const EventLog &log);
// Takes the force of bonds that fail out of the stresses of their elements, and sets their integrity to 0; after
// `break_pairs`.
void relieve_pairs(const Turn &turn, const Moving &all, const Beams &beams, const NonLocalBonds &bonds,
                   const LaggedStresses &stresses, const BeamIntegrity &state, const Candidates &candidates);
// Index of the criterion of every bond, by stresses in space.
Index index_pairs(Index threads, const Beams &beams, const LaggedStresses &stresses, const Strengths &strengths,
                  const FailureIndices &found);

}  // namespace bondem
