// Forces and energies of contacts, on the CPU and on a device.
#pragma once
#include "../../steps.hpp"
#include "../../tables/contact_tables.hpp"

namespace bondem {

// Adds forces and losses of contacts to those of the elements, and sets the former to zero.
void add_contact_loads(const Range &range, const Moving &all, const StepBlocks &blocks, const ContactSums &contacts);
// Sums the elastic energy of the pairs of a portion [J].
void sum_pair_energies(const Range &range, const Moving &all, const ContactConstants &law, const ContactPairs &pairs,
                       const Ledger &ledger);

}  // namespace bondem
