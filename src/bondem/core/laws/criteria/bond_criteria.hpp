// Lists of criteria on single bonds, which `python -m tests.core.tables` writes from the headers here.
//
// A list expands DO(with, name, Criterion) for each criterion, with the name of its header. The names of
// passes end in that name, as in `judge_beams_by_mohr_coulomb`, by which Python finds the passes.
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
