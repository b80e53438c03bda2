// Cut of a piece of a cell by a plane. The piece is a stack of its faces and of the wall triangles within it.
#pragma once
#include "pile.hpp"

namespace bondem {

// Kinds of the polygons of a piece: its faces, and the wall triangles within it.
constexpr Index face_kind = 0, wall_kind = 1;
// Number for no polygon of a piece.
constexpr Index no_polygon = -1;
// First tag of new faces: those on the sides of split s of a cell have split_tag - 2 s and split_tag - 2 s - 1.
constexpr Index split_tag = -16;

// Computes the section of a piece by a plane, in `section`.
inline void cut_section(const Stack &piece, const Plane &plane, double tolerance, Buffer &section, Buffer &other) {
    double far = 0.0;
    for (Index p = 0; p < piece.size(); p++)
        for (Vector x : piece[p].polygon) far = most(far, dot(x, x));
    section.square(plane, 1.01 * root(far));
    for (Index p = 0; p < piece.size(); p++) {
        const Piled face = piece[p];
        if (face.kind != face_kind) continue;
        const Heights height = face.polygon.over(plane);
        if (height.low <= tolerance && height.high >= -tolerance) clip_within(section, other, face.plane);
    }
}

// Puts the part of a piece below a plane on a pile, without its new face and without polygon `in_plane` in the plane.
inline void put_lower_part(const Stack &piece, Index in_plane, const Plane &plane, double tolerance, const Stack &pile,
                           Buffer &work) {
    for (Index p = 0; p < piece.size(); p++) {
        const Piled one = piece[p];
        const double low = one.polygon.over(plane).low;
        if (p == in_plane || low >= (one.kind == wall_kind ? -tolerance : 0.0)) continue;
        work.clip(one.polygon, plane);
        if (work.size > 0) pile.put(one.kind, one.tag, one.plane, work);
    }
}

}  // namespace bondem
