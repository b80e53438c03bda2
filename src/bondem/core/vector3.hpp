// Vectors in space. A component is a number, a dual number, or a vector register of numbers.
//
// The compiler fuses a product with a sum, rounded once, only within an expression (-ffp-contract=on). Therefore all
// levels of instructions with fused multiply-add give the same bits.
#pragma once
#include "lanes.hpp"

namespace bondem {

template <class T> struct Vector3 {
    T x, y, z;

    T &operator[](Index axis) { return axis == 0 ? x : axis == 1 ? y : z; }
    const T &operator[](Index axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};
using Vector = Vector3<double>;

template <class T> inline Vector3<T> operator+(Vector3<T> a, Vector3<T> b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
template <class T> inline Vector3<T> operator-(Vector3<T> a, Vector3<T> b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
template <class T> inline Vector3<T> operator-(Vector3<T> a) { return {-a.x, -a.y, -a.z}; }
template <class T> inline Vector3<T> operator*(T s, Vector3<T> a) { return {s * a.x, s * a.y, s * a.z}; }
template <class T> inline Vector3<T> operator/(Vector3<T> a, T s) { return {a.x / s, a.y / s, a.z / s}; }
template <class T> inline Vector3<T> each(Vector3<T> a, Vector3<T> b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

// a + s b and a - s b, each component rounded once.
template <class T> inline Vector3<T> plus(Vector3<T> a, T s, Vector3<T> b) {
    return {a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}
template <class T> inline Vector3<T> minus(Vector3<T> a, T s, Vector3<T> b) {
    return {a.x - s * b.x, a.y - s * b.y, a.z - s * b.z};
}
template <class T> inline T dot(Vector3<T> a, Vector3<T> b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
template <class T> inline Vector3<T> cross(Vector3<T> a, Vector3<T> b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
// c + a × b and c - a × b, with two roundings per component.
template <class T> inline Vector3<T> plus_cross(Vector3<T> c, Vector3<T> a, Vector3<T> b) {
    return {c.x + a.y * b.z - a.z * b.y, c.y + a.z * b.x - a.x * b.z, c.z + a.x * b.y - a.y * b.x};
}
template <class T> inline Vector3<T> minus_cross(Vector3<T> c, Vector3<T> a, Vector3<T> b) {
    return {c.x - a.y * b.z + a.z * b.y, c.y - a.z * b.x + a.x * b.z, c.z - a.x * b.y + a.y * b.x};
}
template <class T> inline T length(Vector3<T> a) { return root(dot(a, a)); }
// The part of v across a unit vector n.
template <class T> inline Vector3<T> tangential(Vector3<T> v, Vector3<T> n) { return minus(v, dot(v, n), n); }

// A component of a separation over the nearest periodic image; edge and inverse are 0 along an axis that is not
// periodic.
template <class T> BONDEM_INLINE T over_nearest_image(T d, double edge, double inverse) {
    return d - edge * nearest(d * inverse);
}

}  // namespace bondem
