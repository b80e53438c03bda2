// How the tables and passes of the damage pipeline describe themselves to Python.
#pragma once
#include "described_tables.hpp"
#include "passes/damage/beam_failure.hpp"
#include "passes/damage/beam_softening.hpp"
#include "passes/damage/pipeline.hpp"
#include "passes/damage/stress_criteria.hpp"

namespace bondem {

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
