// A stress as a symmetric tensor, and bounds of its principal stresses. Tension is positive.
//
//     σ1 = p + 2 √(J2 / 3) cos(arccos(r) / 3)      r = ½ det(s) / (√(J2 / 3))³
//     σ3 = p - 2 √(J2 / 3) cos(arccos(-r) / 3)
//
// with the mean stress p, the deviator s = σ - p 1, and J2 = ½ s : s. 2 cos(arccos(r) / 3) is computed by a
// polynomial of √((1 + r) / 2), interpolated at Chebyshev's points, with an error of 4e-7. The bounds are wider by a
// margin for this error and for rounding: a criterion that the bounds do not reach is not reached by the stress.
#pragma once
#include "../select.hpp"
#include "../symmetric3.hpp"
#include "rotations.hpp"

namespace bondem {

// A stress by its six components [Pa].
template <class T> using Stress = Symmetric3<T>;

template <class T> BONDEM_INLINE Stress<T> mean_of(const Stress<T> &a, const Stress<T> &b) {
    return {0.5 * (a.xx + b.xx), 0.5 * (a.yy + b.yy), 0.5 * (a.zz + b.zz),
            0.5 * (a.xy + b.xy), 0.5 * (a.xz + b.xz), 0.5 * (a.yz + b.yz)};
}
// A stress turned by a rotation, R σ Rᵀ, from the rows of R σ.
template <class T> BONDEM_INLINE Stress<T> turned_by(const Rotation<T> &r, const Stress<T> &s) {
    const Vector3<T> x = s * r.x, y = s * r.y, z = s * r.z;
    return {dot(x, r.x), dot(y, r.y), dot(z, r.z), dot(x, r.y), dot(x, r.z), dot(y, r.z)};
}

template <class T> struct PrincipalBounds {
    T largest, least;  // at least σ1, and at most σ3 [Pa]
};

// Approximation of 2 cos(arccos(r) / 3) within 4e-7.
template <class T> BONDEM_INLINE T trisected(T r) {
    const T one = T{} + 1.0, c = select(r < -one, -one, select(r > one, one, r));
    const T x = root(0.5 * (1.0 + c));
    return 1.0000003719387707 +
           x * (1.1546638041491451 +
                x * (-0.22161094179544857 +
                     x * (0.10294952669157148 +
                          x * (-0.052799498696539826 + x * (0.021003507189659234 + x * -0.004206982020150463)))));
}

// Largest error of a principal stress by the polynomial and rounding, over the size of the stress.
constexpr double principal_margin = 1e-6;
// Prevents 0 / 0, without an effect on other numbers [Pa³].
constexpr double no_stress = 1e-200;

template <class T> BONDEM_INLINE PrincipalBounds<T> principal_bounds(const Stress<T> &s) {
    const T mean = trace(s) / (T{} + 3.0), a = s.xx - mean, b = s.yy - mean, c = s.zz - mean;
    const T square = a * a + b * b + c * c + 2.0 * (s.xy * s.xy + s.xz * s.xz + s.yz * s.yz);
    const T size = root(square / (T{} + 6.0));
    const T det = a * (b * c - s.yz * s.yz) - s.xy * (s.xy * c - s.yz * s.xz) + s.xz * (s.xy * s.yz - b * s.xz);
    const T r = 0.5 * det / (size * size * size + no_stress);
    const T margin = principal_margin * (size + absolute(mean));
    return {mean + size * trisected(r) + margin, mean - size * trisected(-r) - margin};
}

}  // namespace bondem
