#pragma once
#include "../../tables/tessellation_tables.hpp"

namespace bondem {

enum CellEnd : Index { cells_made, crowded, narrow, swallowed, lists_full, pile_full };

// Cuts the cells of the chosen elements out of boxes about their centres: faces go to the pile, with what is behind them
// as tags. Returns how it ended, with the element in done[1]. After `lists_full` (found, offset, order) or `pile_full`
// make room and call again: it continues with cell done[0].
Index make_cells(Index threads, const Bins &centres, const CellRequest &request, const CellRoom &room,
                 const Pile &pile);

}  // namespace bondem
