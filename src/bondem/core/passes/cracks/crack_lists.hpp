#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/crack_tables.hpp"

namespace bondem {

// Repeats the last crack of the list of cracks that are treated one by one, for lanes after it.
void fill_treated(const CrackLists &lists);

}  // namespace bondem
