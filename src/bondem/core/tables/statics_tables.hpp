// Tables of the passes that find equilibria.
#pragma once
#include "step_tables.hpp"

namespace bondem {

// Motion, loads and constraints of n elements that relax.
struct DynamicRelaxation {
    Array<double, 2> pose;  // (n, 8)
    Array<double, 2> velocity;  // of centres and rotations, (n, 6)
    Array<double, 2> before;  // forces and torques of the bonds in the step before [N, N·m], (n, 6)
    Array<const double, 2> load;  // at the end of the ramp [N, N·m], (n, 6)
    Array<const double, 2> inverse;  // 1 / mass and 1 / moment of inertia, 0 where nothing is bonded, (n, 2)
    Array<const Byte, 2> free;  // degrees of freedom that nothing prescribes, (n, 6)
    Array<const double, 2> motion;  // prescribed displacements and rotations at the end of the ramp [m, rad], (n, 6)
    Array<double, 1> memory;  // running means Σ v·ΔF and Σ m v² of the steps so far, (2,)
    Index ramp;  // steps in which loads and prescribed motions grow
    double length;  // length that turns torques into forces [m]
    double tolerance;  // unbalanced force over applied and supporting force at which to stop [-]
    double noise;  // force that rounding leaves [N]
};
// Steps of one call of the core.
struct RelaxationSpan {
    Index first;  // number of the first step
    Index steps;  // largest number of steps
    Array<Index, 1> done;  // number of steps that were taken, (1,)
    Array<double, 1> ratio;  // unbalanced force over applied and supporting force [-], (1,)
};

}  // namespace bondem
