#pragma once
#include "../../tables/tessellation_tables.hpp"

namespace bondem {

enum Split : Index { all_split, pieces_full, scratch_full };

// Splits cells by walls: the faces of their pieces go to the pile. After `pieces_full` (the pile, cell, end) or
// `scratch_full` (stack, piece, found, below) make room and call again: it continues with solid done[0].
Index split_by_walls(Index threads, const Solids &solids, const WallTree &walls, const Splitting &splitting,
                     const Pile &stack, const Pile &piece, const Pile &pile);

}  // namespace bondem
