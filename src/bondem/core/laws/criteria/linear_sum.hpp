// Linear sum: a bond fails when the sum of its four loads, each divided by its strength, reaches 1.
//
//     N / N_max + |Q| / Q_max + |M| / M_max + |T| / T_max ≥ 1
//
// N is the axial force [N], positive in tension, so that compression strengthens. Q is the shear force [N], T the
// torque [N·m], and M the bending moment [N·m]. M is the larger of the moments at both ends of a beam, or the moment
// at the contact point. The coefficients a, b, c and d are 1 / N_max, 1 / Q_max, 1 / M_max and 1 / T_max. The mode of
// failure is that of the largest term, or of the first of several equal ones.
//
// Source: `bond_style bpm/rotational` of LAMMPS, after Wang (2009).
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
