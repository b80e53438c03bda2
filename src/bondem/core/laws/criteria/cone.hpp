// The cone of Drucker and Prager (1952): shear strength k that grows with pressure.
//
//     √J2 + α I1 ≥ k        J2 = ½ s : s of the deviator s,  I1 = σ1 + σ2 + σ3
//
// Tension is positive. The index (1 at failure) is the left side over k. Parameters: α [-], k [Pa], and a flag, which
// is 1 if cells under pressure yield instead of failing, else 0. With the flag 1 the index is 0 for I1 ≤ 0.
#pragma once
#include "../stress.hpp"

namespace bondem {

struct Cone {
    static constexpr Index parameters = 3;
    template <class T> static BONDEM_INLINE T index(const Stress<T> &s, const double *parameter) {
        const double alpha = parameter[0], strength = parameter[1];
        const T all = trace(s), mean = all / (T{} + 3.0), a = s.xx - mean, b = s.yy - mean, c = s.zz - mean, zero = {};
        const T square = 0.5 * (a * a + b * b + c * c) + (s.xy * s.xy + s.xz * s.xz + s.yz * s.yz);
        const T index = (root(square) + alpha * all) / (T{} + strength);
        if (parameter[2] == 0.0) return index;
        return all > zero ? index : zero;
    }
};

}  // namespace bondem
