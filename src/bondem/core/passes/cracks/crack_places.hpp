// Cracks in the current configuration: position, axes, opening, criterion and softening, and the two halves of each
// cracked facet, one per cell. The functions are templates for one crack or for one crack per SIMD lane.
#pragma once
#include "crack_groups.hpp"

namespace bondem {

// A crack, or those of a group: poses and stresses of both cells, faces in space, compliance and state.
template <class T> struct CrackPlace {
    Ends<T> ends;
    OfCells<T> stress;  // of both cells [Pa]
    CrackFaces<T> now;
    FacetCompliance<T> facet;
    T area, friction, slips;
    Mask<T> isotropic;  // one integrity for all directions
    Row<T> state;
};
template <class Group, class T = typename Group::Number>
BONDEM_INLINE CrackPlace<T> place_of(const Group &group, const Array<double, 2> &pose, const double *period,
                                     const CohesiveCracks &cracks) {
    group.prefetch(cracks.shape, cracks.face, cracks.state, cracks.frame);
    const Row<T> a = gather(pose.data, group.i), b = gather(pose.data, group.j);
    const Ends<T> ends = ends_of(a, b, period);
    const Row<T> face = group.lines(cracks.face), frame = group.lines(cracks.frame);
    const T *const f = face.column, *const q = frame.column;
    CrackPlace<T> at = {ends, {a.column[stress_column], b.column[stress_column]}, {}, {f[6], f[3]}, f[4], f[5], f[7], {},
                        group.lines(cracks.state)};
    const T *const s = at.state.column;
    at.isotropic = s[7] == all<T>(double(crack::isotropic));
    const CrackIntegrity<T> left = {{q[4], q[5], q[6]}, q[7]};
    at.now = crack_faces(ends, group.shapes(cracks), {f[0], f[1], f[2]}, {q[0], q[1], q[2], q[3]}, left,
                         s[7] > T{}, {s[0], s[1], s[2]});
    return at;
}

// Roots of energies a step ago, stored as `past`. For an intact direction of a crack of the material, whose axes may have
// turned, the root follows from the force along it. The root of bending of an intact crack is the present one.
template <class T>
BONDEM_INLINE CrackRoots<T> roots_before(const FacetCompliance<T> &facet, const CrackFaces<T> &now, Mask<T> isotropic,
                                         const CrackHalves<T> &half, Vector3<T> pull, const CrackRoots<T> &roots,
                                         const CrackIntegrity<T> &before, const T *past) {
    const T one = all<T>(1.0), w = facet.part, grip = select(before.grip > T{}, before.grip, one);
    const Mask<T> of_material = opposite(isotropic);
    CrackRoots<T> found = {{}, select(of_material & (before.least_left() == one), roots.bent, past[3])};
    for (int d = 0; d < 3; d++) {
        const T along = dot(pull, now.at.e[d]) / (d == 0 ? one : grip), apart = half.i.along[d] - half.j.along[d];
        const T square = along * along + w * (one - w) * apart * apart;
        const T whole = signed_root(T(0.5 * square / facet.k), along);
        found.along[d] = select(of_material & (before.s[d] == one), whole, past[d]);
    }
    return found;
}

// Criterion and softening of the cracks of a group.
template <class T> struct CrackJudgement {
    Symmetric3<T> H;
    T bends, fastest;
    CrackStrength<T> by;
};
template <class Group, class T = typename Group::Number>
BONDEM_INLINE CrackJudgement<T> judgement_of(const Group &group, const CohesiveCracks &cracks) {
    group.prefetch(cracks.softening);
    const CrackSoftening<T> of = group.softening(cracks);
    const Mask<T> on_plane = of.plane > all<T>(0.5);
    PlaneStrength<T> more = {all<T>(infinity), T{}, T{}};
    if (any(on_plane)) {
        const Row<T> rows = group.lines(cracks.history);
        more = {rows.column[2], rows.column[3], rows.column[4]};
    }
    return {of.H, of.bends, of.fastest, {{of.strength, of.brittleness}, more, on_plane}};
}

// The mean stress of two cells, from the sum of rows of their stresses.
template <class T> BONDEM_INLINE Symmetric3<T> mean_stress(const Row<T> &both) {
    const auto mean = [&](int c) { return 0.5 * both.column[c]; };
    return {mean(0), mean(1), mean(2), mean(3), mean(4), mean(5)};
}
// Upper bound of the part of bending that opens a facet [Pa], because σ_3 is at most the least of the diagonal.
template <class T> BONDEM_INLINE T opened_at_most(T bent, const Symmetric3<T> &mean) {
    return positive(T(bent + least(least(least(mean.xx, mean.yy), mean.zz), T{})));
}

// Value of crack n of a group: of a mask, a vector, axes or integrities.
BONDEM_INLINE bool lane_of(bool mask, int) { return mask; }
#if defined(BONDEM_LANES)
BONDEM_INLINE bool lane_of(Mask<Lanes> mask, int n) { return mask[n] != 0; }
#endif
template <class Group, class T> Vector lane_of(const Group &group, const Vector3<T> &v, int n) {
    return {group.lane(v.x, n), group.lane(v.y, n), group.lane(v.z, n)};
}
template <class Group, class T> CrackAxes<double> lane_of(const Group &group, const CrackAxes<T> &at, int n) {
    return {{lane_of(group, at.e[0], n), lane_of(group, at.e[1], n), lane_of(group, at.e[2], n)}};
}
template <class Group, class T> CrackIntegrity<double> lane_of(const Group &group, const CrackIntegrity<T> &left, int n) {
    return {{group.lane(left.s[0], n), group.lane(left.s[1], n), group.lane(left.s[2], n)}, group.lane(left.grip, n)};
}

// A half of a crack as two rows of eight numbers in `CrackLists.half`.
template <class T> struct HalfRows {
    Row<T> first, second;
};
template <class T> BONDEM_INLINE HalfRows<T> rows_of(const SwellingHalf<T> &half) {
    const T *const p = half.pulled, *const a = half.along, *const l = half.loose, *const t = half.turns;
    return {{{half.swollen, half.inverse, p[0], p[1], p[2], a[0], a[1], a[2]}},
            {{l[0], l[1], l[2], half.grip, t[0], t[1], t[2], T{}}}};
}
template <class T> BONDEM_INLINE SwellingHalf<T> half_of(const HalfRows<T> &rows) {
    const T *const c = rows.first.column, *const d = rows.second.column;
    return {c[0], c[1], {c[2], c[3], c[4]}, {c[5], c[6], c[7]}, {d[0], d[1], d[2]}, d[3], {d[4], d[5], d[6]}, d[7]};
}
inline SwellingHalf<double> half_at(const CrackLists &lists, Index number) {
    return lists.half.row<SwellingHalf<double>>(number);
}
inline void put_halves_of(const CrackLists &lists, Index k, const FacetCompliance<double> &facet,
                          const CrackFaces<double> &at) {
    lists.half.row<SwellingHalf<double>>(half_of(k, 0)) = swelling_half(facet.k, facet.part, at, at.share_i);
    lists.half.row<SwellingHalf<double>>(half_of(k, 1)) = swelling_half(facet.k, 1.0 - facet.part, at, at.share_j);
}

}  // namespace bondem
