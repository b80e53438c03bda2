// Laguerre cells of spheres: the points whose power |x - c|² - R² is least for the sphere of centre c and radius R.
//
// A cell begins as a box and is cut by the radical plane of one neighbour after another, in the order of their
// distance. Every face is a polygon of its own, cut by planes, without a record of connections. Degenerate cases are
// therefore harmless, and volumes and areas are exact to rounding.
//
// ρ is the distance of the farthest corner of a cell from its centre, and R_max the largest radius. A neighbour at
// distance L cuts only if ½ (L - (R_max² - R²) / L) < ρ. The search ends at the first L that is too large, or earlier
// by a bound B of each element. No sphere at distance L from the element has a radius above B + κ L, with κ = ½.
#include "../../registered.hpp"
#include "../../tables/tessellation_tables.hpp"
#include "pile.hpp"

namespace bondem {
namespace {

// Endings: all cells made; too many faces; a neighbour half a period away; an empty cell; lists full; pile full.
enum CellEnd : Index { cells_made, crowded, narrow, swallowed, lists_full, pile_full };

// Most faces of one cell; `CellRoom` has room for two more.
constexpr Index most_faces = 400;
// κ in the bound B + κ L of the radii of spheres at the distance L from an element.
constexpr double slope = 0.5;
// Tags of faces without an element behind them: sides of the box around all cells, and arbitrary ends.
constexpr Index box_side = -1, local_end = -7;

struct Cell {
    const CellRoom &room;
    Index faces;

    Plane &plane(Index f) const { return room.plane.row<Plane>(f); }
    Vector *corners(Index f) const { return &room.vertex.row<Vector>(f * most_corners); }
    Polygon face(Index f) const { return {corners(f), room.size(f)}; }
    void set_face(Index f, Polygon polygon) const {
        require(polygon.size <= most_corners);
        room.size(f) = polygon.size;
        Vector *at = corners(f);
        for (Index k = 0; k < polygon.size; k++) at[k] = polygon.corner[k];
    }

    // A box about the centre of element i, not beyond the walls of the box around all.
    void begin(const Bins &centres, Index i, double half) {
        Buffer work(room.work), other(room.other);
        for (Index f = 0; f < 6; f++) {
            const Index axis = f / 2;
            const bool far = f % 2 == 1;
            const double at = centres.position(i, axis);
            double wall = infinity;
            if (centres.period(axis) == 0.0) wall = far ? centres.upper(axis) - at : at - centres.lower(axis);
            plane(f) = {{0.0, 0.0, 0.0}, least(wall, half)};
            plane(f).normal[axis] = far ? 1.0 : -1.0;
            room.tag(f) = wall <= half ? box_side - f : local_end;
        }
        for (Index f = 0; f < 6; f++) {
            work.square(plane(f), 2.0 * half);
            for (Index g = 0; g < 6; g++)
                if (g / 2 != f / 2) clip_within(work, other, plane(g));
            set_face(f, work);
        }
        faces = 6;
    }

    // Distance of the farthest corner from the centre [m].
    double radius() const {
        double far = 0.0;
        for (Index f = 0; f < faces; f++)
            for (Vector x : face(f)) far = most(far, dot(x, x));
        return root(far);
    }

    // Cuts the cell by the plane with the element `behind`; returns true if the plane reaches the cell. `faces` is 0
    // for an empty cell.
    bool cut(const Plane &by, Index behind, double farthest, double tolerance) {
        double deepest = -infinity;
        for (Index f = 0; f < faces; f++) deepest = most(deepest, face(f).over(by).high);
        if (deepest <= tolerance) return false;
        Buffer work(room.work), lid(room.other);
        lid.square(by, 1.01 * farthest);
        Index count = 0;
        for (Index f = 0; f < faces; f++) {
            const Heights height = face(f).over(by);
            // faces that meet the plane at an edge also bound the new face
            if (height.low <= tolerance && height.high >= -tolerance) clip_within(lid, work, plane(f));
            if (height.high > 0.0) {
                work.clip(face(f), by);
                if (work.size == 0) continue;
                set_face(count, work);
            } else if (count < f) {
                set_face(count, face(f));
            }
            plane(count) = plane(f);
            room.tag(count) = room.tag(f);
            count++;
        }
        if (lid.size > 0) {
            plane(count) = by;
            room.tag(count) = behind;
            set_face(count, lid);
            count++;
        }
        faces = count >= 4 ? count : 0;
        return true;
    }

