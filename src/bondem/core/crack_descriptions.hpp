// How the tables and passes of cracks and of yielding describe themselves to Python.
#pragma once
#include "described.hpp"
#include "passes/cracks/crack_lists.hpp"
#include "passes/cracks/crack_loads.hpp"
#include "passes/cracks/crack_samples.hpp"
#include "passes/cracks/crack_states.hpp"
#include "passes/cracks/onset.hpp"
#include "passes/cracks/opening.hpp"
#include "passes/cracks/stress_onset.hpp"
#include "passes/cracks/crack_strains.hpp"
#include "passes/cracks/parted_faces.hpp"
#include "passes/cracks/stress_state.hpp"

namespace bondem {

#define F BONDEM_FIELD

BONDEM_TABLE(SofteningSamples, F(given, "36 m"), F(kink, ""), F(steep, ""), F(wide, ""), F(left, "5 m"))
BONDEM_TABLE(CrackSamples, F(given, "60 m"), F(wide, ""), F(found, "29 m"))
BONDEM_TABLE(YieldSamples, F(stress, "6 m"), F(strength, "5 m"), F(cone, ""), F(wide, ""), F(found, "12 m"))
BONDEM_TABLE(StressBoundSamples, F(stress, "6 m"), F(bent, "m"), F(wide, ""), F(found, "5 m"))

BONDEM_TABLE(StressesOfCells, F(volume, "n"), F(tensor, "n 8"), F(carried, "n 12"), F(pressed, "* n 6"))
BONDEM_TABLE(YieldingCells, F(cone, ""), F(cohesion, "n"), F(slope, "n"), F(dilation, "n"), F(stiffness, "n"),
             F(fade, "n"), F(near_start, "n+1"), F(near, "*"), F(slipped, "n"), F(held, "n"), F(plastic, "n 17"),
             F(base_i, "3 m"), F(base_j, "3 m"), F(base_wall, "held 3"))
BONDEM_TABLE(FacetStrengths, F(area, "m"), F(strength, "m"), F(absorbed, "m"), F(brittleness, "m"), F(part, "m"), F(fastest, "m"),
             F(friction, "m"), F(plane, "m"), F(cohesion, "m"), F(slip_brittleness, "m"), F(planes, "*"), F(kink, ""),
             F(steep, ""), F(hot, ""))
BONDEM_TABLE(CrackOnset, F(cracked, "n"), F(judged, "n"), F(marked, "m"), F(listed, "m"), F(found, "bond_portions+1"))
BONDEM_TABLE(CandidateFacets, F(scale, "m"), F(area, "m"), F(tension, ""), F(least, ""), F(hot, ""), F(along, "m"),
             F(bond, "candidates"), F(stress, "candidates 3 3"), F(found, "candidates"), F(number, "bond_portions"),
             F(total, "1"))
BONDEM_TABLE(CohesiveCracks, F(shape, "facets 8"), F(face, "facets 8"), F(state, "facets 8"), F(frame, "facets 8"),
             F(past, "facets 8"), F(softening, "facets 8"),
             F(history, "facets 8"), F(pull, "facets 4"), F(pitch, "3"), F(order, "facets"), F(listed, "m"),
             F(integrity, "facets"), F(size, "2"), F(slide, ""))
BONDEM_TABLE(CellSlack, F(in_start, "n+1"), F(out_start, "n+1"), F(out_bond, "*"), F(slack_i, "m"), F(slack_j, "m"),
             F(weight, "n"))
BONDEM_TABLE(CrackLists, F(size, "4"), F(treated, "places"), F(resting, "places"), F(treated_i, "places"),
             F(treated_j, "places"), F(resting_i, "places"), F(resting_j, "places"), F(parted, "places"), F(cell, "*"),
             F(head, "n"), F(number, "places 2"), F(side, "halves"), F(node, "halves 4"), F(flag, "places"), F(waking, "places"), F(flagged, "crack_portions"),
             F(woken, "crack_portions"), F(stale, "n"), F(base, "n"), F(half, "halves 16"), F(sum, "n 8"), F(slip, "n 4"),
             F(lost, "crack_portions 2"))
BONDEM_TABLE(PartedReach, F(apart, "*"))
BONDEM_TABLE(CrackEnergies, F(dilatation, "element_portions"), F(heat, "element_portions"), F(cracked, "3"))

#undef F

// Lines of the lists in `index.cpp`.
#define BONDEM_CRACK_TABLES                                                                                   \
    described<SofteningSamples>(), described<CrackSamples>(), described<YieldSamples>(),                      \
        described<StressBoundSamples>(),                                                                      \
        described<StressesOfCells>(), described<YieldingCells>(), described<FacetStrengths>(),                   \
        described<CrackOnset>(), described<CandidateFacets>(), described<CohesiveCracks>(), described<CellSlack>(),      \
        described<CrackLists>(), described<CrackEnergies>(), described<PartedReach>()
#define BONDEM_CRACK_PASSES P(evaluate_softening, ""), P(evaluate_cracks, ""), P(evaluate_yielding, ""), \
        P(evaluate_stress_bounds, "")
#define BONDEM_STRESS_ONSET_PASSES                                                                            \
    S(of_elements, judge_cells_by_mean_stress), S(of_elements, judge_cells_by_cone),                          \
        S(of_elements, judge_cells_by_size), S(of_bonds, find_stress_candidates), S(serial, mark_failing_facets), \
        S(serial, find_strengths_along)
#define BONDEM_CRACK_STEP_PASSES                                                                              \
    S(of_elements, find_cell_stresses), S(serial, add_surface_stresses), S(of_elements, find_still_stresses), \
        S(serial, add_still_surface_stresses), S(serial, follow_levers), S(of_elements, judge_cells),         \
        S(serial, stretch_anew), S(serial, sum_crack_powers), S(serial, begin_crack_powers), \
        S(of_elements, yield_cells), S(of_elements, stretch_cells), S(serial, stretch_walls_and_cracks),      \
        S(of_elements, stretch_all_cells), S(serial, add_yielding_work), S(of_bonds, mark_cracking_facets),   \
        S(serial, mark_cracking_planes), S(serial, begin_cracks), S(serial, link_cracks),                     \
        S(serial, weigh_cracked_cells), S(serial, list_cracks), S(serial, carry_cracks),                      \
        S(of_elements, begin_bases), S(serial, measure_cracks), S(serial, relax_cracked_cells),               \
        S(serial, watch_resting_cracks), S(serial, wake_cracks), S(serial, soften_cracks),                    \
        S(serial, slide_cracks),                                                \
        S(serial, leave_cracks), S(serial, relax_stale_cells), S(serial, load_cracks), S(serial, log_cracks), \
        S(elements_of_blocks, add_crack_loads), S(of_elements, sum_stressed_dilatation),                      \
        S(of_elements, sum_heat), S(serial, sum_crack_energies), S(serial, add_crack_energies),                   \
        S(serial, write_heat), S(serial, write_crushing_of_facets), S(serial, touch_parted_faces)

}  // namespace bondem
