#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/crack_tables.hpp"

namespace bondem {

// Stores V θ of cells without their cracks.
void begin_bases(const Range &range, const Moving &all, const CellDilatation &cells, const CrackLists &lists);

}  // namespace bondem
