// Energies of beams of the incremental formulation, on the CPU and on a device.
#pragma once
#include "../../steps.hpp"
#include "../../tables/incremental_tables.hpp"

namespace bondem {

// Sums normal, shear, bending and twisting energy of a portion [J].
void sum_stored_energies(const Range &range, const Moving &all, const Beams &beams, const StoredLoads &stored,
                         const Ledger &ledger);

}  // namespace bondem
