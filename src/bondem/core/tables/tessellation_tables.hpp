// What the passes that cut a shape into cells take. Named once more where they are filled, in `bondem/specimen/tessellation/`.
#pragma once
#include "../array.hpp"

namespace bondem {

// Centres sorted into boxes, to find neighbours.
struct Bins {
    Array<const double, 2> position;  // centres [m], (n, 3)
    Array<const double, 1> radius;  // [m], (n,)
    Array<const double, 1> lower, upper;  // the box around all cells [m], (3,)
    Array<const double, 1> period;  // edge lengths of the periodic cell, or 0 [m], (3,)
    Array<const Index, 1> boxes;  // along each axis, (3,)
    Array<const Index, 1> start;  // where the members of each box begin, (boxes + 1,)
    Array<const Index, 1> member;  // elements, box by box, (n,)
    Array<const double, 1> bound;  // B: no sphere at distance L has a radius above B + κ L [m], (n,)
    Array<const double, 1> first;  // distance to which neighbours are looked for at first [m], (n,)
    double reach;  // usual distance of the farthest neighbour [m]
    double tolerance;  // depth to which planes do not cut [m]
};

// Convex solids, k of them, with f faces and v corners; see `bondem/specimen/tessellation/solids.py`.
struct Solids {
    Array<const Index, 1> cell;  // of which element's cell each is part, (k,)
    Array<const Index, 1> face;  // faces of solid s are face[s] … face[s + 1] - 1, (k + 1,)
    Array<const Index, 1> tag;  // what is behind each face, (f,)
    Array<const double, 2> plane;  // outward unit normal and distance from the centre [-, m], (f, 4)
    Array<const Index, 1> corner;  // corners of face g are corner[g] … corner[g + 1] - 1, (f + 1,)
    Array<const double, 2> vertex;  // corners, from the centre of the element [m], (v, 3)
};

// Polygons one after another, with room for more. A full pile takes no more and says so: its caller ends, Python makes
// room, and what was begun is done again.
struct Pile {
    Array<Index, 2> what;  // kind, tag, first corner, number of corners, (p, 4)
    Array<double, 2> plane;  // (p, 4)
    Array<double, 2> vertex;  // (v, 3)
    Array<Index, 1> used;  // polygons, corners, 1 where it was full, (3,)
};

// Which cells are wanted, and the lists in which neighbours are sorted.
struct CellRequest {
    Array<const Index, 1> chosen;  // elements, (k,)
    Array<const double, 1> half;  // half the widths of the boxes that their cells begin as [m], (k,)
    Array<Index, 1> found;  // elements listed, (room,)
    Array<double, 2> offset;  // from the centre to them, and distance [m], (room, 4)
    Array<Index, 1> order;  // the nearest first, (room,)
    Array<Index, 1> end;  // polygons up to the end of each cell, (k + 1,)
    Array<Index, 1> done;  // cells made; the element at which it ended, (2,)
};

// A cell in the making: face f has size[f] corners, from row f · 512 on.
struct CellRoom {
    Array<double, 2> plane;  // (faces, 4)
    Array<Index, 1> tag, size;  // (faces,)
    Array<double, 2> vertex;  // (faces · 512, 3)
    Array<double, 2> work, other;  // polygons, (512, 3)
};

// Walls as triangles in a tree of boxes; see `bondem/specimen/tessellation/shape_walls.py`.
struct WallTree {
    Array<const double, 3> corner;  // of the triangles [m], (t, 3, 3)
    Array<const double, 2> plane;  // unit normal of each and its product with a point of the plane [-, m], (t, 4)
    Array<const double, 2> lower, upper;  // corners of the boxes [m], (boxes, 3)
    Array<const Index, 1> owner;  // the triangle in each of the last boxes, or -1
};

// How solids are split, and in what room.
struct Splitting {
    Array<const double, 2> position;  // centres of all elements [m], (n, 3)
    double tolerance;  // what reaches in less than this splits nothing [m]
    Array<Index, 1> found, below;  // walls near a cell; where each piece on the stack begins, (room,)
    Array<double, 2> lid, work, other;  // polygons, (512, 3)
    Array<Index, 1> cell, end;  // element of each piece, and its last polygon, (pieces,)
    Array<Index, 1> done;  // solids split, pieces made, (2,)
};

// Which solids are divided among which elements; the planes between them are splits of the cells.
struct Dividing {
    Array<const double, 2> sphere;  // centres and radii of all elements [m], (n, 4)
    Array<const Index, 1> near, start;  // solid s is divided among near[start[s]] … near[start[s + 1] - 1]
    double tolerance;  // planes that reach in less do not divide [m]
    Array<double, 2> lid, work;  // polygons, (512, 3)
    Array<Index, 1> cell, owner, end;  // element of whose cell each part is, its new element, and its last polygon
    Array<Index, 1> done;  // solids divided, parts made, (2,)
};

// Faces in one plane: of group g, from one side plus[first[g]] …, and from the other minus[second[g]] …
struct FaceGroups {
    Array<const Index, 1> of_face;  // the solid that each face is of, (f,)
    Array<const Index, 1> plus, first, minus, second;
    Array<const double, 2> shift;  // from the centre that corners of the first side are measured from to that of the
                                   // others [m], (groups, 3)
    double tolerance;  // patches of less area are left out [m²]
    Array<double, 2> work, other;  // polygons, (512, 3)
    Array<Index, 1> done;  // groups matched, (1,)
};

// Areas, centroids and second moments of polygons.
struct PolygonMeasures {
    Array<const Index, 1> corner;  // corners of polygon f are corner[f] … corner[f + 1] - 1, (f + 1,)
    Array<const double, 2> vertex;  // [m], (v, 3)
    Array<double, 1> area;  // [m²], (f,)
    Array<double, 2> centroid;  // [m], (f, 3)
    Array<double, 3> moment;  // about the centroid [m⁴], (f, 3, 3)
};

// Volumes and moments of solids, all about the centre of the element.
struct Bulk {
    Array<double, 1> volume;  // [m³], (k,)
    Array<double, 2> first;  // ∫ x dV [m⁴], (k, 3)
    Array<double, 3> second;  // ∫ x⊗x dV [m⁵], (k, 3, 3)
    Array<double, 2> middle;  // a point inside, however thin the solid is [m], (k, 3)
    Array<double, 1> farthest;  // distance of the farthest corner [m], (k,)
    Array<double, 1> beyond;  // how far the centre lies outside, at most 0 if it lies inside [m], (k,)
};

// The facets of each cell as the operator of the balanced shares takes them; see
// `bondem/specimen/tessellation/balanced_shares.py`.
struct CellBranches {
    Array<const Index, 1> start;  // facets of cell p are start[p] … start[p + 1] - 1, (n + 1,)
    Array<const Short, 1> other;  // cell on the other side, (2 m,)
    Array<const double, 2> branch;  // weighted branch A / √W times the branch to its neighbour [m^1.5], (2 m, 3)
};

// A symmetric tensor of each cell, xx, yy, zz, √2 xy, √2 xz, √2 yz, and the operator applied to it.
struct BalanceField {
    Array<const double, 2> given;  // (n, 6)
    Array<double, 2> found;  // (n, 6)
};

}  // namespace bondem
