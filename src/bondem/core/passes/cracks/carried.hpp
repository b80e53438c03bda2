// Σ b⊗f of the cracks of a cell, with b the lever in the reference and f the force in space.
#pragma once
#include "single_cracks.hpp"

namespace bondem {

// Column of `StressesOfCells.carried` that is 0 for a cell that has had no crack.
constexpr Index has_cracks = 3;

struct Carried {
    double sum[12];  // b_x f, b_y f, b_z f, each and another number, b in its pitch

    // `b` is the lever; `f` has the three components of the force and a fourth number that does not count.
    BONDEM_INLINE void add(const int32_t *b, const double *f) {
        for (int r = 0; r < 3; r++) {
            const double along = b[r];
            for (int d = 0; d < 4; d++) sum[4 * r + d] += along * f[d];
        }
    }
    BONDEM_INLINE void put(const StressesOfCells &stresses, const double *pitch, Index p) const {
        for (int c = 0; c < 12; c++) stresses.carried(p, c) = pitch[c / 4] * sum[c];
        stresses.carried(p, has_cracks) = 1.0;
    }
};

// Σ b⊗f of the cracks of cell p, from the forces of the last step.
inline void carry_cracks_of(const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists,
                            Index p) {
    Carried sum = {};
    for (Index h = lists.head(p); h > 0; h = lists.node(h, 0)) {
        const double *const pull = &cracks.pull(lists.side(h) >> 1, 0);
        double f[4];
        for (int d = 0; d < 4; d++) f[d] = lists.side(h) % 2 == 0 ? pull[d] : -pull[d];
        sum.add(&lists.node(h, 1), f);
    }
    sum.put(stresses, cracks.pitch.data, p);
}

}  // namespace bondem
