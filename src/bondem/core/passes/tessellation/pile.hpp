// A stack of polygons in the arrays of a `PolygonBuffer`, and access to the faces of solids.
#pragma once
#include "../../tables/tessellation_tables.hpp"
#include "polygon.hpp"

namespace bondem {

struct Piled {
    Index kind, tag;
    Plane plane;
    Polygon polygon;
};

struct Stack {
    const PolygonBuffer &pile;

    enum { polygons, corners, full };

    Index size() const { return pile.used(polygons); }
    bool was_full() const { return pile.used(full) != 0; }
    void clear() const { cut_to(0, 0); }
    // Removes all polygons and corners beyond given numbers.
    void cut_to(Index size, Index vertices) const {
        pile.used(polygons) = size;
        pile.used(corners) = vertices;
    }
    void put(Index kind, Index tag, const Plane &plane, Polygon polygon) const {
        const Index p = pile.used(polygons), v = pile.used(corners);
        if (p + 1 > pile.what.size() || v + polygon.size > pile.vertex.size()) {
            pile.used(full) = 1;
            return;
        }
        pile.what(p, 0) = kind;
        pile.what(p, 1) = tag;
        pile.what(p, 2) = v;
        pile.what(p, 3) = polygon.size;
        pile.plane.row<Plane>(p) = plane;
        for (Index k = 0; k < polygon.size; k++) pile.vertex.row<Vector>(v + k) = polygon.corner[k];
        cut_to(p + 1, v + polygon.size);
    }
    void put(const Piled &piled) const { put(piled.kind, piled.tag, piled.plane, piled.polygon); }
    // The polygon at a place; it stays where it is until the pile is cut below it.
    Piled operator[](Index p) const {
        const Index size = pile.what(p, 3);
        const Vector *corner = size > 0 ? &pile.vertex.row<Vector>(pile.what(p, 2)) : nullptr;
        return {pile.what(p, 0), pile.what(p, 1), pile.plane.row<Plane>(p), {corner, size}};
    }
    Index first_corner(Index p) const { return p < size() ? pile.what(p, 2) : pile.used(corners); }
};

// Plane and polygon of face f of solids.
inline Plane face_plane(const Solids &solids, Index f) { return solids.plane.row<const Plane>(f); }
inline Polygon face_polygon(const Solids &solids, Index f) {
    const Index first = solids.corner(f), size = solids.corner(f + 1) - first;
    return {size > 0 ? &solids.vertex.row<const Vector>(first) : nullptr, size};
}

}  // namespace bondem
