// Linear sum: a bond fails where the shares of its four strengths sum up to 1.
//
//     N / N_max + |Q| / Q_max + |M| / M_max + |T| / T_max ≥ 1
//
// Tension positive; N counts with its sign, so that compression strengthens. M is the larger of the moments at both
// ends of a beam, or that at the contact point. Coefficients: the inverse strengths in this order. The mode is that
// of the largest share, the first one of equal shares.
//
// `bond_style bpm/rotational` of LAMMPS, after Wang (2009).
#pragma once
#include "loads.hpp"

namespace bondem {

struct LinearSum : BondCriterion {
    template <class T> static BONDEM_INLINE Verdict<T> verdict(const BondLoads<T> &load, const Coefficients<T> &s) {
        const T n = load.axial * s.a, q = load.shear * s.b, m = load.bending * s.c, t = load.twisting * s.d;
        T mode = constant<T>(failure_mode::tension), largest = n;
        mode = q > largest ? constant<T>(failure_mode::shear) : mode;
        largest = q > largest ? q : largest;
        mode = m > largest ? constant<T>(failure_mode::bending) : mode;
        largest = m > largest ? m : largest;
        mode = t > largest ? constant<T>(failure_mode::twisting) : mode;
        return {n + q + m + t, mode};
    }
};

}  // namespace bondem
