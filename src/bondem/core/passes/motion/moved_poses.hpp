// Positions and orientations of elements as dual numbers (`dual.hpp`), whose derivatives are small motions.
#pragma once
#include "../../dual.hpp"
#include "elements.hpp"

namespace bondem {

// An orientation and its spin ω, by which a turned vector changes: (R b)' = ω × R b + R b'. This takes fewer
// operations than the derivative of each operation.
template <class S> struct Quaternion<Dual<S>> {
    Dual<S> w, x, y, z;
    Vector3<S> spin{};
};
template <class S> Quaternion<Dual<S>> product(Quaternion<Dual<S>>, Quaternion<Dual<S>>) = delete;  // without a spin
template <class S> Quaternion<Dual<S>> inverse(Quaternion<Dual<S>>) = delete;

template <class S> BONDEM_INLINE Vector3<Dual<S>> turned_by(Quaternion<Dual<S>> q, Vector3<Dual<S>> b) {
    const Quaternion<S> at = {q.w.v, q.x.v, q.y.v, q.z.v};
    const Vector3<S> r = turned_by(at, Vector3<S>{b.x.v, b.y.v, b.z.v}), turning = cross(q.spin, r);
    const Vector3<S> d = b.x.moves ? turning + turned_by(at, written(b)) : turning;
    return {{r.x, d.x}, {r.y, d.y}, {r.z, d.z}};
}
template <class S> BONDEM_INLINE Vector3<Dual<S>> rotate(Quaternion<Dual<S>> q, Vector3<Dual<S>> b) { return turned_by(q, b); }

// Poses of elements, and their motions: displacement, change of the stress of a cell, spin, 0.
struct MovedPoses {
    const double *pose, *motion;
};
template <class S> BONDEM_INLINE Row<Dual<S>> moved(const Row<S> &pose, const Row<S> &motion) {
    const S *const x = pose.column, *const d = motion.column;
    return {{{x[0], d[0]}, {x[1], d[1]}, {x[2], d[2]}, {x[3], d[3]}, {x[4], d[4]}, {x[5], d[5]}, {x[6], d[6]}, {x[7], d[7]}}};
}
template <class S> BONDEM_INLINE Quaternion<Dual<S>> orientation(const Row<Dual<S>> &moved) {
    const Dual<S> *const c = moved.column + 4;
    const Quaternion<S> q = {c[0].v, c[1].v, c[2].v, c[3].v};
    const Quaternion<S> d = product({S{}, 0.5 * c[0].d, 0.5 * c[1].d, 0.5 * c[2].d}, q);
    return {{q.w, d.w}, {q.x, d.x}, {q.y, d.y}, {q.z, d.z}, {c[0].d, c[1].d, c[2].d}};
}
BONDEM_INLINE Row<Dual<double>> gather(const MovedPoses &all, const Short &place) {
    return moved(gather(all.pose, place), gather(all.motion, place));
}
BONDEM_INLINE Row<double> gather(const Array<double, 2> &pose, const Short &place) { return gather(pose.data, place); }
// Types of the numbers in rows of poses: numbers, or duals.
template <class T> T number_in(const Row<T> &);
template <class Pose> using NumberOf = decltype(number_in(gather(*static_cast<const Pose *>(nullptr), Short())));

#if defined(BONDEM_LANES)
BONDEM_INLINE PairOfRows<Dual<Lanes>> gather(const MovedPoses &all, const Short *first, const Short *second) {
    const PairOfRows<Lanes> at = gather(all.pose, first, second), by = gather(all.motion, first, second);
    return {moved(at.first, by.first), moved(at.second, by.second)};
}
BONDEM_INLINE void prefetch(const MovedPoses &all, const Short *place) {
    prefetch(all.pose, place);
    prefetch(all.motion, place);
}
template <class Pose> using LanesOf =
    decltype(number_in(gather(*static_cast<const Pose *>(nullptr), static_cast<Short *>(nullptr), nullptr).first));
#endif

}  // namespace bondem
