// Lists of criteria on single bonds, written by `python -m tests.core.tables` from the headers beside it.
//
// A list calls DO(with, name, Criterion) for each. Names of passes end with `name`, which is that of the
// header, as in `judge_beams_by_mohr_coulomb`; Python finds the passes by it (`BondCriterion.kind`).
#pragma once
#include "elliptic.hpp"
#include "linear_sum.hpp"
#include "mohr_coulomb.hpp"
#include "peripheral_stress.hpp"

#define BONDEM_BEAM_CRITERIA(DO, with) \
    DO(with, elliptic, Elliptic) \
    DO(with, linear_sum, LinearSum) \
    DO(with, mohr_coulomb, MohrCoulomb) \
    DO(with, peripheral_stress, PeripheralStress)
#define BONDEM_FACET_CRITERIA(DO, with) \
    DO(with, mohr_coulomb, MohrCoulomb)
#define BONDEM_SOFTENING_CRITERIA(DO, with) \
    DO(with, mohr_coulomb, MohrCoulomb) \
    DO(with, peripheral_stress, PeripheralStress)
