// Passes over cracks that are called by several source files or run on a device (GPU).
#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/crack_tables.hpp"
#include "../../tables/damage_tables.hpp"

namespace bondem {

// Repeats the last active crack, and the last of their cells, in the lanes after the end of their lists.
void fill_treated(const CrackLists &lists);
// Stores V θ of cells without their active cracks, from their stresses and weights.
void begin_bases(const Range &range, const Moving &all, const CellDilatation &cells, const CrackLists &lists);
// Adds the forces of active cracks to the sums of their cells.
void add_crack_loads(const Range &range, const Moving &all, const CrackLists &lists, const StepBlocks &blocks);
// Sums the energy of dilatation of a portion of cells by their stresses [J].
void sum_stressed_dilatation(const Range &range, const Moving &all, const CellDilatation &cells,
                             const Ledger &ledger);
// Sums the energy that the cells of a portion have dissipated by yielding [J].
void sum_heat(const Range &range, const StressesOfCells &stresses, const YieldingCells &cells,
              const Ledger &ledger);

}  // namespace bondem
