// Mohr–Coulomb on the traction of a bond or facet, with a tensile strength f_t: cohesion C and angle of friction φ.
//
//     t_n ≥ f_t        |t_s| + t_n tan φ ≥ C
//
// with t_n = N / A and t_s = Q / A; moments do not count. Tension positive, so that compression strengthens. Where
// f_t > C / tan φ the cohesion alone limits the traction. Coefficients:
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
