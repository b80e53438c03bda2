// How the tables and passes of the damage pipeline describe themselves to Python.
#pragma once
#include "described.hpp"
#include "passes/damage/beam_failure.hpp"
#include "passes/damage/beam_softening.hpp"
#include "passes/damage/pipeline.hpp"
#include "passes/damage/stress_criteria.hpp"

namespace bondem {

#define F BONDEM_FIELD

BONDEM_TABLE(FailureBounds, F(limit, "m"), F(of_force, ""), F(of_moment, ""))
BONDEM_TABLE(Strengths, F(coefficient, "bonds 4"), F(station, "bonds"))
BONDEM_TABLE(Candidates, F(begin, "blocks+1"), F(marked, "bonds"), F(mode, "bonds"), F(count, "blocks"), F(any, "1"))
BONDEM_TABLE(Postponed, F(held, "n"), F(element, "n"), F(row, "n"), F(first_row, ""), F(kept, "n 8"))
BONDEM_TABLE(EventLog, F(event, "bonds 10"), F(written, "2"), F(released, "1"), F(crushed, "1"))
BONDEM_TABLE(BeamIntegrity, F(integrity, "m"), F(hold, "*"))
BONDEM_TABLE(SofteningBounds, F(limit, "m"), F(of_force, ""), F(of_moment, ""), F(coefficient, "bonds 4"),
             F(station, "bonds"), F(tear, "bonds"), F(slide, "bonds"), F(integrity, "m"), F(hold, "*"), F(press, "m"),
             F(onset, "bonds 4"))
BONDEM_TABLE(SofteningBeams, F(row, "bonds 7"), F(begun, "1"), F(listed, "bonds"), F(number, "bond_portions"), F(parted, "bond_portions"), F(lost, "bond_portions"))
BONDEM_TABLE(FailureIndices, F(index, "m"))
BONDEM_TABLE(StressCandidates, F(bond, "candidates"), F(stress, "candidates 3 3"), F(found, "candidates"),
             F(number, "bond_portions"), F(total, "1"))
BONDEM_TABLE(StressFunction, F(address, ""), F(parameter, "parameters"))

#undef F

#define BONDEM_DAMAGE_TABLES \
    described<FailureBounds>(), described<Strengths>(), described<Candidates>(), described<Postponed>(), \
        described<EventLog>(), described<BeamIntegrity>(), described<SofteningBounds>(), described<SofteningBeams>(), described<FailureIndices>(), described<StressCandidates>(), described<StressFunction>()
#define BONDEM_JUDGED_BEAMS(_, name, Criterion) S(bonds_of_blocks, judge_beams_by_##name),
#define BONDEM_SOFTENING_LOADS(_, name, Criterion)              \
    S(bonds_of_blocks, add_beam_loads_softening_by_##name),     \
        S(bonds_of_blocks, add_alike_beam_loads_softening_by_##name),
#define BONDEM_DAMAGE_PASSES                                                                                          \
    BONDEM_BEAM_CRITERIA(BONDEM_JUDGED_BEAMS, )                                                                       \
    BONDEM_SOFTENING_CRITERIA(BONDEM_SOFTENING_LOADS, )                                                               \
    S(divides_elements, postpone_elements), S(postponed_of_blocks, keep_sums), S(postponed_of_blocks, keep_dashpots), \
        S(divides_elements, list_postponed), S(serial, write_released), S(bonds_of_blocks, add_marked_beam_loads),    \
        S(bonds_of_blocks, add_marked_alike_beam_loads), S(serial, withdraw_dashpots), S(serial, break_beams),        \
        S(serial, index_candidates_by_mean_stress), S(serial, index_candidates_by_cone),                              \
        S(serial, index_candidates_by_function), S(of_bonds, soften_beams), S(serial, log_softened_beams),            \
        S(serial, begin_softening), S(of_bonds, sum_pressed_energies), S(serial, write_crushing_of_beams)
#define BONDEM_INDEX_OF_BEAMS(_, name, Criterion) P(index_beams_by_##name, ""),
#define BONDEM_DAMAGE_INDICES                                                           \
    BONDEM_BEAM_CRITERIA(BONDEM_INDEX_OF_BEAMS, ) P(index_stresses_by_mean_stress, ""), \
        P(index_stresses_by_cone, ""), P(index_stresses_by_function, "")

}  // namespace bondem
