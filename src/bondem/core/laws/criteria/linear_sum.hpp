// Linear sum: a bond fails when the sum of its four loads, each divided by its strength, reaches 1.
//
//     N / N_max + |Q| / Q_max + |M| / M_max + |T| / T_max ≥ 1
//
// N is the axial force, positive in tension, so that compression strengthens; Q the shear force [N]; M the bending
// moment, the larger one of both ends of a beam, or that at the contact point; T the torque [N·m]. The coefficients
// a, b, c and d are the inverse strengths in this order. The mode is that of the largest term, or of the first of
// several equal ones.
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
