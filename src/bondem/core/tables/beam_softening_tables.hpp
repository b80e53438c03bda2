// Tables of the passes over softening beams.
#pragma once
#include "damage_tables.hpp"

namespace bondem {

// Beams that may soften: bounds of whole beams, their criterion, and the data that softening changes.
struct SofteningBounds {
    Array<float, 1> limit;  // as of `FailureBounds`, inf of beams that have begun, (m,)
    double of_force;  // [1/N²]
    double of_moment;  // [1/(N·m)²]
    Array<const double, 2> coefficient;  // as of `Strengths`, (bonds, 4)
    Array<const double, 1> station;  // (bonds,)
    Array<const double, 1> tear;  // G_f A [J], (bonds,)
    Array<const double, 1> slide;  // G_II A [J], (bonds,)
    Array<double, 1> integrity;  // 1 whole … 0 broken [-], (m,)
    Array<double, 1> per_length;  // integrity over rest length of beams that share their constants [1/m], (*,)
    Array<double, 1> press;  // stiffness of the softened part of a beam in compression, (1 - s) kn [N/m], (m,)
    Array<double, 2> onset;  // openings [√J] and energies [J] of beams that begin in this step, (bonds, 4)
};
// Beams that soften.
struct SofteningBeams {
    // beams in the order in which they began, columns of `SoftColumn`
    Array<double, 2> row;  // (bonds, soft_column::count)
    Array<Index, 1> rows;  // number of rows, (1,)
    Array<Index, 1> listed;  // rows that have not broken, those of a portion of bonds from its first bond on, (bonds,)
    Array<Index, 1> number;  // number of rows of each portion, (bond_portions,)
    Array<Index, 1> parted;  // number of those that break in this step, after the others, (bond_portions,)
    Array<Index, 2> lost;  // exact sum of the energy dissipated in this step [J], (1, exact_word::count)
};

}  // namespace bondem
