// Principal stresses and their directions, by Jacobi's rotations. Tension is positive.
//
// A rotation in the plane of the axes p and q makes the component σ_pq zero: with d = ½ (σ_qq - σ_pp),
//
//     t = tan = ± σ_pq / (|d| + √(d² + σ_pq²)), the sign that of d      σ_pp ← σ_pp - t σ_pq,   σ_qq ← σ_qq + t σ_pq
//
// Sweeps over the three planes converge quadratically. After the third sweep only rounding errors remain. A component
// below rounding is not changed, so that the result for a stress does not depend on those in other SIMD lanes.
//
// Source: Golub and Van Loan, Matrix Computations, 4th ed., section 8.5.
#pragma once
#include "../select.hpp"
#include "../symmetric3.hpp"

namespace bondem {

// Principal stresses [Pa], in no order, and their directions.
template <class T> struct PrincipalStress {
    T stress[3];
    Vector3<T> direction[3];
};

// Mean stress, and the square root of the second invariant of the deviator [Pa].
template <class T> struct StressInvariants {
    T mean, deviator;
};
template <class T> BONDEM_INLINE StressInvariants<T> invariants(const Symmetric3<T> &s) {
    const T p = (1.0 / 3.0) * trace(s), a = s.xx - p, b = s.yy - p, c = s.zz - p;
    return {p, root(0.5 * (a * a + b * b + c * c) + s.xy * s.xy + s.xz * s.xz + s.yz * s.yz)};
}
// Square of the size of a stress, σ:σ [Pa²].
template <class T> BONDEM_INLINE T square_of(const Symmetric3<T> &s) {
    return s.xx * s.xx + s.yy * s.yy + s.zz * s.zz + 2.0 * (s.xy * s.xy + s.xz * s.xz + s.yz * s.yz);
}
// True if all principal stresses are below a limit, that is, if limit 1 - σ is positive definite.
template <class T> BONDEM_INLINE Mask<T> is_below(const Symmetric3<T> &s, T limit) {
    const T a = limit - s.xx, b = limit - s.yy, c = limit - s.zz, zero = {};
    const T det = a * (b * c - s.yz * s.yz) - s.xy * (s.xy * c + s.yz * s.xz) - s.xz * (s.xy * s.yz + b * s.xz);
    return (a > zero) & (a * b - s.xy * s.xy > zero) & (det > zero);
}

// Square of a component, over σ:σ, below which it is rounding.
constexpr double rounding_square = 1e-34;

template <int p, int q, class T>
BONDEM_INLINE void clear_component(T *on, T *off, Vector3<T> *v, T floor) {
    constexpr int r = 3 - p - q;  // off has the components 01, 02 and 12, each at the sum of its numbers less 1
    T &pq = off[p + q - 1], &pr = off[p + r - 1], &qr = off[q + r - 1];
    const T d = 0.5 * (on[q] - on[p]), size = absolute(d) + root(d * d + pq * pq), zero = {};
    const Mask<T> clears = pq * pq > floor;
    const T t = select(clears, select(d >= zero, pq, -pq) / size, zero);
    const T c = 1.0 / root(t * t + 1.0), s = t * c;
    on[p] = on[p] - t * pq;
    on[q] = on[q] + t * pq;
    pq = select(clears, zero, pq);
    const T a = pr, b = qr;
    pr = c * a - s * b;
    qr = s * a + c * b;
    const Vector3<T> vp = v[p], vq = v[q];
    v[p] = minus(c * vp, s, vq);
    v[q] = plus(s * vp, c, vq);
}

template <class T> BONDEM_INLINE PrincipalStress<T> principal(const Symmetric3<T> &s) {
    const T zero = {}, one = zero + 1.0, floor = rounding_square * square_of(s);
    PrincipalStress<T> found = {{s.xx, s.yy, s.zz}, {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}};
    T off[3] = {s.xy, s.xz, s.yz};
    for (int sweep = 0; sweep < 5; sweep++) {
        if (!any((off[0] * off[0] > floor) | (off[1] * off[1] > floor) | (off[2] * off[2] > floor))) break;
        clear_component<0, 1>(found.stress, off, found.direction, floor);
        clear_component<0, 2>(found.stress, off, found.direction, floor);
        clear_component<1, 2>(found.stress, off, found.direction, floor);
    }
    return found;
}
template <class T> BONDEM_INLINE T least_of(const PrincipalStress<T> &s) {
    return least(least(s.stress[0], s.stress[1]), s.stress[2]);
}
template <class T> BONDEM_INLINE T largest_of(const PrincipalStress<T> &s) {
    return most(most(s.stress[0], s.stress[1]), s.stress[2]);
}
// σ3 as a pressure, at least 0 [Pa].
template <class T> BONDEM_INLINE T largest_pressure(const PrincipalStress<T> &s) { return positive(-least_of(s)); }

}  // namespace bondem
