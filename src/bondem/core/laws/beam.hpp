// A beam between two elements i and j: one energy U for every linear bond law, its gradient, and its parts.
//
// In the reference configuration every orientation is the identity. X0 is the direction from i to j there, and L the
// distance of the centres. X is the present direction, ℓ the present distance, and q the quaternion of an element. X1
// and X2 are X0 turned with the elements i and j, so that
//
//     c1 = X · X1    c2 = X · X2    w = q_i · q_j
//
// are 1 at rest. The contact point is at the lever a from i and b = L - a from j. kn, ks, kb and kt are the normal,
// shear, bending and twisting stiffness. With k' = kb - kt,
//
//     U = ½ kn (ℓ - L)² + ½ A (1 - c1²) + B (X1 · X2 - c1 c2) + ½ C (1 - c2²) + 2 kt (1 - w²)
//     A = ks a² + k'      B = ks a b - k'      C = ks b² + k'
//
// Laws differ in these stiffnesses and in the contact point (Chen et al. 2022, eqs (21) to (26), Tables 1 and 9). The
// following values are for a circular section of radius r, with the area S = π r², I = π r⁴ / 4 and J = 2 I. E is
// Young's modulus, ν Poisson's ratio, G = E / (2 (1 + ν)), R the radius of an element, and κ = kn / ks.
//
//                        kn        ks                     kb            kt            a
//     Euler–Bernoulli    E S / L   12 E I / L³            E I / L       G J / L       L / 2
//     Timoshenko         E S / L   12 E I / (L³ (1 + Φ))  E I / L       G J / L       L / 2
//     parallel bond      E S / L   kn / κ                 kn r² / 4     ks r² / 2     (L + R_i - R_j) / 2
//
// with Φ = 20 r² (1 + ν) / (3 L²). `interactions/beams/` computes these values, once per bond.
//
// Signs: tension is positive. The force acts on j, and its opposite on i.
//
// The second derivative of U at rest is the stiffness matrix of the law. U does not change under rigid motion, so
// that the forces, its exact gradient, conserve momentum and angular momentum to rounding.
//
// Limits: the moment of shear has its maximum at 45°, and X = -X0 is a false minimum of U. Relative rotations have to
// stay moderate: c1 and c2 above 0.7, w² above 0.75. A similar model: Kuzkin and Asonov (2012).
#pragma once
#include "ends.hpp"

namespace bondem {

// Reference geometry of a beam.
template <class T> struct BeamShape {
    Vector3<T> direction;  // X0 [-]
    T length;  // L [m]
};
// Constants of the energy of a beam.
template <class T> struct BeamStiffness {
    T kn;  // [N/m]
    T A, B, C;  // [N·m]
    T kt;  // [N·m]
};

// Force and torques of a beam: minus the gradient of U.
template <class T>
BONDEM_INLINE BeamLoads<T> beam_loads(const Ends<T> &ends, const BeamShape<T> &shape, const BeamStiffness<T> &k) {
    const T present = length(ends.branch), inverse = 1.0 / present;
    const Vector3<T> X = inverse * ends.branch;
    const Vector3<T> X1 = rotate(ends.i, shape.direction), X2 = rotate(ends.j, shape.direction);
    // the choice of the product that is fused with a sum determines the bits: in c2 that of y
    const T c1 = dot(X, X1), c2 = X.y * X2.y + X.x * X2.x + X.z * X2.z;
    const T g1 = k.A * c1 + k.B * c2, g2 = k.B * c1 + k.C * c2;
    // force = axial X + (g1 X1 + g2 X2) / ℓ
    const T axial = -k.kn * (present - shape.length) - (g1 * c1 + g2 * c2) * inverse;
    const T s1 = g1 * inverse, s2 = g2 * inverse;
    const Vector3<T> force = plus(plus(axial * X, s1, X1), s2, X2);
    // torques = g X1 × X ± (2 kt w v - B X1 × X2), where (w, v) is the relative rotation
    const T twist = 2.0 * k.kt * relative_cosine(ends.i, ends.j);
    const Vector3<T> v = relative_sine(ends.i, ends.j), across = cross(X1, X2);
    const Vector3<T> both = {twist * v.x - k.B * across.x, twist * v.y - k.B * across.y, twist * v.z - k.B * across.z};
    return {force, plus(both, g1, cross(X1, X)), plus(-both, g2, cross(X2, X))};
}

// Energy of a beam in its four modes, the parts of U. Sines come from cross products, so that small deformations keep
// their digits.
template <class T>
BONDEM_INLINE BeamEnergy<T> beam_energy(const Ends<T> &ends, const BeamShape<T> &shape, const BeamStiffness<T> &k, T ks,
                                        T a) {
    const T present = length(ends.branch), L = shape.length, b = L - a;
    const Vector3<T> X = ends.branch / present;
    const Vector3<T> X1 = rotate(ends.i, shape.direction), X2 = rotate(ends.j, shape.direction);
    const Vector3<T> m = cross(X1, X), n = cross(X2, X);
    const T s11 = dot(m, m), s12 = dot(m, n), s22 = dot(n, n);
    const T shear = 0.5 * ks * (a * a * s11 + 2.0 * a * b * s12 + b * b * s22);
    // the relative rotation along the mean of X1 and X2 is twist, across it is bending
    const Vector3<T> v = relative_sine(ends.i, ends.j), mean = X1 + X2;
    const T parallel = dot(v, mean), along = parallel * parallel / dot(mean, mean);
    const T bending = 0.5 * (k.A - ks * a * a) * (s11 - 2.0 * s12 + s22) + 2.0 * k.kt * (dot(v, v) - along);
    return {0.5 * k.kn * ((present - L) * (present - L)), shear, bending, 2.0 * k.kt * along};
}

// Cosines c1 and c2 and the square w² of a beam, which decrease as it approaches a false minimum of U.
template <class T> struct BeamTurn {
    T c1, c2, w2;
};
template <class T> BONDEM_INLINE BeamTurn<T> beam_turn(const Ends<T> &ends, Vector3<T> direction) {
    const T inverse = 1.0 / length(ends.branch), w = relative_cosine(ends.i, ends.j);
    return {dot(ends.branch, rotate(ends.i, direction)) * inverse, dot(ends.branch, rotate(ends.j, direction)) * inverse,
            w * w};
}

}  // namespace bondem
