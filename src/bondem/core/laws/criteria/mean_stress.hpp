// Mean stress: a facet of cells fails where the mean of the three principal stresses reaches a strength f.
//
//     (σ1 + σ2 + σ3) / 3 ≥ f
//
// Tension is positive. A bar in uniaxial tension fails at the stress 3 f. The only parameter is f.
#pragma once
#include "../stress.hpp"

namespace bondem {

struct MeanStress {
    static constexpr Index parameters = 1;
    template <class T> static BONDEM_INLINE T index(const Stress<T> &stress, const double *parameter) {
        return trace(stress) / (T{} + 3.0 * parameter[0]);
    }
};

}  // namespace bondem
