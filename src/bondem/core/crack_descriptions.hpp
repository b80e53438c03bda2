// How the tables and passes of cracks and of yielding describe themselves to Python.
#pragma once
#include "described_tables.hpp"
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

// Lines of the lists in `index.cpp`.
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
