// Σ b⊗f of the cracks of a cell, with b the lever in the reference and f the force in space.
#pragma once
#include "single_cracks.hpp"

namespace bondem {

struct Carried {
    double sum[12];  // b_x f, b_y f, b_z f, each and 0

    // `f` has three numbers and another one, which is left out.
    BONDEM_INLINE void add(const double *b, const double *f) {
        for (int r = 0; r < 3; r++)
            for (int d = 0; d < 4; d++) sum[4 * r + d] += b[r] * f[d];
    }
    BONDEM_INLINE void put(const StressesOfCells &stresses, Index p) const {
        for (int c = 0; c < 12; c++) stresses.carried(p, c) = sum[c];
    }
};

}  // namespace bondem
