// Tables of the search for the triangle that is nearest to a point.
#pragma once
#include "../array.hpp"

namespace bondem {

// Triangles, and a tree of boxes around p pieces of them.
//
// Box 1 contains all pieces, box b contains boxes 2 b and 2 b + 1, and each of the last p boxes contains one piece.
struct TriangleTree {
    Array<const double, 2> lower;  // lower corners of the boxes [m], (boxes, 3)
    Array<const double, 2> upper;  // upper corners of the boxes [m], (boxes, 3)
    Array<const Index, 1> owner;  // triangle that each piece belongs to, (pieces,)
    Array<const double, 3> corner;  // corners of the triangles [m], (triangles, 3, 3)
    Array<const double, 3> side;  // from each corner to the next [m], (triangles, 3, 3)
    Array<const double, 2> normal;  // unit normals, 0 where there is none, (triangles, 3)
};

// Points, and the triangle nearest to each.
struct Nearest {
    Array<const double, 2> points;  // [m], (points, 3)
    Array<Index, 1> triangle;  // number of the nearest triangle, (points,)
};

}  // namespace bondem
