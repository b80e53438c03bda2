// How the tables of bonds that store something from step to step describe themselves to Python.
#pragma once
#include "passes/incremental/stored_beams.hpp"
#include "passes/non_local/element_stresses.hpp"
#include "passes/non_local/non_local_bonds.hpp"
#include "step_descriptions.hpp"

namespace bondem {

#define F BONDEM_FIELD

BONDEM_TABLE(StoredLoads, F(kb, "m"), F(history, "6 m"))
BONDEM_TABLE(LoadsOfEach, F(found, "9 m"))
BONDEM_TABLE(NonLocalBonds, F(area, "m"), F(kn, "m"), F(kt, "m"), F(normal, "3 m"), F(lever_i, "3 m"), F(lever_j, "3 m"),
             F(nu, ""), F(limited, ""), F(history, "7 m"), F(output, "9 m"))
BONDEM_TABLE(LaggedStresses, F(inverse, "n"), F(stress, "n 6"), F(space, "n 8"), F(moment, "* 8"), F(to_i, "m"))
BONDEM_TABLE(NonLocalWork, F(taken, "bond_portions"))
BONDEM_TABLE(SmallPairs, F(pairs, "m 2"), F(area, "m"), F(kt, "m"), F(nu, ""), F(limited, ""), F(normal, "m 3"),
             F(stress, "n 6"), F(gap, "m 3"))
BONDEM_TABLE(ExtraForces, F(force, "m 3"))

#undef F

}  // namespace bondem
