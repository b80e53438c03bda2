// What passes over beams that soften take. Named once more in `bondem/dynamics/damage_tables.py`.
#pragma once
#include "damage_tables.hpp"

namespace bondem {

// Beams that may soften: bounds of those that have not begun, their criterion, and what softening changes.
struct SofteningBounds {
    Array<float, 1> limit;  // as of `FailureBounds`, inf of beams that have begun [-], (m,)
    double of_force, of_moment;  // [1/N², 1/(N·m)²]
    Array<const double, 2> coefficient;  // as of `Strengths`, (bonds, 4)
    Array<const double, 1> station;  // (bonds,)
    Array<const double, 1> tear, slide;  // G_f A and G_II A [J], (bonds,)
    Array<double, 1> integrity;  // 1 whole … 0 broken [-], (m,)
    Array<double, 1> hold;  // integrity over rest length of beams that differ in length only [1/m], (m,), or (0,)
    Array<double, 1> press;  // (1 - s) kn, the stiffness of the softened part in compression [N/m], (m,)
    // of beams that begin in this step: λ0 and λf [√J], -∂U/∂s and the energy dissipated [J], (bonds, 4)
    Array<double, 2> onset;
};
// Beams that soften. A row has: bond, opening λ0 at the beginning and λf at the end [√J], -∂U/∂s a step ago [J], energy
// dissipated [J], mode, step of onset.
struct SofteningBeams {
    Array<double, 2> row;  // beams in the order in which they began, (bonds, 7)
    Array<Index, 1> begun;  // number of rows, (1,)
    Array<Index, 1> listed;  // rows that have not broken, those of a portion of bonds from its first bond on, (bonds,)
    Array<Index, 1> number, parted;  // of rows of each portion, and of those behind them that break in this step
    Array<double, 1> lost;  // energy that each portion dissipates in this step [J]
};

}  // namespace bondem
