#pragma once
#include "../../laws/criteria/bond_criteria.hpp"
#include "../../steps.hpp"
#include "../../tables/damage_tables.hpp"

namespace bondem {

// Takes the dashpots of beams that fail off the kept sums of their ends; before the beams are removed.
void withdraw_dashpots(const Turn &turn, const Moving &all, const Beams &beams, const Dashpots &dashpots,
                       const Candidates &candidates, const Postponed &postponed);
// Removes the beams that fail.
void break_beams(const Turn &turn, const Moving &all, const Beams &beams, const BeamIntegrity &state,
                 const Candidates &candidates, const Postponed &postponed, const EventLog &log);
// Finds which of the marked beams of a block fail by a criterion, and holds their elements. The second function gives the
// index of every beam, in any poses.
#define BONDEM_DECLARED(_, name, Criterion)                                                                             \
    void judge_beams_by_##name(const Turn &turn, const Moving &all, const Beams &beams, const Strengths &strengths,     \
                               const Candidates &candidates, const Postponed &postponed);                               \
    Index index_beams_by_##name(Index threads, const Poses &all, const Beams &beams, const Strengths &strengths,        \
                                const FailureIndices &found);
BONDEM_BEAM_CRITERIA(BONDEM_DECLARED, )
#undef BONDEM_DECLARED

}  // namespace bondem
