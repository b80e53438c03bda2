// Convex polygons in space. Corners are in counter-clockwise order for a viewer to whom the normal points.
#pragma once
#include "../../array.hpp"
#include "../../vector3.hpp"

namespace bondem {

// Most corners of one polygon, and the room of a buffer that `clip` writes to.
constexpr Index most_corners = 512;

// The half-space n·x <= d, and the plane that bounds it.
struct Plane {
    Vector normal;
    double d;

    double height(Vector x) const { return normal.x * x.x + normal.y * x.y + normal.z * x.z - d; }
    Plane turned() const { return {-normal, -d}; }
    // Returns the plane for an origin at -x.
    Plane seen_from(Vector x) const { return {normal, d + normal.x * x.x + normal.y * x.y + normal.z * x.z}; }
};

struct Heights {
    double low, high;
};

struct Polygon {
    const Vector *corner;
    Index size;

    const Vector *begin() const { return corner; }
    const Vector *end() const { return corner + size; }
    // Lowest and highest corner over a plane [m].
    Heights over(const Plane &plane) const {
        Heights found = {infinity, -infinity};
        for (Vector x : *this) {
            const double s = plane.height(x);
            found = {least(found.low, s), most(found.high, s)};
        }
        return found;
    }
    double area() const {
        Vector sum = {0.0, 0.0, 0.0};
        for (Index k = 1; k < size - 1; k++) {
            const Vector p = corner[k] - corner[0], q = corner[k + 1] - corner[0];
            sum = sum + cross(p, q);
        }
        return 0.5 * length(sum);
    }
};

// A polygon in a buffer of its own, with room for most_corners.
struct Buffer {
    Vector *corner;
    Index size;

    explicit Buffer(const Array<double, 2> &room) : corner(&room.row<Vector>(0)), size(0) {
        require(room.size() >= most_corners);
    }
    operator Polygon() const { return {corner, size}; }
    void take(Polygon other) {
        require(other.size <= most_corners);
        size = other.size;
        for (Index k = 0; k < size; k++) corner[k] = other.corner[k];
    }
    void reverse() {
        for (Index k = 0; k < size / 2; k++) exchange(corner[k], corner[size - 1 - k]);
    }
    // Sets the buffer to the part of another polygon below a plane, empty with fewer than three corners.
    void clip(Polygon source, const Plane &plane) {
        size = 0;
        if (source.size == 0) return;
        Vector p = source.corner[source.size - 1];
        double sp = plane.height(p);
        for (Vector q : source) {
            const double sq = plane.height(q);
            if (size + 2 > most_corners) break;
            if ((sp <= 0.0) != (sq <= 0.0)) corner[size++] = plus(p, sp / (sp - sq), q - p);
            if (sq <= 0.0) corner[size++] = q;
            p = q;
            sp = sq;
        }
        if (size < 3) size = 0;
    }
    // Sets the buffer to a square of half-width `half` on a plane, about the foot of the origin.
    void square(const Plane &plane, double half) {
        const Vector n = plane.normal;
        Vector u = absolute(n.x) < 0.6 ? Vector{0.0, n.z, -n.y} : Vector{-n.z, 0.0, n.x};
        u = (half / length(u)) * u;
        const Vector w = cross(n, u), foot = plane.d * n;
        const double along[4] = {1.0, -1.0, -1.0, 1.0}, across[4] = {1.0, 1.0, -1.0, -1.0};
        for (int k = 0; k < 4; k++) corner[k] = plus(plus(foot, along[k], u), across[k], w);
        size = 4;
    }
};

// Cuts the polygon in `work` by a plane, by way of another buffer.
inline void clip_within(Buffer &work, Buffer &other, const Plane &plane) {
    other.clip(work, plane);
    work.take(other);
}

}  // namespace bondem
