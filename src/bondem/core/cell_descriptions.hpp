// How the tables and passes of cells describe themselves to Python.
#pragma once
#include "described_tables.hpp"
#include "passes/cells/body.hpp"
#include "passes/cells/cell_report.hpp"
#include "passes/cells/cell_strains.hpp"
#include "passes/cells/cell_stress.hpp"
#include "passes/cells/corrected_mass.hpp"
#include "passes/cells/dilatation.hpp"
#include "passes/cells/dilatation_gradients.hpp"
#include "passes/cells/facet_failure.hpp"
#include "passes/cells/facet_loads.hpp"
#include "passes/cells/facet_traction.hpp"
#include "passes/cells/observation.hpp"
#include "passes/cells/wall_constraints.hpp"

namespace bondem {

// Lines of the lists in `index.cpp`.
#define BONDEM_INDEX_OF_FACETS(_, name, Criterion) P(index_facets_by_##name, ""),
#define BONDEM_CELL_PASSES                                                                               \
    BONDEM_FACET_CRITERIA(BONDEM_INDEX_OF_FACETS, )                                                      \
    P(load_body, ""), P(load_facets, ""), P(measure_cell_energies, ""), P(place_walls, ""),              \
        P(turn_vectors, ""), P(add_moments, ""), P(weigh_cells, "")
#define BONDEM_JUDGED_FACETS(_, name, Criterion) S(serial, judge_facets_by_##name),
#define BONDEM_CELL_STEP_PASSES                                                                          \
    BONDEM_FACET_CRITERIA(BONDEM_JUDGED_FACETS, )                                                        \
    S(bonds_of_blocks, accumulate_dilatation), S(bonds_of_blocks, accumulate_left_dilatation),             \
        S(parts_of_shared, collect_dilatation),                   \
        S(elements_of_blocks, stress_cells), S(bonds_of_blocks, add_facet_loads),                        \
        S(bonds_of_blocks, add_and_keep_facet_loads), S(parts_of_shared, collect_facet_moments),               \
        S(elements_of_blocks, take_moments), S(of_elements, sum_moments), S(of_bonds, check_facets),     \
        S(of_bonds, sum_facet_energies), S(of_elements, sum_dilatation_energies),                        \
        S(of_elements, sum_stress_differences), S(of_elements, add_stress_differences),                   \
        S(of_elements, bend_layers), S(of_elements, twist_layers), S(elements_of_blocks, add_layer_torques), \
        S(of_elements, sum_gradient_energies), S(serial, add_gradient_energies),                          \
        S(elements_of_blocks, find_accelerations), S(of_elements, find_dilatation_inertia),               \
        S(of_elements, find_inertia_forces), S(elements_of_blocks, add_inertia_forces),                   \
        S(of_elements, subtract_dilatation_energies),                                                     \
        S(serial, add_cell_energies), S(serial, follow_walls), S(serial, add_wall_dilatation),           \
        S(serial, apply_walls), S(elements_of_blocks, add_wall_loads), S(serial, follow_tractions),      \
        S(serial, add_traction_work), S(serial, follow_cell_strains), S(serial, begin_strain_work), \
        S(of_bonds, sum_strain_powers),    \
        S(serial, add_strain_work), S(bonds_of_blocks, accumulate_and_mark), \
        S(serial, withdraw_facets), \
        S(serial, break_facets), S(serial, restore_facets), S(serial, renew_wall_rows)

}  // namespace bondem
