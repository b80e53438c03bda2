// Tables of the passes that cut a shape into cells.
#pragma once
#include "../array.hpp"

namespace bondem {

// Centres of elements, sorted into boxes for the search of neighbours.
struct Bins {
    Array<const double, 2> position;  // centres [m], (n, 3)
    Array<const double, 1> radius;  // radii [m], (n,)
    Array<const double, 1> lower;  // lower corner of the box around all cells [m], (3,)
    Array<const double, 1> upper;  // upper corner of the box around all cells [m], (3,)
    Array<const double, 1> period;  // edge lengths of the periodic cell, or 0 [m], (3,)
    Array<const Index, 1> boxes;  // number of boxes along each axis, (3,)
    Array<const Index, 1> start;  // start of the members of each box, (boxes + 1,)
    Array<const Index, 1> member;  // elements, box by box, (n,)
    Array<const double, 1> bound;  // B of each element: no sphere at distance L has a radius above B + κ L [m], (n,)
    Array<const double, 1> first;  // initial search distance of neighbours, less in crowded boxes [m], (n,)
    double reach;  // usual distance of the farthest neighbour [m]
    double tolerance;  // depth to which planes do not cut [m]
};

// Convex solids, k of them, with f faces and v corners.
struct Solids {
    Array<const Index, 1> cell;  // element whose cell each solid is part of, (solids,)
    Array<const Index, 1> face;  // faces of solid s are face[s] … face[s + 1] - 1, (solids + 1,)
    // neighbour behind each face: an element; BOX - 0 … BOX - 5, sides of the box around the shape (x_min, x_max,
    // y_min …); LOCAL, an arbitrary end; or SPLIT - 2 s and SPLIT - 2 s - 1, both sides of split s of the cell
    Array<const Index, 1> tag;  // (faces,)
    Array<const double, 2> plane;  // outward unit normal and distance from the centre [-, m], (faces, 4)
    Array<const Index, 1> corner;  // corners of face g are corner[g] … corner[g + 1] - 1, (faces + 1,)
    Array<const double, 2> vertex;  // corners relative to the centre of the element [m], (corners, 3)
};

// Polygons in arrays with spare room. A pass that fills them ends; with larger ones it continues from there.
struct PolygonBuffer {
    Array<Index, 2> what;  // kind, tag, first corner and number of corners of each polygon, (*, 4)
    Array<double, 2> plane;  // outward unit normal and distance from the centre [-, m], (*, 4)
    Array<double, 2> vertex;  // corners [m], (*, 3)
    Array<Index, 1> used;  // number of polygons, number of corners, 1 where the arrays were full, (3,)
};

// The required cells, and lists in which their neighbours are sorted.
struct CellRequest {
    Array<const Index, 1> chosen;  // elements, (cells,)
    Array<const double, 1> half;  // half the edges of the boxes from which their cells are cut [m], (cells,)
    Array<Index, 1> found;  // elements listed, (room,)
    Array<double, 2> offset;  // vector from the centre to each listed element, and distance [m], (room, 4)
    Array<Index, 1> order;  // places in `found`, the nearest element first, (room,)
    Array<Index, 1> end;  // number of polygons up to the end of each cell, (cells + 1,)
    Array<Index, 1> done;  // number of cells made, and the element at which the pass ended, (2,)
};

// A cell under construction: face f has size[f] corners, from row f · MOST_CORNERS on.
struct CellRoom {
    Array<double, 2> plane;  // (402, 4)
    Array<Index, 1> tag;  // (402,)
    Array<Index, 1> size;  // (402,)
    Array<double, 2> vertex;  // (205824, 3)
    Array<double, 2> work;  // a polygon, (512, 3)
    Array<double, 2> other;  // a polygon, (512, 3)
};

// Wall triangles in a tree of boxes, for the search of those near a cell.
//
// Box 1 contains all triangles, box b contains boxes 2 b and 2 b + 1, and each of the last p boxes contains one
// triangle or none.
struct WallTree {
    Array<const double, 3> corner;  // of the triangles [m], (triangles, 3, 3)
    // unit normal of each and its product with a point of the plane [-, m]
    Array<const double, 2> plane;  // (triangles, 4)
    Array<const double, 2> lower;  // corners of the boxes [m], (boxes, 3)
    Array<const double, 2> upper;  // corners of the boxes [m], (boxes, 3)
    Array<const Index, 1> owner;  // the triangle in each of the last boxes, or -1, (leaves,)
};

// Data of the splitting of solids, and room for the pieces.
struct Splitting {
    Array<const double, 2> position;  // centres of all elements [m], (n, 3)
    double tolerance;  // depth below which a wall or plane splits nothing [m]
    Array<Index, 1> found;  // walls near a cell, (*,)
    Array<Index, 1> below;  // first polygon of each piece on the stack, (*,)
    Array<double, 2> lid;  // polygons, (512, 3)
    Array<double, 2> work;  // polygons, (512, 3)
    Array<double, 2> other;  // polygons, (512, 3)
    Array<Index, 1> cell;  // element whose cell each piece is part of, (pieces,)
    Array<Index, 1> end;  // number of polygons up to the end of each piece, (pieces,)
    Array<Index, 1> done;  // numbers of solids split and of pieces made, (2,)
};

// Solids, the elements among which they are divided, and room for the parts.
struct Dividing {
    Array<const double, 2> sphere;  // centres and radii of all elements [m], (n, 4)
    Array<const Index, 1> near;  // solid s is divided among near[start[s]] … near[start[s + 1] - 1], (claims,)
    Array<const Index, 1> start;  // start of the elements of each solid in `near`, (solids + 1,)
    double tolerance;  // depth below which a plane does not divide a solid [m]
    Array<double, 2> lid;  // polygons, (512, 3)
    Array<double, 2> work;  // polygons, (512, 3)
    Array<Index, 1> cell;  // element whose cell each part was cut from, (parts,)
    Array<Index, 1> owner;  // element to which each part belongs, (parts,)
    Array<Index, 1> end;  // number of polygons up to the end of each part, (parts,)
    Array<Index, 1> done;  // numbers of solids divided and of parts made, (2,)
};

// Faces in one plane: those of group g begin at plus[first[g]] on one side, at minus[second[g]] on the other.
struct FaceGroups {
    Array<const Index, 1> of_face;  // solid of each face, (faces,)
    Array<const Index, 1> plus;  // faces on one side, group by group, (forth,)
    Array<const Index, 1> first;  // start of each group in `plus`, (groups + 1,)
    Array<const Index, 1> minus;  // faces on the other side, group by group, (back,)
    Array<const Index, 1> second;  // start of each group in `minus`, (groups + 1,)
    // vector from the centre of the element on the plus side to that of the element on the minus side [m]
    Array<const double, 2> shift;  // (groups, 3)
    double tolerance;  // patches of less area are left out [m²]
    Array<double, 2> work;  // polygons, (512, 3)
    Array<double, 2> other;  // polygons, (512, 3)
    Array<Index, 1> done;  // number of groups matched, (1,)
};

// Polygons, and the measures of each.
struct PolygonMeasures {
    Array<const Index, 1> corner;  // corners of polygon q are corner[q] … corner[q + 1] - 1, (polygons + 1,)
    Array<const double, 2> vertex;  // corners [m], (corners, 3)
    Array<double, 1> area;  // [m²], (polygons,)
    Array<double, 2> centroid;  // [m], (polygons, 3)
    Array<double, 3> moment;  // second moments about the centroid [m⁴], (polygons, 3, 3)
};

// Volumes, moments and extents of solids, all about the centre of the element.
struct Bulk {
    Array<double, 1> volume;  // [m³], (solids,)
    Array<double, 2> first;  // ∫ x dV [m⁴], (solids, 3)
    Array<double, 3> second;  // ∫ x⊗x dV [m⁵], (solids, 3, 3)
    Array<double, 2> middle;  // a point inside, also of a thin solid [m], (solids, 3)
    Array<double, 1> farthest;  // distance of the farthest corner [m], (solids,)
    Array<double, 1> beyond;  // distance of the centre outside the solid, at most 0 if it lies inside [m], (solids,)
};

// Facets of each cell.
struct CellBranches {
    Array<const Index, 1> start;  // facets of cell p are start[p] … start[p + 1] - 1, (n + 1,)
    Array<const Short, 1> other;  // cell on the other side, (sides,)
    Array<const double, 2> branch;  // A / √W times the branch to the neighbour, W a weight [m^1.5], (sides, 3)
};

// A symmetric tensor of each cell, and the operator applied to it.
struct BalanceField {
    Array<const double, 2> given;  // components of the tensors, those off the diagonal times √2, (n, 6)
    Array<double, 2> found;  // components of the result, those off the diagonal times √2, (n, 6)
};

}  // namespace bondem
