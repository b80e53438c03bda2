// The triangle nearest to each point, found by a tree of boxes. The nearer branch is searched first, and boxes
// farther away than the nearest triangle found so far are left out.
#include "../../registered.hpp"
#include "../../tables/surface_tables.hpp"
#include "../../threads.hpp"
#include "../../vector3.hpp"

namespace bondem {
namespace {

// Square of the distance of a point to a box [m²].
double to_box(const TriangleTree &tree, Index box, Vector x) {
    const Vector low = tree.lower.row<const Vector>(box), high = tree.upper.row<const Vector>(box);
    Vector d;
    for (Index a = 0; a < 3; a++) d[a] = most(most(low[a] - x[a], x[a] - high[a]), 0.0);
    return dot(d, d);
}

Vector at(const Array<const double, 3> &rows, Index t, Index k) { return {rows(t, k, 0), rows(t, k, 1), rows(t, k, 2)}; }

// Square of the distance of a point to a triangle [m²].
double to_triangle(const TriangleTree &tree, Index t, Vector x) {
    const Vector normal = tree.normal.row<const Vector>(t);
    double nearest = infinity;
    bool inside = true;
    for (Index k = 0; k < 3; k++) {
        const Vector p = x - at(tree.corner, t, k), e = at(tree.side, t, k);
        const double along = within(dot(p, e) / most(dot(e, e), 1e-300), 0.0, 1.0);
        const Vector d = minus(p, along, e);
        nearest = least(nearest, dot(d, d));
        inside = inside && dot(cross(normal, e), p) > 0.0;
    }
    if (!inside) return nearest;
    const double height = dot(normal, x - at(tree.corner, t, 0));
    return height * height;
}

Index nearest_to(const TriangleTree &tree, Vector x) {
    Index waiting[128], count = 1, found = tree.owner(0);
    const Index pieces = tree.owner.size();
    double best = infinity;
    waiting[0] = 1;
    while (count > 0) {
        const Index box = waiting[--count];
        if (to_box(tree, box, x) >= best) continue;
        if (box >= pieces) {
            const Index t = tree.owner(box - pieces);
            const double d = to_triangle(tree, t, x);
            if (d < best) {
                best = d;
                found = t;
            }
            continue;
        }
        Index first = 2 * box, second = 2 * box + 1;
        if (to_box(tree, first, x) < to_box(tree, second, x)) exchange(first, second);
        waiting[count++] = first;
        waiting[count++] = second;
    }
    return found;
}

}  // namespace

// Finds the nearest triangle of each point.
Index find_nearest_triangles(Index threads, const TriangleTree &tree, const Nearest &nearest) {
    constexpr Index points_of_a_task = 256;
    for_each_in_tasks(threads, nearest.triangle.size(), points_of_a_task, [&](Index i) {
        nearest.triangle(i) = nearest_to(tree, nearest.points.row<const Vector>(i));
    });
    return 0;
}
BONDEM_CALL(find_nearest_triangles, "")

}  // namespace bondem
