// Counts and energies of beams for the guard and the history, on the CPU and on a device.
#pragma once
#include "../../steps.hpp"

namespace bondem {

// Counts unbroken beams of a portion beyond safe angles (c1 or c2 < 0.7, w² < 0.75) and valid ones (0, 0.25); c, w as in
// `laws/beam.hpp`. Reports poses that are not finite.
void check_beams(const Range &range, const Moving &all, const Beams &beams, const Ledger &ledger);
// Sums normal, shear, bending and twisting energy of a portion [J].
void sum_beam_energies(const Range &range, const Moving &all, const Beams &beams, const Ledger &ledger);

}  // namespace bondem
