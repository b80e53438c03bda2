// Cracks in space, how they soften, and their halves: of one crack, or of as many as there are lanes.
#pragma once
#include "crack_groups.hpp"

namespace bondem {

// The faces of the cracks of a group, and what belongs to them.
template <class T> struct CrackPlace {
    Ends<T> ends;
    OfCells<T> stress;  // of both cells [Pa]
    FacedFaces<T> now;
    FacetCompliance<T> facet;
    T area, s, friction;
};
template <class Group, class T = typename Group::Number>
BONDEM_INLINE CrackPlace<T> place_of(const Group &group, const Array<double, 2> &pose, const double *period,
                                     const CohesiveCracks &cracks) {
    group.prefetch(cracks.shape);
    group.prefetch(cracks.face);
    const Row<T> a = gather(pose.data, group.i), b = gather(pose.data, group.j);
    const Ends<T> ends = ends_of(a, b, period);
    const Row<T> face = group.lines(cracks.face);
    const T *const f = face.column;
    return {ends, {a.column[stress_column], b.column[stress_column]},
            crack_faces(ends, group.shapes(cracks), {f[0], f[1], f[2]}), {f[7], f[3]}, f[4], f[5], f[6]};
}

// How the cracks of a group soften.
template <class T> struct CrackJudgement {
    Symmetric3<T> H;
    T bends, fastest;
    CrackStrength<T> by;
};
template <class Group, class T = typename Group::Number>
BONDEM_INLINE CrackJudgement<T> judgement_of(const Group &group, const CohesiveCracks &cracks) {
    group.prefetch(cracks.softening);
    T plane;
    const Symmetric3<T> H = group.resistances(cracks, &plane);
    const auto column = [&](int c) { return group.number(cracks.softening, c); };
    const Mask<T> on_plane = plane > all<T>(0.5);
    PlaneStrength<T> more = {all<T>(infinity), T{}, T{}};
    if (any(on_plane)) {
        const Row<T> rows = group.lines(cracks.history);
        more = {rows.column[2], rows.column[3], rows.column[4]};
    }
    return {H, column(4), column(6), {{column(7), column(5)}, more, on_plane}};
}

// The mean stress of two cells, from rows of their stresses.
template <class T> BONDEM_INLINE Symmetric3<T> mean_stress(const Row<T> &a, const Row<T> &b) {
    const auto mean = [&](int c) { return 0.5 * (a.column[c] + b.column[c]); };
    return {mean(0), mean(1), mean(2), mean(3), mean(4), mean(5)};
}
// A bound of what bending opens of a facet, without an angle: σ_3 is at most the least of the diagonal.
template <class T> BONDEM_INLINE T opened_at_most(T bent, const Symmetric3<T> &mean) {
    return positive(T(bent + least(least(least(mean.xx, mean.yy), mean.zz), T{})));
}

template <class T> BONDEM_INLINE Row<T> row_of(const SwellingHalf<T> &half) {
    return {{half.swollen, half.pulled, half.square, half.along, half.pressed, half.closed, half.loose, half.turns}};
}
template <class T> BONDEM_INLINE SwellingHalf<T> half_of(const Row<T> &row) {
    const T *const c = row.column;
    return {c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]};
}
template <class T> struct SwellingHalves {
    SwellingHalf<T> i, j;
};
template <class T>
BONDEM_INLINE SwellingHalves<T> swelling_halves(const FacetCompliance<T> &facet, T s, const CrackFaces<T> &at) {
    return {swelling_half(facet.k, facet.part, s, at.gap, at.share_i, at.normal),
            swelling_half(facet.k, T(1.0 - facet.part), s, at.gap, at.share_j, at.normal)};
}

}  // namespace bondem
