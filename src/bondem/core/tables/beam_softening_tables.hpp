// Tables of the passes over softening beams.
#pragma once
#include "damage_tables.hpp"

namespace bondem {

// Beams that may soften: bounds of whole beams, their criterion, and the data that softening changes.
struct SofteningBounds {
    Array<float, 1> limit;  // bound of the size of a load as in `FailureBounds`, inf once a beam softens, (m,)
    double of_force;  // factor of |F|² in the size of a load [1/N²]
    double of_moment;  // factor of |M|² in the size of a load [1/(N·m)²]
    Array<const double, 2> coefficient;  // coefficients of the criterion, as in `Strengths`, (bonds, 4)
    Array<const double, 1> station;  // place where the moment counts, as in `Strengths`, (bonds,)
    Array<const double, 1> tear;  // fracture energy of opening, G_f A [J], (bonds,)
    Array<const double, 1> slide;  // fracture energy of sliding, G_II A [J], (bonds,)
    Array<double, 1> integrity;  // 1 whole … 0 broken [-], (m,)
    Array<double, 1> per_length;  // integrity over rest length of beams that share their constants [1/m], (*,)
    Array<double, 1> press;  // stiffness of the softened part of a beam in compression, (1 - s) kn [N/m], (m,)
    Array<double, 2> onset;  // of beams that begin to soften in this step: first and last λ [√J], Y and dissipation [J], (bonds, 4)
};
// Beams that soften: their rows, and lists of the unbroken ones.
struct SofteningBeams {
    Array<double, 2> row;  // beams in the order of their onset, columns by `soft_column`, (bonds, soft_column::count)
    Array<Index, 1> rows;  // number of rows, (1,)
    Array<Index, 1> listed;  // unbroken rows; those of a portion begin at the number of its first bond, (bonds,)
    Array<Index, 1> number;  // number of unbroken rows of each portion, (bond_portions,)
    Array<Index, 1> parted;  // number of rows that break in this step, listed after the others, (bond_portions,)
    Array<Index, 2> lost;  // exact sum of the energy dissipated in this step [J], (1, exact_word::count)
};

}  // namespace bondem
