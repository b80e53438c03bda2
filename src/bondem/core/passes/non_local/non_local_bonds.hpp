// Energies of bonds of the non-local law, on the CPU and on a device.
#pragma once
#include "../../steps.hpp"
#include "../../tables/non_local_tables.hpp"

namespace bondem {

// Sums normal and shear energy of the springs of a portion, and the work of extra forces [J].
void sum_non_local_energies(const Range &range, const Moving &all, const Beams &beams, const NonLocalBonds &bonds,
                            const Ledger &ledger);

}  // namespace bondem
