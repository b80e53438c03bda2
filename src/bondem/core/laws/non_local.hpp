// The non-local law of Celigueta, Oñate et al. (2020): a bond follows the mean stress of its two elements.
//
// A bond of area A joins two elements whose centres are L apart. The bond has a face on each element, at the levers
// b_i and b_j, which turn with the elements. The gap of the faces is δ, with δ_n along the normal n and δ_t across
// it. σ is the mean stress of both elements by the forces of the step before. With kn = A E / L and kt = A G / L,
// tension positive,
//
//     F = kn δ_n n + kt δ_t + e                                             eqs (2), (3), (6)
//     e = A ν (tr σ - n·σ n) n + t - kt δ_t⁻      t = A (σ n - (n·σ n) n)
//
// where δ_t⁻ is the tangential gap at the time of σ. Without rotation δ_t / L is half of the engineering shear
// strain, so that kt δ_t alone is half of the shear force A τ. With e, the tangential part of F differs from A τ only
// by kt (δ_t - δ_t⁻), its change in one step. F acts on i, and -F on j, both at the middle of the gap, so that they
// make no moment together. The stress of an element of volume V is the symmetric part of the sum over its bonds
//
//     σ = (1/V) Σ b ⊗ F                                                     eq (1)
//
// n is along the mean of two vectors: the normal of the reference turned with i, and turned with j. A bond stores δ
// and e in the frame of its element i, and an element stores its stress in its own frame. A rotation of the whole
// body does not change these values.
//
// Energy: ½ kn δ_n² + ½ kt δ_t² in the springs. The law has no potential. The work of e is an entry of its own in the
// energy balance, by the trapezoidal rule in the frame of i.
//
// Limits: the stress lags a step behind, which adds energy without damping. The highest frequency of the springs does
// not bound the time step. With `limited`, the length of t - kt δ_t⁻ is at most |t|. The text of the paper does not
// print a limiter, but without it only the lag of the stress resists the rotation of an element.
#pragma once
#include "stress.hpp"

namespace bondem {

// Reference geometry of a bond.
template <class T> struct PairShape {
    Vector3<T> normal;  // from i to j [-]
    Vector3<T> lever_i, lever_j;  // from the elements to their faces [m]
};
template <class T> struct PairStiffness {
    T area;  // A [m²]
    T kn, kt;  // [N/m]
};
struct PairLaw {
    double nu;  // ν [-]
    bool limited;
};
// A bond in its present geometry.
template <class T> struct PairPose {
    Vector3<T> normal;  // [-]
    Vector3<T> lever_i, lever_j;  // [m]
    Vector3<T> gap;  // δ [m]
};
// Stored values of a bond, in the frame of its element i.
template <class T> struct PairStore {
    Vector3<T> gap, extra;  // δ [m], e [N]
    T taken;  // work of e [J]
};
// Force and moments of a bond on its elements.
template <class T> struct NonLocalLoads {
    Vector3<T> force;  // on i; its opposite on j [N]
    Vector3<T> on_i, on_j;  // torque on i, and minus the torque on j [N·m]
};

// Prevents 0 / 0 for an element turned by half a revolution, and without a shear force.
constexpr double nothing = 1e-200;

// The present geometry of a bond, from the orientations of its elements.
template <class T>
BONDEM_INLINE PairPose<T> pair_pose(Vector3<T> branch, const Rotation<T> &i, Quaternion<T> j,
                                    const PairShape<T> &shape) {
    const Vector3<T> both = turned_by(i, shape.normal) + turned_by(j, shape.normal);
    const Vector3<T> a = turned_by(i, shape.lever_i), b = turned_by(j, shape.lever_j);
    return {1.0 / root(dot(both, both) + nothing) * both, a, b, branch + b - a};
}

// The extra force e by the mean stress of the elements and the tangential spring force kt δ_t⁻ of the step before.
template <class T>
BONDEM_INLINE Vector3<T> extra_force(const Stress<T> &s, Vector3<T> n, T area, Vector3<T> slip, const PairLaw &law) {
    const Vector3<T> pull = s * n;
    const T along = dot(pull, n), push = area * law.nu * (trace(s) - along);
    const Vector3<T> t = area * minus(pull, along, n);
    Vector3<T> e = t - slip;
    if (law.limited) {
        // exactly 1 within the limit, and 0 without a shear force
        const T largest = dot(t, t), found = dot(e, e);
        e = root(largest / ((found > largest ? found : largest) + nothing)) * e;
    }
    return plus(e, push, n);
}
// Force kn δ_n n + kt δ_t of the springs [N].
template <class T> BONDEM_INLINE Vector3<T> spring_force(const PairPose<T> &now, const PairStiffness<T> &k) {
    const T along = (k.kn - k.kt) * dot(now.gap, now.normal);
    return plus(k.kt * now.gap, along, now.normal);
}

// The extra force of a bond that stored `before`, from the mean stress of its elements before.
template <class T>
BONDEM_INLINE Vector3<T> extra_after(const PairStore<T> &before, const Stress<T> &mean, const PairPose<T> &now,
                                     const Rotation<T> &i, const PairStiffness<T> &k, const PairLaw &law) {
    const Vector3<T> slip = k.kt * tangential(turned_by(i, before.gap), now.normal);
    return extra_force(mean, now.normal, k.area, slip, law);
}
// The stored values of a bond of integrity s after a step, at whose end the extra force is e [N].
template <class T>
BONDEM_INLINE PairStore<T> store_after(const PairStore<T> &before, Vector3<T> e, const PairPose<T> &now,
                                       const Rotation<T> &i, T s) {
    const Vector3<T> gap = turned_by(inverse(i), now.gap), extra = turned_by(inverse(i), e);
    return {gap, extra, before.taken + 0.5 * s * dot(before.extra + extra, gap - before.gap)};
}

// The force F of a bond [N] from its stored values, so that a restored state has bit-identical forces.
template <class T>
BONDEM_INLINE Vector3<T> present_force(const PairStore<T> &store, const PairPose<T> &now, const Rotation<T> &i,
                                       const PairStiffness<T> &k) {
    return spring_force(now, k) + turned_by(i, store.extra);
}
// The loads of a bond with the force F on its element i [N].
template <class T> BONDEM_INLINE NonLocalLoads<T> non_local_loads(const PairPose<T> &now, Vector3<T> force) {
    const T middle = T{} + 0.5;
    const Vector3<T> arm_i = plus(now.lever_i, middle, now.gap), arm_j = minus(now.lever_j, middle, now.gap);
    return {force, cross(arm_i, force), cross(arm_j, force)};
}

// Energy of the springs [J].
template <class T> struct SpringEnergy {
    T normal, shear;
};
template <class T> BONDEM_INLINE SpringEnergy<T> spring_energy(const PairPose<T> &now, const PairStiffness<T> &k) {
    const T along = dot(now.gap, now.normal);
    return {0.5 * k.kn * along * along, 0.5 * k.kt * (dot(now.gap, now.gap) - along * along)};
}

}  // namespace bondem
