// How the tables and passes of quasi-static loading describe themselves to Python.
#pragma once
#include "described_tables.hpp"
#include "passes/quasistatic/conjugate_gradients.hpp"
#include "passes/quasistatic/small_motion.hpp"
#include "passes/quasistatic/stress_onset.hpp"

namespace bondem {

#define BONDEM_QUASISTATIC_PASSES \
    P(open_weakened_facets, ""), P(load_weakened_facets, ""), P(find_stress_factors, ""), \
    P(conjugate_gradients, "converged stuck")

}  // namespace bondem
