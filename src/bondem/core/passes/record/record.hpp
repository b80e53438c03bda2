// Declarations of passes that check the energy of a run or write its history, on the CPU or a GPU.
#pragma once
#include "../../steps.hpp"

namespace bondem {

// Sums kinetic energies and losses of a portion of elements [J].
void sum_element_energies(const Range &range, const Moving &all, const Ledger &ledger);
// Finds whether a number is not finite, or the kinetic energy is far above all energy supplied.
void judge_energy(const Range &range, const Rows &rows, const Ledger &ledger);
// Writes time and the entries of the energy balance.
void write_ledger(const Range &range, const Rows &rows, const Ledger &ledger, const HistoryRows &history);

}  // namespace bondem
