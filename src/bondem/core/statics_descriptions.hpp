// How the tables of passes that seek equilibrium describe themselves to Python.
#pragma once
#include "passes/statics/dynamic_relaxation.hpp"
#include "step_descriptions.hpp"

namespace bondem {

#define F BONDEM_FIELD

BONDEM_TABLE(DynamicRelaxation, F(pose, "n 8"), F(velocity, "n 6"), F(before, "n 6"), F(load, "n 6"), F(inverse, "n 2"),
             F(free, "n 6"), F(motion, "n 6"), F(memory, "2"), F(ramp, ""), F(length, ""), F(tolerance, ""), F(noise, ""))
BONDEM_TABLE(RelaxationSpan, F(first, ""), F(steps, ""), F(done, "1"), F(ratio, "1"))

#undef F

}  // namespace bondem

// What `index.cpp` lists of them.
#define BONDEM_STATICS_TABLES described<DynamicRelaxation>(), described<RelaxationSpan>()
#define BONDEM_STATICS_PASSES \
    P(relax_beams, "balanced all_steps_done"), P(relax_alike_beams, "balanced all_steps_done")
