// Lists of all criteria on the loads of single bonds. The core has no other list: a new criterion needs a header and
// a line here.
//
// A list calls DO(with, name, Criterion) for each criterion. Names of passes end with `name`, as in
// `judge_beams_by_mohr_coulomb`; Python finds the passes by it (`BondCriterion.kind`).
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
// Criteria that apply to facets of cells, which have a traction and no moments (`needs_beams` is false in Python).
#define BONDEM_FACET_CRITERIA(DO, with) DO(with, mohr_coulomb, MohrCoulomb)
// Criteria at which beams begin to soften; they have `pulled_and_sheared` in Python.
#define BONDEM_SOFTENING_CRITERIA(DO, with)       \
    DO(with, peripheral_stress, PeripheralStress) \
    DO(with, mohr_coulomb, MohrCoulomb)
