#pragma once
#include "../../tables/crack_sample_tables.hpp"

namespace bondem {

// Evaluate laws over arrays, by single numbers or by lanes.
Index evaluate_softening(Index threads, const SofteningSamples &samples);
Index evaluate_cracks(Index threads, const CrackSamples &samples);
Index evaluate_yielding(Index threads, const YieldSamples &samples);
Index evaluate_stress_bounds(Index threads, const StressBoundSamples &samples);

}  // namespace bondem
