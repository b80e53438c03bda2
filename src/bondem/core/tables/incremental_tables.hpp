// Tables of the passes over beams of the incremental formulation, in addition to `Beams` (`step_tables.hpp`).
#pragma once
#include "../array.hpp"

namespace bondem {

// Data that m beams store from step to step.
struct StoredLoads {
    Array<const double, 1> kb;  // bending stiffness [N·m], (m,)
    Array<double, 2> history;  // force [N] and moment [N·m] on i at the contact point, (6, m)
};
// Force on j and torques on i and j of each beam.
struct LoadsOfEach {
    Array<double, 2> found;  // [N, N·m], (9, m)
};

}  // namespace bondem
