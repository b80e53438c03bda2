#pragma once
#include "../../steps.hpp"

namespace bondem {

// Sums kinetic energies and losses of a portion [J].
void sum_element_energies(const Turn &turn, const Moving &all, const Portions &portions);
// Finds whether a number is not finite, or the motion has more energy than can have come in.
void judge_energy(const Turn &turn, const Rows &rows, const Portions &portions);
// Writes time and the energy ledger.
void write_ledger(const Turn &turn, const Rows &rows, const Portions &portions, const HistoryRows &history);
// Writes three components of each gauge of elements.
void read_gauges(const Turn &turn, const Moving &all, const Rows &rows, const Gauges &gauges, const HistoryRows &history);

}  // namespace bondem
