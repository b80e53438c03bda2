#pragma once
#include "../../tables/tessellation_tables.hpp"

namespace bondem {

enum Matched : Index { all_matched, patches_full, rest_full };

// Lays the faces of each group over each other: patches go to the pile, with their face as kind and the face on the
// other side, or -1, as tag. After `patches_full` (the pile) or `rest_full` (rest, left) make room and call again: it
// continues with group done[0].
Index match_faces(Index threads, const Solids &solids, const FaceGroups &groups, const Pile &rest, const Pile &left,
                  const Pile &pile);

}  // namespace bondem
