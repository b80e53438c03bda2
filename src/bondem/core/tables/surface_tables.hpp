// What the search of the nearest triangle takes. Named once more in `bondem/geometry/triangles.py`.
#pragma once
#include "../array.hpp"

namespace bondem {

// Triangles, and a tree of boxes around pieces of them: box 1 holds all, box b boxes 2 b and 2 b + 1, and the last p
// boxes one piece each.
struct TriangleTree {
    Array<const double, 2> lower, upper;  // corners of the boxes [m], (2 p, 3)
    Array<const Index, 1> owner;  // which triangle each piece is of, (p,)
    Array<const double, 3> corner;  // of the triangles [m], (t, 3, 3)
    Array<const double, 3> side;  // from each corner to the next [m], (t, 3, 3)
    Array<const double, 2> normal;  // unit normals, 0 where there is none, (t, 3)
};

// Points, and the triangle nearest to each.
struct Nearest {
    Array<const double, 2> points;  // [m], (n, 3)
    Array<Index, 1> triangle;  // (n,)
};

}  // namespace bondem
