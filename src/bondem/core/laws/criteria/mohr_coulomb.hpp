// Mohr–Coulomb criterion with a tensile strength f_t, for the traction of a bond or facet, which fails if
//
//     t_n ≥ f_t    or    |t_s| + t_n tan φ ≥ C
//
// with the cohesion C and the angle of friction φ. t_n = N / A is the normal traction, positive in tension, and
// t_s = Q / A the shear traction. N is the normal force, Q the shear force and A the area. Moments have no influence.
// If f_t > C / tan φ, f_t is never reached. Coefficients:
//
//     a = 1 / (A f_t)    b = 1 / (A C)    c = tan φ
#pragma once
#include "loads.hpp"

namespace bondem {

struct MohrCoulomb : BondCriterion {
    static constexpr bool of_facets = true, softens = true;
    template <class T> static BONDEM_INLINE Verdict<T> verdict(const BondLoads<T> &load, const Coefficients<T> &s) {
        const T along = load.axial * s.a, across = (load.shear + load.axial * s.c) * s.b;
        const T tension = constant<T>(failure_mode::tension), shear = constant<T>(failure_mode::shear);
        return {along >= across ? along : across, along >= across ? tension : shear};
    }
};

}  // namespace bondem
