// Orientations as unit quaternions q = (w, x, y, z), for one element or for one element per SIMD lane.
//
// In a time step dt an element of angular velocity ω turns by the exponential map of the rotation vector r = ω dt:
//
//     q ← (cos h, sin h / h · r / 2) q,    h = |r| / 2
//
// For half angles h below 0.2 rad a series is exact to rounding. A larger h is halved until it is below 0.2 rad, and
// the angle is doubled as often afterwards. In a stable run the rotation in a step is far smaller.
#pragma once
#include "../lanes.hpp"
#include "../vector3.hpp"

namespace bondem {

template <class T> struct Quaternion {
    T w, x, y, z;
};

// The rotation b, followed by a.
template <class T> BONDEM_INLINE Quaternion<T> product(Quaternion<T> a, Quaternion<T> b) {
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z, a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x};
}

// Inverse of a unit quaternion, the opposite rotation.
template <class T> BONDEM_INLINE Quaternion<T> inverse(Quaternion<T> q) { return {q.w, -q.x, -q.y, -q.z}; }

// The vector v turned by q: v + 2 u × (u × v + w v) with the vector part u.
template <class T> BONDEM_INLINE Vector3<T> rotate(Quaternion<T> q, Vector3<T> v) {
    const T tx = 2.0 * (q.y * v.z - q.z * v.y), ty = 2.0 * (q.z * v.x - q.x * v.z), tz = 2.0 * (q.x * v.y - q.y * v.x);
    return {v.x + q.w * tx + (q.y * tz - q.z * ty), v.y + q.w * ty + (q.z * tx - q.x * tz),
            v.z + q.w * tz + (q.x * ty - q.y * tx)};
}
// The vector v turned by q in fewer operations, with other rounding, for several vectors and one q.
template <class T> BONDEM_INLINE Vector3<T> turned_by(Quaternion<T> q, Vector3<T> v) {
    const T x = q.x + q.x, y = q.y + q.y, z = q.z + q.z;
    const T tx = y * v.z - z * v.y, ty = z * v.x - x * v.z, tz = x * v.y - y * v.x;
    return {v.x + q.w * tx + q.y * tz - q.z * ty, v.y + q.w * ty + q.z * tx - q.x * tz,
            v.z + q.w * tz + q.x * ty - q.y * tx};
}

// A rotation as a matrix, row by row, which needs the fewest operations where one q turns many vectors.
template <class T> struct Rotation {
    Vector3<T> x, y, z;
};
template <class T> BONDEM_INLINE Rotation<T> matrix_of(Quaternion<T> q) {
    const T x = q.x + q.x, y = q.y + q.y, z = q.z + q.z, one = T{} + 1.0;
    const T wx = q.w * x, wy = q.w * y, wz = q.w * z;
    return {{one - q.y * y - q.z * z, q.x * y - wz, q.x * z + wy},
            {q.x * y + wz, one - q.x * x - q.z * z, q.y * z - wx},
            {q.x * z - wy, q.y * z + wx, one - q.x * x - q.y * y}};
}
template <class T> BONDEM_INLINE Vector3<T> turned_by(const Rotation<T> &r, Vector3<T> v) {
    return {dot(r.x, v), dot(r.y, v), dot(r.z, v)};
}
template <class T> BONDEM_INLINE Rotation<T> inverse(const Rotation<T> &r) {
    return {{r.x.x, r.y.x, r.z.x}, {r.x.y, r.y.y, r.z.y}, {r.x.z, r.y.z, r.z.z}};
}

// Scalar part of the relative rotation q_j q_i*.
template <class T> BONDEM_INLINE T relative_cosine(Quaternion<T> i, Quaternion<T> j) {
    return i.w * j.w + i.x * j.x + i.y * j.y + i.z * j.z;
}
// Vector part of the relative rotation q_j q_i*.
template <class T> BONDEM_INLINE Vector3<T> relative_sine(Quaternion<T> i, Quaternion<T> j) {
    return {i.w * j.x - j.w * i.x + i.y * j.z - i.z * j.y, i.w * j.y - j.w * i.y + i.z * j.x - i.x * j.z,
            i.w * j.z - j.w * i.z + i.x * j.y - i.y * j.x};
}

// cos h and sin h / h of a half angle h.
template <class T> struct HalfAngle {
    T cosine, sinc;
};

// Square of a half angle below which three terms are exact to rounding, as in a usual step.
constexpr double small_half_angle_square = 1e-5;

template <class T> BONDEM_INLINE HalfAngle<T> short_series(T h2) {
    return {1.0 + h2 * (-0.5 + h2 * (1.0 / 24.0 - h2 / 720.0)), 1.0 + h2 * (-1.0 / 6.0 + h2 * (1.0 / 120.0 - h2 / 5040.0))};
}
inline HalfAngle<double> half_angle(double h2) {
    if (h2 < small_half_angle_square) return short_series(h2);
    if (!(h2 < infinity)) return {h2 - h2, h2 - h2};  // infinite or not a number: both results are NaN
    int halvings = 0;
    for (; !(h2 < 0.04); halvings++) h2 *= 0.25;
    double cosine = 1.0 + h2 * (-0.5 + h2 * (1.0 / 24.0 + h2 * (-1.0 / 720.0 + h2 * (1.0 / 40320.0 - h2 / 3628800.0))));
    double sinc = 1.0 + h2 * (-1.0 / 6.0 + h2 * (1.0 / 120.0 + h2 * (-1.0 / 5040.0 + h2 * (1.0 / 362880.0 - h2 / 39916800.0))));
    for (; halvings > 0; halvings--) {
        sinc = sinc * cosine;
        cosine = 2.0 * cosine * cosine - 1.0;
    }
    return {cosine, sinc};
}
#if defined(BONDEM_LANES)
BONDEM_INLINE HalfAngle<Lanes> half_angle(Lanes h2) {
    if (__builtin_expect(all_below(h2, small_half_angle_square), 1)) return short_series(h2);
    HalfAngle<Lanes> all = {h2, h2};
    for (int n = 0; n < lanes; n++) {
        const HalfAngle<double> one = half_angle(double(h2[n]));
        all.cosine[n] = one.cosine;
        all.sinc[n] = one.sinc;
    }
    return all;
}
#endif

// The orientation q turned further by the rotation vector r [rad], and normalised: one Newton step towards unit
// length is enough, because the exponential map changes the length by rounding only.
template <class T> BONDEM_INLINE Quaternion<T> turned(Quaternion<T> o, Vector3<T> rotation) {
    const HalfAngle<T> half = half_angle(0.25 * dot(rotation, rotation));
    const T p = 0.5 * half.sinc * rotation.x, q = 0.5 * half.sinc * rotation.y, r = 0.5 * half.sinc * rotation.z;
    const T cosine = half.cosine;
    const T w = cosine * o.w - p * o.x - q * o.y - r * o.z, x = cosine * o.x + p * o.w + q * o.z - r * o.y;
    const T y = cosine * o.y + q * o.w + r * o.x - p * o.z, z = cosine * o.z + r * o.w + p * o.y - q * o.x;
    const T scale = 1.5 - 0.5 * (w * w + x * x + y * y + z * z);
    return {w * scale, x * scale, y * scale, z * scale};
}

}  // namespace bondem
