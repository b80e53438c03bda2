// Sum Σ b⊗f over the active cracks of a cell (`crack_states.cpp`), for its stress. The lever b from the centre of the
// cell to the crack is given in the frame of the cell, and the force f along fixed axes.
#pragma once
#include "single_cracks.hpp"

namespace bondem {

// Column of `StressesOfCells.carried` that is 0 for a cell that has had no crack.
constexpr Index has_cracks = 3;

struct Carried {
    Four sum[3];  // b_x f, b_y f, b_z f with b in units of pitch, each followed by a number without meaning

    // `b` is the lever; `f` has the three components of the force and a fourth number that does not count.
    BONDEM_INLINE void add(const int32_t *b, Four f) {
        for (int r = 0; r < 3; r++) sum[r] += double(b[r]) * f;
    }
    BONDEM_INLINE void put(const StressesOfCells &stresses, const double *pitch, Index p) const {
        for (int c = 0; c < 12; c++) stresses.carried(p, c) = pitch[c / 4] * sum[c / 4][c % 4];
        stresses.carried(p, has_cracks) = 1.0;
    }
};

// Sums b⊗f of the cracks of cell p, from the forces of the last step.
inline void carry_cracks_of(const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists,
                            Index p) {
    Carried sum = {};
    for (Index h = lists.head(p); h > 0; h = lists.next(h)) {
        const Four pull = *reinterpret_cast<const FourInMemory *>(&cracks.pull(facet_of(h), 0));
        sum.add(lever_of(cracks, h), h % 2 == 1 ? pull : -pull);
    }
    sum.put(stresses, cracks.pitch.data, p);
}

}  // namespace bondem
