#pragma once
#include "../../tables/tessellation_tables.hpp"

namespace bondem {

enum Division : Index { all_divided, parts_full, room_full };

// Divides solids among elements, each point to the one with the least power x² - R². After `parts_full` (the pile, cell,
// owner, end) or `room_full` (part, spare) make room and call again: it continues with solid done[0].
Index divide_solids(Index threads, const Solids &solids, const Dividing &dividing, const Pile &part, const Pile &spare,
                    const Pile &pile);

}  // namespace bondem
