// Criteria on the largest and the least principal stress σ1 and σ3. Tension is positive. A bond fails if
//
//     max(a σ1, b σ1 - c σ3) ≥ 1
//
// Rankine has only a = 1 / f_t, with the tensile strength f_t. Mohr and Coulomb have b, c = (1 ± sin φ) / (2 C cos φ)
// with the cohesion C and the angle of friction φ. The larger term determines the mode of failure: tension or shear.
//
// Bonds of the non-local law fail by the mean stress of their two elements: Celigueta et al. (2020), eqs (5), (8) and
// (9).
#pragma once
#include "loads.hpp"

namespace bondem {

struct PrincipalStressCriterion {
    template <class T> static BONDEM_INLINE Verdict<T> verdict(T largest, T least, const Coefficients<T> &s) {
        const T pulled = s.a * largest, sheared = s.b * largest - s.c * least;
        const T tension = constant<T>(failure_mode::tension), shear = constant<T>(failure_mode::shear);
        return {pulled >= sheared ? pulled : sheared, pulled >= sheared ? tension : shear};
    }
};

}  // namespace bondem
