// Areas, volumes and moments of polygons and solids: sums over triangles, and over tetrahedra with the centre.
#include "../../registered.hpp"
#include "../../tables/tessellation_tables.hpp"
#include "pile.hpp"

namespace bondem {
namespace {

// Sums of products of components.
struct Moments {
    double xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0, xz = 0.0, yz = 0.0;
};

inline void put_symmetric(const Array<double, 3> &matrix, Index k, const Moments &m) {
    matrix(k, 0, 0) = m.xx;
    matrix(k, 1, 1) = m.yy;
    matrix(k, 2, 2) = m.zz;
    matrix(k, 0, 1) = matrix(k, 1, 0) = m.xy;
    matrix(k, 0, 2) = matrix(k, 2, 0) = m.xz;
    matrix(k, 1, 2) = matrix(k, 2, 1) = m.yz;
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
        Moments m;
        for (Index k = start + 1; k < end - 1; k++) {
            const Vector p = polygons.vertex.row<const Vector>(k) - o, q = polygons.vertex.row<const Vector>(k + 1) - o;
            const double part = 0.5 * inverse * dot(cross(p, q), n);
            const Vector s = p + q;
            c = plus(c, part, s);
            m.xx += part * (p.x * p.x + s.x * s.x + q.x * q.x);
            m.yy += part * (p.y * p.y + s.y * s.y + q.y * q.y);
            m.zz += part * (p.z * p.z + s.z * s.z + q.z * q.z);
            m.xy += part * (p.x * p.y + s.x * s.y + q.x * q.y);
            m.xz += part * (p.x * p.z + s.x * s.z + q.x * q.z);
            m.yz += part * (p.y * p.z + s.y * s.z + q.y * q.z);
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
        Moments m;
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
                m.xx += part * (t.x * t.x + a.x * a.x + b.x * b.x + c.x * c.x);
                m.yy += part * (t.y * t.y + a.y * a.y + b.y * b.y + c.y * c.y);
                m.zz += part * (t.z * t.z + a.z * a.z + b.z * b.z + c.z * c.z);
                m.xy += part * (t.x * t.y + a.x * a.y + b.x * b.y + c.x * c.y);
                m.xz += part * (t.x * t.z + a.x * a.z + b.x * b.z + c.x * c.z);
                m.yz += part * (t.y * t.z + a.y * a.z + b.y * b.z + c.y * c.z);
            }
        }
        bulk.volume(s) = volume;
        bulk.farthest(s) = root(far);
        bulk.beyond(s) = beyond;
        bulk.middle.row<Vector>(s) = middle / double(most(corners, Index(1)));
        bulk.first.row<Vector>(s) = 0.25 * first;
        put_symmetric(bulk.second, s,
                      {0.05 * m.xx, 0.05 * m.yy, 0.05 * m.zz, 0.05 * m.xy, 0.05 * m.xz, 0.05 * m.yz});
    }
    return 0;
}
BONDEM_CALL(measure_solids, "")

}  // namespace bondem
