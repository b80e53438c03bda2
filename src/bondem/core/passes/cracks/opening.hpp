// Dilatation of cells without their active cracks, on the CPU and on a device.
#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/crack_tables.hpp"

namespace bondem {

// Stores V θ of cells without their active cracks, from their stresses and weights.
void begin_bases(const Range &range, const Moving &all, const CellDilatation &cells, const CrackLists &lists);

}  // namespace bondem
