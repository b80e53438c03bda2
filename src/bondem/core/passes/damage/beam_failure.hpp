#pragma once
#include "../../steps.hpp"
#include "../../tables/damage_tables.hpp"

namespace bondem {

// Finds which of the marked beams of a block fail, and holds their elements.
void judge_beams_by_peripheral_stress(const Turn &turn, const Moving &all, const Beams &beams, const Strengths &strengths,
                                      const Candidates &candidates, const Postponed &postponed);
void judge_beams_by_mohr_coulomb(const Turn &turn, const Moving &all, const Beams &beams, const Strengths &strengths,
                                 const Candidates &candidates, const Postponed &postponed);
void judge_beams_by_linear_sum(const Turn &turn, const Moving &all, const Beams &beams, const Strengths &strengths,
                               const Candidates &candidates, const Postponed &postponed);
void judge_beams_by_ellipse(const Turn &turn, const Moving &all, const Beams &beams, const Strengths &strengths,
                            const Candidates &candidates, const Postponed &postponed);
// Takes the dashpots of beams that fail off the kept sums of their ends; before the beams are removed.
void withdraw_dashpots(const Turn &turn, const Moving &all, const Beams &beams, const Dashpots &dashpots,
                       const Candidates &candidates, const Postponed &postponed);
// Removes the beams that fail.
void break_beams(const Turn &turn, const Moving &all, const Beams &beams, const BeamIntegrity &state,
                 const Candidates &candidates, const Postponed &postponed, const EventLog &log);
// Index of the criterion of every beam, in any poses.
Index index_beams_by_peripheral_stress(Index threads, const Poses &all, const Beams &beams, const Strengths &strengths,
                                       const FailureIndices &found);
Index index_beams_by_mohr_coulomb(Index threads, const Poses &all, const Beams &beams, const Strengths &strengths,
                                  const FailureIndices &found);
Index index_beams_by_linear_sum(Index threads, const Poses &all, const Beams &beams, const Strengths &strengths,
                                const FailureIndices &found);
Index index_beams_by_ellipse(Index threads, const Poses &all, const Beams &beams, const Strengths &strengths,
                             const FailureIndices &found);

}  // namespace bondem
