// All criteria on the loads of single bonds. This is their only list in the core: a further one is a header and a line.
//
// A list calls DO(with, name, Criterion) for each. Passes have the name in theirs, as in `judge_beams_by_mohr_coulomb`,
// and Python finds them by it (`BondCriterion.kind`).
#pragma once
#include "elliptic.hpp"
#include "linear_sum.hpp"
#include "mohr_coulomb.hpp"
#include "peripheral_stress.hpp"

#define BONDEM_BEAM_CRITERIA(DO, with)            \
    DO(with, peripheral_stress, PeripheralStress) \
    DO(with, mohr_coulomb, MohrCoulomb)           \
    DO(with, linear_sum, LinearSum)               \
    DO(with, ellipse, Elliptic)
// Those of facets of cells, which have a traction and no moments; not `needs_beams` in Python.
#define BONDEM_FACET_CRITERIA(DO, with) DO(with, mohr_coulomb, MohrCoulomb)
// Those from which beams soften; they have `pulled_and_sheared` in Python.
#define BONDEM_SOFTENING_CRITERIA(DO, with)       \
    DO(with, peripheral_stress, PeripheralStress) \
    DO(with, mohr_coulomb, MohrCoulomb)
