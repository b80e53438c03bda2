// Division of pieces of cells that a wall separates from the centre of the cell. Each point of a piece goes to the
// element of least power |x - c|² - R², with centre c and radius R.
#include "../../registered.hpp"
#include "../../tables/tessellation_tables.hpp"
#include "section.hpp"

namespace bondem {
namespace {

enum Division : Index { all_divided, parts_full, room_full };

// First number of splits by radical planes, to which elements a < b add a n + b; splits by walls have smaller ones.
constexpr Index first_split = 10000000;

// The radical plane of elements a and b, its normal from a to b, measured from x.
Plane radical_plane(const Array<const double, 2> &sphere, Vector x, Index a, Index b) {
    const Vector at = sphere.row<const Vector>(a), apart = sphere.row<const Vector>(b) - at;
    const double distance = length(apart), ra = sphere(a, 3), rb = sphere(b, 3);
    const Vector normal = apart / distance, from = at - x;
    const double d = dot(normal, from);
    return {normal, d + 0.5 * (distance + (ra * ra - rb * rb) / distance)};
}

Heights heights_over(const Stack &part, const Plane &plane) {
    Heights found = {infinity, -infinity};
    for (Index f = 0; f < part.size(); f++) {
        const Heights one = part[f].polygon.over(plane);
        found = {least(found.low, one.low), most(found.high, one.high)};
    }
    return found;
}

// Returns the pile of the part of solid s whose power is least for `own` of the elements among which it is divided.
const PolygonBuffer &share_of(const Solids &solids, Index s, Index own, const Dividing &dividing, const PolygonBuffer &first,
                     const PolygonBuffer &second) {
    const Vector x = dividing.sphere.row<const Vector>(solids.cell(s));
    const Index n = dividing.sphere.size();
    Buffer lid(dividing.lid), work(dividing.work);
    const Stack part{first};
    part.clear();
    for (Index f = solids.face(s); f < solids.face(s + 1); f++)
        part.put(face_kind, solids.tag(f), face_plane(solids, f), face_polygon(solids, f));
    const PolygonBuffer *now = &first, *next = &second;
    for (Index k = dividing.start(s); k < dividing.start(s + 1); k++) {
        const Index other = dividing.near(k);
        if (other == own) continue;
        const Stack here{*now}, there{*next};
        const Plane plane = radical_plane(dividing.sphere, x, own, other);
        const Heights height = heights_over(here, plane);
        if (height.high <= dividing.tolerance) continue;
        if (height.low >= -dividing.tolerance) {
            here.clear();
            return *now;
        }
        cut_section(here, plane, dividing.tolerance, lid, work);
        there.clear();
        put_lower_part(here, no_polygon, plane, dividing.tolerance, there, work);
        if (lid.size > 0) {
            const Index pair = least(own, other) * n + most(own, other);
            there.put(face_kind, split_tag - 2 * (first_split + pair) - (own > other ? 1 : 0), plane, lid);
        }
        exchange(now, next);
    }
    return *now;
}

}  // namespace

// Divides solids among elements, each point to the element of least power x² - R². After `parts_full` (the pile,
// cell, owner, end) or `room_full` (part, spare) make room and call again: it continues with solid done[0].
Index divide_solids(Index, const Solids &solids, const Dividing &dividing, const PolygonBuffer &part, const PolygonBuffer &spare,
                    const PolygonBuffer &pile) {
    const Stack done{pile};
    for (Index &s = dividing.done(0); s < solids.cell.size(); s++) {
        const Index faces = done.size(), corners = done.first_corner(faces);
        Index parts = dividing.done(1);
        for (Index k = dividing.start(s); k < dividing.start(s + 1); k++) {
            const Index own = dividing.near(k);
            const Stack mine{share_of(solids, s, own, dividing, part, spare)};
            if (part.used(Stack::full) != 0 || spare.used(Stack::full) != 0) {
                done.cut_to(faces, corners);
                return room_full;
            }
            if (mine.size() < 4) continue;
            for (Index f = 0; f < mine.size(); f++) done.put(mine[f]);
            if (done.was_full() || parts >= dividing.cell.size()) {
                done.cut_to(faces, corners);
                return parts_full;
            }
            dividing.cell(parts) = solids.cell(s);
            dividing.owner(parts) = own;
            dividing.end(parts) = done.size();
            parts++;
        }
        dividing.done(1) = parts;
    }
    return all_divided;
}
BONDEM_CALL(divide_solids, "all_divided parts_full room_full")

}  // namespace bondem
