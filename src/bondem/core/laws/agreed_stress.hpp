// Stress σ* for criteria on a facet: the mean stress σ of its two cells, corrected to agree with its traction t,
//
//     σ* = σ + r⊗n + n⊗r - (r·n) n⊗n        r = t - σ n
//
// so that σ* n = t, with n the normal of the facet. Tension is positive.
#pragma once
#include "../select.hpp"
#include "../symmetric3.hpp"

namespace bondem {

template <class T> BONDEM_INLINE Symmetric3<T> agreed_stress(const Symmetric3<T> &s, Vector3<T> n, Vector3<T> t) {
    const Vector3<T> r = t - s * n;
    const T along = dot(r, n);
    return {s.xx + 2.0 * r.x * n.x - along * n.x * n.x, s.yy + 2.0 * r.y * n.y - along * n.y * n.y,
            s.zz + 2.0 * r.z * n.z - along * n.z * n.z, s.xy + r.x * n.y + r.y * n.x - along * n.x * n.y,
            s.xz + r.x * n.z + r.z * n.x - along * n.x * n.z, s.yz + r.y * n.z + r.z * n.y - along * n.y * n.z};
}
// A traction whose normal part is the tensile part plus `bent` where bending opens the facet; and that part [Pa].
template <class T> struct PulledTraction {
    Vector3<T> t;
    T along;
};
template <class T> BONDEM_INLINE PulledTraction<T> pulled_traction(Vector3<T> t, Vector3<T> n, T bent) {
    const T across = dot(t, n), zero = {}, pulled = positive(across) + bent;
    const Mask<T> opens = bent > zero;
    return {select<T>(opens, plus(t, T(pulled - across), n), t), select(opens, pulled, across)};
}
// A stress with its normal component along n raised by the excess of `bent` over its tensile part [Pa].
template <class T> BONDEM_INLINE Symmetric3<T> bent_stress(const Symmetric3<T> &s, Vector3<T> n, T bent) {
    const T zero = {}, along = dot(n, s * n), pulled = along > zero ? along : zero;
    const T more = bent > pulled ? bent - pulled : zero;
    return {s.xx + more * n.x * n.x, s.yy + more * n.y * n.y, s.zz + more * n.z * n.z,
            s.xy + more * n.x * n.y, s.xz + more * n.x * n.z, s.yz + more * n.y * n.z};
}

}  // namespace bondem
