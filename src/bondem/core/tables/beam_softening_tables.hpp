// What passes over beams that soften take. Named once more in `bondem/dynamics/damage_tables.py`.
#pragma once
#include "damage_tables.hpp"

namespace bondem {

// Bounds of beams that have not begun to soften, and the stiffness that the softened part of the others has in compression.
struct SofteningBounds {
    Array<float, 1> limit;  // as of `FailureBounds`, inf of beams that have begun [-], (m,)
    double of_force, of_moment;  // [1/N², 1/(N·m)²]
    Array<double, 1> press;  // (1 - s) kn [N/m], (m,)
};
// Beams that soften. A row has: bond, opening λ0 at the beginning and λf at the end [√J], -∂U/∂s a step ago [J], energy
// dissipated [J], mode.
struct SofteningBeams {
    Array<const double, 1> tear, slide;  // G_f A and G_II A [J], (bonds,)
    Array<double, 2> onset;  // energies of opening and sliding of beams that are found to begin [J], (bonds, 2)
    Array<double, 2> row;  // beams in the order in which they began, (bonds, 6)
    Array<Index, 1> begun;  // number of rows, (1,)
    Array<Index, 1> listed;  // rows that have not broken, those of a portion of bonds from its first bond on, (bonds,)
    Array<Index, 1> number, parted;  // of rows of each portion, and of those behind them that break in this step
    Array<double, 1> lost;  // energy that each portion dissipates in this step [J]
};

}  // namespace bondem
