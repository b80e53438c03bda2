// How the tables of cracks and of yielding describe themselves to Python.
#pragma once
#include "described.hpp"
#include "passes/cracks/crack_samples.hpp"

namespace bondem {

#define F BONDEM_FIELD

BONDEM_TABLE(SofteningSamples, F(traction, "3 m"), F(normal, "3 m"), F(stress, "6 m"), F(bent, "m"), F(integrity, "m"),
             F(strength, "6 m"), F(kink, ""), F(steep, ""), F(wide, ""), F(left, "2 m"))
BONDEM_TABLE(CrackSamples, F(given, "46 m"), F(wide, ""), F(found, "26 m"))
BONDEM_TABLE(YieldSamples, F(stress, "6 m"), F(strength, "4 m"), F(cone, ""), F(wide, ""), F(found, "11 m"))

#undef F

#define BONDEM_CRACK_TABLES described<SofteningSamples>(), described<CrackSamples>(), described<YieldSamples>()

}  // namespace bondem
