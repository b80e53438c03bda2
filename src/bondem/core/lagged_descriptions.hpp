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

#define F BONDEM_FIELD

BONDEM_TABLE(StoredLoads, F(kb, "m"), F(history, "6 m"))
BONDEM_TABLE(LoadsOfEach, F(found, "9 m"))
BONDEM_TABLE(NonLocalBonds, F(area, "m"), F(kn, "m"), F(kt, "m"), F(normal, "3 m"), F(lever_i, "3 m"),
             F(lever_j, "3 m"), F(nu, ""), F(limited, ""), F(history, "7 m"), F(output, "9 m"))
BONDEM_TABLE(LaggedStresses, F(inverse, "n"), F(stress, "n 6"), F(space, "n 8"), F(moment, "* 8"), F(to_i, "m"))
BONDEM_TABLE(NonLocalWork, F(taken, "bond_portions"))
BONDEM_TABLE(SmallPairs, F(pairs, "m 2"), F(area, "m"), F(kt, "m"), F(nu, ""), F(limited, ""), F(normal, "m 3"),
             F(stress, "n 6"), F(gap, "m 3"))
BONDEM_TABLE(ExtraForces, F(force, "m 3"))

#undef F

}  // namespace bondem

// What `index.cpp` lists of them.
#define BONDEM_LAGGED_TABLES                                                                                     \
    described<StoredLoads>(), described<LoadsOfEach>(), described<NonLocalBonds>(), described<LaggedStresses>(), \
        described<NonLocalWork>(), described<SmallPairs>(), described<ExtraForces>()
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
