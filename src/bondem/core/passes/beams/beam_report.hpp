#pragma once
#include "../../steps.hpp"

namespace bondem {

// Counts unbroken beams of a portion that are turned beyond the range of their energy, and beyond its end.
void check_beams(const Range &range, const Moving &all, const Beams &beams, const Ledger &ledger);
// Sums normal, shear, bending and twisting energy of a portion [J].
void sum_beam_energies(const Range &range, const Moving &all, const Beams &beams, const Ledger &ledger);

}  // namespace bondem
