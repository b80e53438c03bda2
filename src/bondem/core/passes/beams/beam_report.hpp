// Counts and energies of beams for the guard and the history, on the CPU and on a device.
#pragma once
#include "../../steps.hpp"

namespace bondem {

// Counts unbroken beams of a portion turned wide (c1 or c2 below 0.7, or w² below 0.75) and lost (0 and 0.25).
void check_beams(const Range &range, const Moving &all, const Beams &beams, const Ledger &ledger);
// Sums normal, shear, bending and twisting energy of a portion [J].
void sum_beam_energies(const Range &range, const Moving &all, const Beams &beams, const Ledger &ledger);

}  // namespace bondem
