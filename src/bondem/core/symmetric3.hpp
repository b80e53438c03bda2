// Symmetric tensors of second order in space. A component is a number, or a vector register of numbers.
#pragma once
#include "vector3.hpp"

namespace bondem {

template <class T> struct Symmetric3 {
    T xx, yy, zz, xy, xz, yz;

    const T &operator[](Index c) const {
        return c == 0 ? xx : c == 1 ? yy : c == 2 ? zz : c == 3 ? xy : c == 4 ? xz : yz;
    }
};

template <class T> inline Vector3<T> operator*(Symmetric3<T> a, Vector3<T> v) {
    return {a.xx * v.x + a.xy * v.y + a.xz * v.z, a.xy * v.x + a.yy * v.y + a.yz * v.z,
            a.xz * v.x + a.yz * v.y + a.zz * v.z};
}
template <class T> inline Symmetric3<T> operator*(T s, Symmetric3<T> a) {
    return {s * a.xx, s * a.yy, s * a.zz, s * a.xy, s * a.xz, s * a.yz};
}
template <class T> inline Symmetric3<T> operator+(Symmetric3<T> a, Symmetric3<T> b) {
    return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.xz + b.xz, a.yz + b.yz};
}
template <class T> inline T trace(Symmetric3<T> a) { return a.xx + a.yy + a.zz; }

// The symmetric part of the dyad a⊗b.
template <class T> inline Symmetric3<T> symmetric_product(Vector3<T> a, Vector3<T> b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z, 0.5 * (a.x * b.y + a.y * b.x), 0.5 * (a.x * b.z + a.z * b.x),
            0.5 * (a.y * b.z + a.z * b.y)};
}

}  // namespace bondem
