#pragma once
#include "../../tables/tessellation_tables.hpp"

namespace bondem {

// Computes the equation of each cell for given multipliers: its column sums of facet corrections.
Index apply_balance(Index threads, const CellBranches &branches, const BalanceField &field);

}  // namespace bondem
