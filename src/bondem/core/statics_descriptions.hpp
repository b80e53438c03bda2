// How the tables of passes that seek equilibrium describe themselves to Python.
#pragma once
#include "passes/statics/dynamic_relaxation.hpp"
#include "step_descriptions.hpp"

namespace bondem {

}  // namespace bondem

// What `index.cpp` lists of them.
#define BONDEM_STATICS_PASSES \
    P(relax_beams, "balanced all_steps_done"), P(relax_alike_beams, "balanced all_steps_done")
