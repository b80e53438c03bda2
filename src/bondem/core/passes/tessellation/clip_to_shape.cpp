// Cells cut by the surface of a shape: split by the planes of all its triangles (walls) that reach into the cells.
//
// Each piece of a cell has a list of the wall triangles within the piece, cut to the piece. The plane of the largest
// triangle splits the piece and its other triangles (binary space partition). A piece without triangles lies on one
// side of every wall.
#include "../../registered.hpp"
#include "../../tables/tessellation_tables.hpp"
#include "section.hpp"

namespace bondem {
namespace {

enum Split : Index { all_split, pieces_full, scratch_full };

struct Box {
    Vector low, high;
};

// The box around solid s in space; the corners of the solid are relative to the centre x of its cell.
Box box_around(const Solids &solids, Index s, Vector x) {
    Box box = {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
    for (Index f = solids.face(s); f < solids.face(s + 1); f++)
        for (Vector v : face_polygon(solids, f))
            for (Index a = 0; a < 3; a++) {
                box.low[a] = least(box.low[a], v[a]);
                box.high[a] = most(box.high[a], v[a]);
            }
    return {box.low + x, box.high + x};
}

// Lists the triangles whose boxes meet a box, and returns their number; `found` contains as many as fit.
Index list_walls(const WallTree &walls, const Box &box, const Array<Index, 1> &found) {
    Index waiting[128], count = 1, listed = 0;
    waiting[0] = 1;
    while (count > 0) {
        const Index b = waiting[--count];
        bool apart = false;
        for (Index a = 0; a < 3; a++) apart = apart || walls.lower(b, a) > box.high[a] || walls.upper(b, a) < box.low[a];
        if (apart) continue;
        if (b >= walls.owner.size()) {
            if (listed < found.size()) found(listed) = walls.owner(b - walls.owner.size());
            listed++;
            continue;
        }
        waiting[count++] = 2 * b;
        waiting[count++] = 2 * b + 1;
    }
    return listed;
}

// Puts solid s on the empty pile with all wall triangles within it; returns false if the list of triangles is full.
bool put_whole(const Solids &solids, Index s, const WallTree &walls, const Splitting &splitting, const Stack &pile) {
    const Vector x = splitting.position.row<const Vector>(solids.cell(s));
    const Index first = solids.face(s), last = solids.face(s + 1);
    for (Index f = first; f < last; f++) pile.put(face_kind, solids.tag(f), face_plane(solids, f), face_polygon(solids, f));
    const Index listed = list_walls(walls, box_around(solids, s, x), splitting.found);
    if (listed > splitting.found.size()) return false;
    Buffer work(splitting.work), other(splitting.other);
    for (Index w = 0; w < listed; w++) {
        const Index t = splitting.found(w);
        Vector triangle[3];
        for (Index k = 0; k < 3; k++)
            triangle[k] = Vector{walls.corner(t, k, 0), walls.corner(t, k, 1), walls.corner(t, k, 2)} - x;
        work.take({triangle, 3});
        for (Index f = first; f < last && work.size > 0; f++) {
            Plane within = face_plane(solids, f);
            within.d = within.d - splitting.tolerance;  // what lies in a face of the cell splits nothing
            clip_within(work, other, within);
        }
        if (work.size == 0) continue;
        Plane wall = {walls.plane.row<const Vector>(t), 0.0};
        for (Index a = 0; a < 3; a++) wall.d += wall.normal[a] * triangle[0][a];
        pile.put(wall_kind, t, wall, work);
    }
    return true;
}

// Returns the number of the wall triangle with the largest area in a piece, or no_polygon.
Index largest_wall(const Stack &piece) {
    Index best = no_polygon;
    double largest = 0.0;
    for (Index p = 0; p < piece.size(); p++) {
        if (piece[p].kind != wall_kind) continue;
        const double size = piece[p].polygon.area();
        if (size > largest) {
            best = p;
            largest = size;
        }
    }
    return best;
}

// Moves the uppermost piece of a stack, its polygons from `first` on, to an empty pile.
void take_piece(const Stack &stack, Index first, const Stack &piece) {
    const Index corners = stack.first_corner(first);
    for (Index p = first; p < stack.size(); p++) piece.put(stack[p]);
    stack.cut_to(first, corners);
}

struct Splitter {
    const Solids &solids;
    const WallTree &walls;
    const Splitting &splitting;
    Stack stack, piece, done;

    // Splits solid s and puts its pieces on the pile, as long as there is room. Returns false if the scratch is full.
    bool split(Index s, Index &pieces) const {
        Buffer lid(splitting.lid), work(splitting.work), other(splitting.other);
        stack.clear();
        if (!put_whole(solids, s, walls, splitting, stack)) return false;
        Index waiting = 1, splits = 0;
        splitting.below(0) = 0;
        while (waiting > 0 && !stack.was_full()) {
            piece.clear();
            take_piece(stack, splitting.below(--waiting), piece);
            const Index wall = largest_wall(piece);
            if (wall == no_polygon) {
                if (!put_done(solids.cell(s), pieces)) return true;
                continue;
            }
            if (waiting + 2 > splitting.below.size()) return false;
            Plane plane = piece[wall].plane;
            cut_section(piece, plane, splitting.tolerance, lid, other);
            for (Index side = 0; side < 2; side++) {
                if (side == 1) {
                    plane = plane.turned();
                    lid.reverse();
                }
                const Index begin = stack.size();
                put_lower_part(piece, wall, plane, splitting.tolerance, stack, work);
                if (lid.size > 0) stack.put(face_kind, split_tag - 2 * splits - side, plane, lid);
                if (stack.size() > begin) splitting.below(waiting++) = begin;
            }
            splits++;
        }
        return !stack.was_full() && !piece.was_full();
    }
    // Puts the faces of the piece on the common pile; returns false if it is full.
    bool put_done(Index cell, Index &pieces) const {
        for (Index p = 0; p < piece.size(); p++)
            if (piece[p].kind == face_kind) done.put(piece[p]);
        if (pieces >= splitting.cell.size()) done.pile.used(Stack::full) = 1;
        if (done.was_full()) return false;
        splitting.cell(pieces) = cell;
        splitting.end(pieces) = done.size();
        pieces++;
        return true;
    }
};

}  // namespace

// Splits cells by walls: the faces of their pieces go to the pile. After `pieces_full` (the pile, cell, end) or
// `scratch_full` (stack, piece, found, below) make room and call again: it continues with solid done[0].
Index split_by_walls(Index, const Solids &solids, const WallTree &walls, const Splitting &splitting, const PolygonBuffer &stack,
                     const PolygonBuffer &piece, const PolygonBuffer &pile) {
    const Splitter splitter{solids, walls, splitting, {stack}, {piece}, {pile}};
    for (Index &s = splitting.done(0); s < solids.cell.size(); s++) {
        const Index faces = splitter.done.size(), corners = splitter.done.first_corner(faces);
        Index pieces = splitting.done(1);
        const bool room = splitter.split(s, pieces);
        if (!room || splitter.done.was_full()) {
            splitter.done.cut_to(faces, corners);
            return room ? pieces_full : scratch_full;
        }
        splitting.done(1) = pieces;
    }
    return all_split;
}
BONDEM_CALL(split_by_walls, "all_split pieces_full scratch_full")

}  // namespace bondem
