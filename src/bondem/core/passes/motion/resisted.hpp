// Resistance to the motion of elements: local damping, mass damping, dashpots of bonds, absorbing boundaries.
#pragma once
#include "../../laws/damping.hpp"
#include "boundary_rows.hpp"

namespace bondem {

// Acceleration a' with the absorbing dashpots C of a row at the velocity a kick of h later:
// (s + m h C) a' = a - m C v, a symmetric 3 × 3 system solved by cofactors, with m = 1/mass and s = 1 + h α.
inline Vector absorbed(const double *absorbing, double h, double s, double m, Vector v, Vector a) {
    double xx = m * absorbing[0], yy = m * absorbing[1], zz = m * absorbing[2];
    double xy = m * absorbing[3], xz = m * absorbing[4], yz = m * absorbing[5];
    const double ax = a.x - (xx * v.x + xy * v.y + xz * v.z), ay = a.y - (xy * v.x + yy * v.y + yz * v.z);
    const double az = a.z - (xz * v.x + yz * v.y + zz * v.z);
    xx = s + h * xx, yy = s + h * yy, zz = s + h * zz;
    xy = h * xy, xz = h * xz, yz = h * yz;
    const double c0 = yy * zz - yz * yz, c1 = xz * yz - xy * zz, c2 = xy * yz - xz * yy;
    const double c3 = xx * zz - xz * xz, c4 = xy * xz - xx * yz, c5 = xx * yy - xy * xy;
    const double whole = xx * c0 + xy * c1 + xz * c2;
    return {(c0 * ax + c1 * ay + c2 * az) / whole, (c1 * ax + c3 * ay + c4 * az) / whole,
            (c2 * ax + c4 * ay + c5 * az) / whole};
}

// Stands for an element without a row of the boundary, or without damping.
struct NoRow {};
BONDEM_INLINE const double *absorbing_of(const Resistance &resistance, Index r) {
    return resistance.absorbing.size() > 0 ? &resistance.absorbing(r, 0) : nullptr;
}

// Reduces accelerations by mass damping and absorbing dashpots at the velocity a kick of h later, the velocity at the
// time of the forces: damping is of second order and never unstable. (v, w) has no prescribed components.
template <class T>
BONDEM_INLINE void resist(const Resistance &resistance, const double *absorbing, double h, T m, Vector3<T> v, Vector3<T> w,
                          Vector3<T> &a, Vector3<T> &b) {
    const double alpha = resistance.alpha, s = 1.0 + h * alpha;
    a = minus(a, T{} + alpha, v);
    b = minus(b, T{} + alpha, w);
    b = b / (T{} + s);
    if constexpr (sizeof(T) == sizeof(double))
        if (absorbing) {
            a = absorbed(absorbing, h, s, m, v, a);
            return;
        }
    a = a / (T{} + s);
}

// Power lost to local damping [W], at the velocity between the two kicks.
template <class T>
BONDEM_INLINE T power_lost(const Wrench<T> &whole, const Wrench<T> &damped, const Motion<T> &moving) {
    const Vector3<T> f = whole.force - damped.force, t = whole.torque - damped.torque, v = moving.v, w = moving.w;
    return t.z * w.z + (t.y * w.y + (t.x * w.x + dot(f, v)));
}

// Power lost to mass damping and absorbing dashpots, and to other resistance [W].
template <class T>
BONDEM_INLINE T viscous_power(const Resistance &resistance, const double *absorbing, Vector3<T> v, Vector3<T> w, T m, T u,
                              T else_taken) {
    T power = else_taken + resistance.alpha * (dot(v, v) / m + dot(w, w) / u);
    if constexpr (sizeof(T) == sizeof(double))
        if (absorbing) {
            const double *c = absorbing;
            power += c[0] * v.x * v.x + c[1] * v.y * v.y + c[2] * v.z * v.z;
            power += 2.0 * (c[3] * v.x * v.y + c[4] * v.x * v.z + c[5] * v.y * v.z);
        }
    return power;
}

}  // namespace bondem
