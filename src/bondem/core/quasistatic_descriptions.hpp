// How the tables and passes of quasi-static loading describe themselves to Python.
#pragma once
#include "described.hpp"
#include "passes/quasistatic/conjugate_gradients.hpp"
#include "passes/quasistatic/small_motion.hpp"
#include "passes/quasistatic/stress_onset.hpp"

namespace bondem {

#define F BONDEM_FIELD

BONDEM_TABLE(WeakenedFacets, F(i, "m"), F(j, "m"), F(k, "m"), F(area, "m"), F(part, "m"), F(lever_i, "m 3"),
             F(lever_j, "m 3"), F(share_i, "m 3"), F(share_j, "m 3"), F(normal, "m 3"), F(H, "m 3 3"), F(integrity, "m"),
             F(closed, "m 2"))
BONDEM_TABLE(SmallMotions, F(displacement, "n 3"), F(rotation, "n 3"), F(gap, "m 3"), F(swelling, "n"))
BONDEM_TABLE(FacetLoading, F(stress, "n"), F(traction, "m 3"), F(bending, "m"), F(opening, "m 3"), F(opened, "m"),
             F(turned, "m 2"), F(moment, "n 6"))
BONDEM_TABLE(LoadedFacets, F(i, "m"), F(j, "m"), F(normal, "m 3"), F(traction, "m 3"), F(bending, "m"), F(tensor, "n 6"),
             F(strength, "m"))
BONDEM_TABLE(OnsetSearch, F(whole, "whole"), F(below, ""), F(spread, ""), F(factor, "whole"))
BONDEM_TABLE(ScaledMatrix, F(start, "n+1"), F(column, "b"), F(diagonal, "n"), F(block, "b 6 6"), F(form, "b 6"),
             F(rounded_block, "b 6 6"), F(rounded_form, "b 6"), F(weight, "n"))
BONDEM_TABLE(ClumpCorrection, F(place, "n"), F(order, "c"), F(basis, "n 6 6"), F(factor, "c w"), F(rigid, "r x"),
             F(coarse, "c"))
BONDEM_TABLE(ConjugateGradients, F(limits, "2"), F(most, ""), F(residual, "x"), F(found, "x"),
             F(work, "4 x"), F(stress, "n"), F(rounds, "1"), F(first, "1"))

#undef F

#define BONDEM_QUASISTATIC_TABLES                                                                   \
    described<WeakenedFacets>(), described<SmallMotions>(), described<FacetLoading>(), described<LoadedFacets>(), \
        described<OnsetSearch>(), described<ScaledMatrix>(), described<ClumpCorrection>(),         \
        described<ConjugateGradients>()
#define BONDEM_QUASISTATIC_PASSES \
    P(open_weakened_facets, ""), P(load_weakened_facets, ""), P(find_stress_factors, ""), \
    P(conjugate_gradients, "converged stuck")

}  // namespace bondem
