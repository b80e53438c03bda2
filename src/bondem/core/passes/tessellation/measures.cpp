// Areas, volumes and moments of polygons and solids: sums over triangles, and over tetrahedra from the centre of the
// element.
#include "../../registered.hpp"
#include "../../symmetric3.hpp"
#include "../../tables/tessellation_tables.hpp"
#include "pile.hpp"

namespace bondem {
namespace {

// Adds add(sum, a, b) to the sum of products of each two components a and b.
template <class Add> void add_products(Symmetric3<double> &sum, Add add) {
    add(sum.xx, 0, 0), add(sum.yy, 1, 1), add(sum.zz, 2, 2);
    add(sum.xy, 0, 1), add(sum.xz, 0, 2), add(sum.yz, 1, 2);
}

void put_symmetric(const Array<double, 3> &matrix, Index k, const Symmetric3<double> &m) {
    const double all[9] = {m.xx, m.xy, m.xz, m.xy, m.yy, m.yz, m.xz, m.yz, m.zz};
    for (Index c = 0; c < 9; c++) (&matrix(k, 0, 0))[c] = all[c];
}

}  // namespace

// Computes areas, centroids and second moments of polygons.
Index measure_polygons(Index, const PolygonMeasures &polygons) {
    for (Index f = 0; f < polygons.area.size(); f++) {
        const Index start = polygons.corner(f), end = polygons.corner(f + 1);
        const Vector o = polygons.vertex.row<const Vector>(start);
        Vector n = {0.0, 0.0, 0.0};
        for (Index k = start + 1; k < end - 1; k++) {
            const Vector p = polygons.vertex.row<const Vector>(k) - o, q = polygons.vertex.row<const Vector>(k + 1) - o;
            n = n + cross(p, q);
        }
        const double size = length(n), area = 0.5 * size, inverse = size > 0.0 ? 1.0 / size : 0.0;
        polygons.area(f) = area;
        Vector c = {0.0, 0.0, 0.0};
        Symmetric3<double> m = {};
        for (Index k = start + 1; k < end - 1; k++) {
            const Vector p = polygons.vertex.row<const Vector>(k) - o, q = polygons.vertex.row<const Vector>(k + 1) - o;
            const double part = 0.5 * inverse * dot(cross(p, q), n);
            const Vector s = p + q;
            c = plus(c, part, s);
            add_products(m, [&](double &sum, Index i, Index j) {
                sum += part * (p[i] * p[j] + s[i] * s[j] + q[i] * q[j]);
            });
        }
        c = (2.0 * inverse / 3.0) * c;
        polygons.centroid.row<Vector>(f) = o + c;
        put_symmetric(polygons.moment, f,
                      {m.xx / 12.0 - area * c.x * c.x, m.yy / 12.0 - area * c.y * c.y, m.zz / 12.0 - area * c.z * c.z,
                       m.xy / 12.0 - area * c.x * c.y, m.xz / 12.0 - area * c.x * c.z, m.yz / 12.0 - area * c.y * c.z});
    }
    return 0;
}
BONDEM_CALL(measure_polygons, "")

// Computes volumes, moments and extents of solids about the centre of the element.
Index measure_solids(Index, const Solids &solids, const Bulk &bulk) {
    for (Index s = 0; s < bulk.volume.size(); s++) {
        double volume = 0.0, far = 0.0, beyond = -infinity;
        Vector middle = {0.0, 0.0, 0.0}, first = {0.0, 0.0, 0.0};
        Symmetric3<double> m = {};
        const Index corners = solids.corner(solids.face(s + 1)) - solids.corner(solids.face(s));
        for (Index f = solids.face(s); f < solids.face(s + 1); f++) {
            const Polygon face = face_polygon(solids, f);
            beyond = most(beyond, -face_plane(solids, f).d);
            for (Vector x : face) {
                far = most(far, dot(x, x));
                middle = middle + x;
            }
            for (Index k = 1; k < face.size - 1; k++) {
                const Vector a = face.corner[0], b = face.corner[k], c = face.corner[k + 1];
                const double part = dot(a, cross(b, c)) / 6.0;
                volume += part;
                const Vector t = a + b + c;
                first = plus(first, part, t);
                add_products(m, [&](double &sum, Index i, Index j) {
                    sum += part * (t[i] * t[j] + a[i] * a[j] + b[i] * b[j] + c[i] * c[j]);
                });
            }
        }
        bulk.volume(s) = volume;
        bulk.farthest(s) = root(far);
        bulk.beyond(s) = beyond;
        bulk.middle.row<Vector>(s) = middle / double(most(corners, Index(1)));
        bulk.first.row<Vector>(s) = 0.25 * first;
        put_symmetric(bulk.second, s, 0.05 * m);
    }
    return 0;
}
BONDEM_CALL(measure_solids, "")

}  // namespace bondem