    // True if a neighbour is half a period away, so that its other image may be a neighbour too.
    bool is_narrow(const Bins &centres, Index i) const {
        for (Index f = 0; f < faces; f++) {
            const Index j = room.tag(f);
            if (j < 0) continue;
            const double d = plane(f).d, ri = centres.radius(i), rj = centres.radius(j);
            const double apart = d + root(d * d - ri * ri + rj * rj);
            for (Index a = 0; a < 3; a++) {
                const double period = centres.period(a);
                if (period > 0.0 && absolute(plane(f).normal[a]) * apart > 0.4999999 * period) return true;
            }
        }
        return false;
    }
};

Index floor_division(Index a, Index b) { return a / b - (a % b != 0 && a < 0); }

// Lists the elements at distances from `near` up to `far` from element i [m], images included; returns how many there
// are; the lists contain as many as they have room for.
Index gather(const Bins &centres, Index i, double near, double far, const CellRequest &lists) {
    const Vector x = centres.position.row<const Vector>(i);
    Index low[3], high[3], listed = 0;
    for (Index a = 0; a < 3; a++) {
        const double width = (centres.upper(a) - centres.lower(a)) / double(centres.boxes(a));
        low[a] = Index(floor((x[a] - far - centres.lower(a)) / width));
        high[a] = Index(floor((x[a] + far - centres.lower(a)) / width));
        if (centres.period(a) == 0.0) {
            low[a] = most(low[a], Index(0));
            high[a] = least(high[a], centres.boxes(a) - 1);
        }
    }
    const Index boxes[3] = {centres.boxes(0), centres.boxes(1), centres.boxes(2)};
    Index at[3];
    for (at[0] = low[0]; at[0] <= high[0]; at[0]++)
        for (at[1] = low[1]; at[1] <= high[1]; at[1]++)
            for (at[2] = low[2]; at[2] <= high[2]; at[2]++) {
                Vector shift;
                Index box = 0;
                for (Index a = 0; a < 3; a++) {
                    const Index round = floor_division(at[a], boxes[a]);
                    box = box * boxes[a] + at[a] - round * boxes[a];
                    shift[a] = double(round) * centres.period(a);
                }
                for (Index k = centres.start(box); k < centres.start(box + 1); k++) {
                    const Index j = centres.member(k);
                    const Vector d = centres.position.row<const Vector>(j) + shift - x;
                    const double square = dot(d, d);
                    if (square >= far * far || square < near * near || square == 0.0) continue;
                    if (listed < lists.found.size()) {
                        lists.found(listed) = j;
                        lists.offset.row<Vector>(listed) = d;
                        lists.offset(listed, 3) = root(square);
                    }
                    listed++;
                }
            }
    return listed;
}

// Sorts the listed elements, the nearest first (Shell's method).
void sort_by_distance(const CellRequest &lists, Index listed) {
    for (Index p = 0; p < listed; p++) lists.order(p) = p;
    Index gap = 1;
    while (3 * gap + 1 < listed) gap = 3 * gap + 1;
    for (; gap > 0; gap /= 3)
        for (Index p = gap; p < listed; p++) {
            const Index o = lists.order(p);
            Index q = p;
            for (; q >= gap && lists.offset(lists.order(q - gap), 3) > lists.offset(o, 3); q -= gap)
                lists.order(q) = lists.order(q - gap);
            lists.order(q) = o;
        }
}

// True if no element at a distance or beyond cuts the cell, by the bounds B of the radii.
bool ends(double distance, double own, double bound, double farthest) {
    return (1.0 - slope * slope) * distance - 2.0 * slope * bound - (bound * bound - own) / distance >= 2.0 * farthest;
}

// Distance beyond which no element cuts the cell: the smaller one of two bounds, by the largest radius and by B.
double needed_distance(double own, double bound, double largest, double farthest) {
    const double ahead = slope * bound + farthest, left = 1.0 - slope * slope;
    const double near = (ahead + root(ahead * ahead + left * (bound * bound - own))) / left;
    return least(near, farthest + root(farthest * farthest + largest * largest - own));
}

// Cuts the cell of element i out of its box.
CellEnd shape(const Bins &centres, Index i, double half, double largest, const CellRequest &lists, Cell &cell) {
    cell.begin(centres, i, half);
    double farthest = cell.radius();
    const double own = centres.radius(i) * centres.radius(i), bound = centres.bound(i);
    const double surplus = largest * largest - own;
    double near = 0.0, far = centres.first(i);
    for (;;) {
        const Index listed = gather(centres, i, near, far, lists);
        if (listed > lists.found.size()) return lists_full;
        sort_by_distance(lists, listed);
        for (Index p = 0; p < listed; p++) {
            const Index o = lists.order(p), j = lists.found(o);
            const double distance = lists.offset(o, 3);
            if (0.5 * (distance - surplus / distance) >= farthest || ends(distance, own, bound, farthest)) break;
            const double d = 0.5 * (distance + (own - centres.radius(j) * centres.radius(j)) / distance);
            if (d >= farthest) continue;
            const Plane plane = {lists.offset.row<Vector>(o) / distance, d};
            if (!cell.cut(plane, j, farthest, centres.tolerance)) continue;
            if (cell.faces == 0) return swallowed;
            if (cell.faces > most_faces) return crowded;
            farthest = cell.radius();
        }
        const double needed = needed_distance(own, bound, largest, farthest);
        if (far >= needed) break;
        near = far;
        far = least(needed, 2.0 * far);
    }
    return cell.is_narrow(centres, i) ? narrow : cells_made;
}

}  // namespace

// Cuts the cells of the chosen elements out of boxes about their centres: faces go to the pile, with the element
// behind each face as its tag. Returns the outcome, with the element in done[1]. After `lists_full` (found, offset,
// order) or `pile_full` make room and call again: it continues with cell done[0].
Index make_cells(Index, const Bins &centres, const CellRequest &request, const CellRoom &room, const PolygonBuffer &pile) {
    const Stack faces{pile};
    double largest = 0.0;
    for (Index i = 0; i < centres.radius.size(); i++) largest = most(largest, centres.radius(i));
    Cell cell{room, 0};
    for (Index &q = request.done(0); q < request.chosen.size(); q++) {
        const Index i = request.chosen(q);
        request.done(1) = i;
        const CellEnd end = shape(centres, i, request.half(q), largest, request, cell);
        if (end != cells_made) return end;
        const Index size = faces.size(), corners = faces.first_corner(size);
        for (Index f = 0; f < cell.faces; f++) faces.put(0, room.tag(f), cell.plane(f), cell.face(f));
        if (faces.was_full()) {
            faces.cut_to(size, corners);
            return pile_full;
        }
        request.end(q + 1) = faces.size();
    }
    return cells_made;
}
BONDEM_CALL(make_cells, "cells_made crowded narrow swallowed lists_full pile_full")

}  // namespace bondem
