// Elliptic criterion: a beam fails by elongation and bending together, which have the limits ε_c and θ_c.
//
//     (ε⁺ / ε_c)² + max(|θ_i|, |θ_j|) / θ_c ≥ 1
//
// ε⁺ is the strain of the beam in tension, else 0. θ_i and θ_j are the angles of the axis of the beam to two other
// axes. The two axes turn with the elements i and j, and agree with the axis of the beam at rest. Coefficients:
// a = 1 / ε_c, b = 1 / θ_c.
//
// Carmona, Wittel, Kun and Herrmann (2008), eq. (5) of arXiv:0711.2993, where ε² also counts in compression.
#pragma once
#include "loads.hpp"

namespace bondem {

struct Elliptic : BondCriterion {
    static constexpr bool sees_angles = true;
    template <class T> static BONDEM_INLINE Verdict<T> verdict(const BondLoads<T> &load, const Coefficients<T> &s) {
        const T zero = {}, strain = load.strain > zero ? load.strain : zero;
        const T stretch = strain * s.a, along = stretch * stretch, about = load.angle * s.b;
        const T tension = constant<T>(failure_mode::tension), bending = constant<T>(failure_mode::bending);
        return {along + about, along >= about ? tension : bending};
    }
};

}  // namespace bondem
