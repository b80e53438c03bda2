// Peripheral stress: a beam fails where its outermost fibre reaches the tensile strength f_t, or where its section
// reaches the shear strength f_s.
//
//     σ = N / A + β |M| r / I ≥ f_t        τ = |Q| / A + |T| r / J ≥ f_s
//
// with A = π r², I = π r⁴ / 4 and J = 2 I for a circular section of radius r. N is the axial force, positive in
// tension, Q the shear force and T the torque. M is the larger bending moment of both ends, or that at the contact
// point, and β in [0, 1] the part of M that counts. Compression alone breaks no beam. Coefficients:
//
//     a = 1 / (A f_t)    b = β r / (I f_t)    c = 1 / (A f_s)    d = r / (J f_s)
//
// Potyondy and Cundall (2004), eq. (19); β of Potyondy (2011).
#pragma once
#include "loads.hpp"

namespace bondem {

struct PeripheralStress : BondCriterion {
    static constexpr bool softens = true;
    template <class T> static BONDEM_INLINE Verdict<T> verdict(const BondLoads<T> &load, const Coefficients<T> &s) {
        const T along = load.axial * s.a + load.bending * s.b, across = load.shear * s.c + load.twisting * s.d;
        const T tension = constant<T>(failure_mode::tension), shear = constant<T>(failure_mode::shear);
        return {along >= across ? along : across, along >= across ? tension : shear};
    }
};

}  // namespace bondem
