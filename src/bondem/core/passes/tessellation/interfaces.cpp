// Interfaces between pieces of cells, by intersection of faces in one plane.
//
// Two pieces that face each other across a plane share the intersection of their faces. The rest of each face is
// free. Both the shared and the free parts are convex polygons (patches).
#include "../../registered.hpp"
#include "../../tables/tessellation_tables.hpp"
#include "pile.hpp"

namespace bondem {
namespace {

enum Matched : Index { all_matched, patches_full, rest_full };

constexpr Index nothing = -1;  // behind a patch
const Plane no_plane = {{0.0, 0.0, 0.0}, 0.0};

struct Matcher {
    const Solids &solids;
    const FaceGroups &groups;
    Stack done;

    // Plane h of a piece, measured from a point at -shift; the terms of the shift are added one after the other.
    Plane plane(Index h, Vector shift) const { return face_plane(solids, h).seen_from(shift); }

    // Divides the polygons of `rest` by the piece of face g: parts within the face become, if `wanted`, patches of
    // face f, and `left` has the other parts.
    void divide(const Stack &rest, const Stack &left, Index g, Vector shift, Index f, bool wanted) const {
        const Index q = groups.of_face(g), first = solids.face(q), last = solids.face(q + 1);
        Buffer work(groups.work), other(groups.other);
        left.clear();
        for (Index p = 0; p < rest.size(); p++) {
            const Polygon whole = rest[p].polygon;
            work.take(whole);
            for (Index h = first; h < last && work.size > 0; h++)
                if (h != g) clip_within(work, other, plane(h, shift));
            if (work.size == 0 || Polygon(work).area() <= groups.tolerance) {
                left.put(0, 0, no_plane, whole);
                continue;
            }
            if (wanted) done.put(f, g, no_plane, work);
            work.take(whole);
            for (Index h = first; h < last; h++) {
                if (h == g) continue;
                const Plane bound = added(h, shift);
                other.clip(work, bound.turned());
                if (other.size > 0 && Polygon(other).area() > groups.tolerance) left.put(0, 0, no_plane, other);
                clip_within(work, other, bound);
            }
        }
    }
    // Plane h of a piece, measured from a point at -shift, with the terms of the shift summed first.
    Plane added(Index h, Vector shift) const {
        const Plane plane = face_plane(solids, h);
        return {plane.normal, plane.d + dot(plane.normal, shift)};
    }

    // Intersects the faces of one side of group g with those of the other; side `plus` writes shared patches, too.
    bool lay(Index g, bool plus, const PolygonBuffer &one, const PolygonBuffer &two) const {
        const Array<const Index, 1> &mine = plus ? groups.plus : groups.minus;
        const Array<const Index, 1> &theirs = plus ? groups.minus : groups.plus;
        const Array<const Index, 1> &first = plus ? groups.first : groups.second;
        const Array<const Index, 1> &second = plus ? groups.second : groups.first;
        const double sign = plus ? 1.0 : -1.0;
        const Vector shift = sign * groups.shift.row<const Vector>(g);
        for (Index k = first(g); k < first(g + 1); k++) {
            const Index f = mine(k);
            const PolygonBuffer *rest = &one, *left = &two;
            Stack{*rest}.clear();
            Stack{*rest}.put(0, 0, no_plane, face_polygon(solids, f));
            for (Index h = second(g); h < second(g + 1); h++) {
                divide(Stack{*rest}, Stack{*left}, theirs(h), shift, f, plus);
                exchange(rest, left);
            }
            if (Stack{one}.was_full() || Stack{two}.was_full()) return false;
            const Stack free{*rest};
            for (Index p = 0; p < free.size(); p++)
                if (free[p].polygon.area() > groups.tolerance) done.put(f, nothing, no_plane, free[p].polygon);
        }
        return true;
    }
};

}  // namespace

// Intersects the faces of each group: patches go to the pile, with their face as kind and the face on the other side,
// or -1, as tag. After `patches_full` (the pile) or `rest_full` (rest, left) make room and call again: it continues
// with group done[0].
Index match_faces(Index, const Solids &solids, const FaceGroups &groups, const PolygonBuffer &rest, const PolygonBuffer &left,
                  const PolygonBuffer &pile) {
    const Matcher matcher{solids, groups, {pile}};
    for (Index &g = groups.done(0); g < groups.shift.size(); g++) {
        const Index size = matcher.done.size(), corners = matcher.done.first_corner(size);
        const bool room = matcher.lay(g, true, rest, left) && matcher.lay(g, false, rest, left);
        if (!room || matcher.done.was_full()) {
            matcher.done.cut_to(size, corners);
            return room ? patches_full : rest_full;
        }
    }
    return all_matched;
}
BONDEM_CALL(match_faces, "all_matched patches_full rest_full")

}  // namespace bondem
