// A beam of the incremental formulation: rates of force and moment, integrated step by step, and stored per bond.
//
// v is the velocity of j against i at the contact point, ω the angular velocity of j against i, and n the unit vector
// from i to j. Ω is the spin of the bond: the spin of n plus the mean of both angular velocities along n. The rates
// are
//
//     F' = Ω × F + kn (v·n) n + ks (v - (v·n) n)
//     M' = Ω × M + kt (ω·n) n + kb (ω - (ω·n) n)
//
// F acts on i at the contact point and -F on j, M on i and -M on j. Tension is positive. The contact point is at the
// distance a from i at rest, where the length is L, and at a' at the present length ℓ:
//
//     torque on i = a' n × F + M      torque on j = (ℓ - a') n × F - M      a' = a + (ℓ - L) / 2
//
// The normal, shear, bending and twisting stiffnesses kn, ks, kb and kt are those of the beams (`beam.hpp`).
// Plasticity and rate laws need this formulation.
//
// The sources do not say at which instant of a step the rates are taken. Here it is the middle, the instant of the
// velocities. Half of the rate is added. The stored vector is then turned by the Cayley transform of Ω dt, which
// keeps its length (Hughes and Winget 1980), and the other half is added. In a rigid rotation a stored vector then
// turns with the bond, to second order in the step. A step of duration 0 changes nothing.
//
// Energy: the stored vectors over their stiffnesses,
//
//     U = ½ (F·n)² / kn + ½ (F² - (F·n)²) / ks + ½ (M·n)² / kt + ½ (M² - (M·n)²) / kb
//
// Limits: rotations do not commute. A closed cycle of bending and twisting leaves a force of second order in the
// angle, for any size of the step. Beams of `beam.hpp` leave none.
//
// Sources: Chen et al. (2022), eqs (1), (5) to (7), Tables 1, 2 and 8; Hughes and Winget (1980), Int. J. Numer. Meth.
// Engng 15, 1862-1867.
#pragma once
#include "damping.hpp"

namespace bondem {

// Stored force and moment of a bond.
template <class T> struct StoredLoad {
    Vector3<T> force;  // on i at the contact point [N]
    Vector3<T> moment;  // on i [N·m]
};
// Length at rest, and distance of the contact point from i at rest [m].
template <class T> struct StoredShape {
    T rest, lever;
};
template <class T> struct StoredStiffness {
    T kn, ks;  // normal and shear [N/m]
    T kt, kb;  // twisting and bending [N·m]
};

// The unit branch, and the distances of the contact point from both centres [m].
template <class T> struct PresentBond {
    Vector3<T> axis;
    T inverse, near, far;  // one over the length [1/m]; [m]

    BONDEM_INLINE PresentBond(Vector3<T> branch, const StoredShape<T> &shape) {
        const T present = length(branch);
        inverse = 1.0 / present;
        axis = inverse * branch;
        near = shape.lever + 0.5 * (present - shape.rest);
        far = present - near;
    }
};

// Stiffness along the axis and across it, of a force or of a moment.
template <class T> struct AxialStiffness {
    T along, across;
};

// A stored vector after a step: half of its rate, the turn by 2 h Ω, the other half.
template <class T>
BONDEM_INLINE Vector3<T> integrated(Vector3<T> stored, Vector3<T> spin, Vector3<T> rate, Vector3<T> axis,
                                    AxialStiffness<T> k, T half_step) {
    const T normal = (k.along - k.across) * dot(rate, axis);
    const Vector3<T> gain = half_step * plus(normal * axis, k.across, rate);
    const Vector3<T> before = stored + gain, t = half_step * spin;
    const T s = 2.0 / (1.0 + dot(t, t));
    return plus(before, s, cross(t, before + cross(t, before))) + gain;
}

// Force and moment after a step of dt that ends now. The rates are those of half a step ago.
template <class T>
BONDEM_INLINE StoredLoad<T> integrated(const StoredLoad<T> &stored, Vector3<T> branch,
                                       const RelativeMotion<T> &motion, const StoredShape<T> &shape, const StoredStiffness<T> &k, double dt) {
    const T h = T{} + 0.5 * dt;
    const PresentBond<T> middle(minus(branch, h, motion.velocity), shape);
    const Vector3<T> n = middle.axis, p = motion.spin_i, q = motion.spin_j;
    const T about = 0.5 * dot(p + q, n);
    const Vector3<T> spin = plus(middle.inverse * cross(n, motion.velocity), about, n);
    const Vector3<T> slip = motion.velocity - cross(plus(middle.near * p, middle.far, q), n);
    return {integrated(stored.force, spin, slip, n, {k.kn, k.ks}, h),
            integrated(stored.moment, spin, q - p, n, {k.kt, k.kb}, h)};
}

// Force and torques of a stored load on the elements of its bond.
template <class T>
BONDEM_INLINE BeamLoads<T> stored_loads(const StoredLoad<T> &stored, Vector3<T> branch, const StoredShape<T> &shape) {
    const PresentBond<T> now(branch, shape);
    const Vector3<T> across = cross(now.axis, stored.force);
    return {-stored.force, plus(stored.moment, now.near, across), plus(-stored.moment, now.far, across)};
}

// The energy of a stored load in the four modes of a beam [J].
template <class T>
BONDEM_INLINE BeamEnergy<T> stored_energy(const StoredLoad<T> &stored, Vector3<T> axis, const StoredStiffness<T> &k) {
    const auto half_over = [](T square, T stiffness) { return stiffness > 0.0 ? 0.5 * square / stiffness : T{}; };
    const auto rest = [](Vector3<T> a, T along) { return most(dot(a, a) - along * along, T{}); };
    const T tension = dot(stored.force, axis), twist = dot(stored.moment, axis);
    return {half_over(tension * tension, k.kn), half_over(rest(stored.force, tension), k.ks),
            half_over(rest(stored.moment, twist), k.kb), half_over(twist * twist, k.kt)};
}

}  // namespace bondem
