// How the tables of bonds that store something from step to step describe themselves to Python.
#pragma once
#include "passes/incremental/stored_beams.hpp"
#include "passes/non_local/element_stresses.hpp"
#include "passes/non_local/non_local_bonds.hpp"
#include "passes/non_local/pair_failure.hpp"
#include "passes/non_local/touch_moments.hpp"
#include "contact_descriptions.hpp"
#include "damage_descriptions.hpp"
#include "step_descriptions.hpp"

namespace bondem {

}  // namespace bondem

// What `index.cpp` lists of them.
#define BONDEM_LAGGED_LOADS                                                                             \
    P(load_stored_beams, ""), P(load_non_local_bonds, ""), P(find_small_extra_forces, ""),              \
        P(turn_all_stresses, ""), P(index_pairs, "")
#define BONDEM_LAGGED_PASSES                                                                            \
    S(bonds_of_blocks, add_stored_loads), S(of_bonds, sum_stored_energies),                             \
        S(of_elements, turn_stresses), S(bonds_of_blocks, find_non_local_forces),                       \
        S(parts_of_shared, collect_moments), S(of_elements, find_stresses),                             \
        S(bonds_of_blocks, add_non_local_loads), S(of_bonds, sum_non_local_energies),                   \
        S(bonds_of_blocks, add_lasting_loads), S(elements_of_blocks, find_stresses_of_block),           \
        S(serial, write_non_local_work), S(bonds_of_blocks, mark_pairs), S(bonds_of_blocks, judge_pairs), \
        S(serial, break_pairs), S(serial, relieve_pairs), S(of_ranges, add_pair_moments),               \
        S(of_elements, add_wall_moments), S(serial, add_begun_contacts)
