// Completion of the list of active cracks for lanes (`crack_lists.cpp`).
#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/crack_tables.hpp"

namespace bondem {

// Repeats the last active crack, and the last of their cells, in the lanes after the end of their lists.
void fill_treated(const CrackLists &lists);

}  // namespace bondem
