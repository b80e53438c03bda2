// What Python finds in the library: its tables, its passes, and what the CPU is capable of.
#include "cell_descriptions.hpp"
#include "crack_descriptions.hpp"
#include "described_tables.hpp"
#include "device_descriptions.hpp"
#include "exported.hpp"
#include "instructions.hpp"
#include "lagged_descriptions.hpp"
#include "lanes.hpp"
#include "passes/assembly/stiffness.hpp"
#include "passes/packing/growth.hpp"
#include "passes/packing/neighbours.hpp"
#include "passes/packing/relaxation.hpp"
#include "passes/surface/nearest_triangle.hpp"
#include "passes/tessellation/balance.hpp"
#include "passes/tessellation/clip_to_shape.hpp"
#include "passes/tessellation/interfaces.hpp"
#include "passes/tessellation/laguerre.hpp"
#include "passes/tessellation/measures.hpp"
#include "passes/tessellation/ownership.hpp"
#include "quasistatic_descriptions.hpp"
#include "statics_descriptions.hpp"
#include "step_descriptions.hpp"

namespace bondem {

namespace {

const TableDescription tables[] = {BONDEM_TABLES};

#define P(pass, outcomes) described(#pass, outcomes, pass)
const PassDescription passes[] = {
    P(relax_spheres, "converged out_of_date exhausted loose"),
    P(fly_and_grow, "grown list_out_of_date too_many_events"),
    P(sort_into_cells, ""),
    P(sort_and_count_neighbours, ""),
    P(list_neighbours, ""),
    P(make_cells, "cells_made crowded narrow swallowed lists_full pile_full"),
    P(split_by_walls, "all_split pieces_full scratch_full"),
    P(divide_solids, "all_divided parts_full room_full"),
    P(match_faces, "all_matched patches_full rest_full"),
    P(measure_polygons, ""),
    P(measure_solids, ""),
    P(apply_balance, ""),
    P(assemble_beams, ""),
    P(assemble_facets, ""),
    P(find_nearest_triangles, ""),
    P(load_beams, ""),
    P(load_alike_beams, ""),
    P(measure_beam_energies, ""),
    P(count_turned_beams, ""),
    BONDEM_LAGGED_LOADS,
    BONDEM_STATICS_PASSES,
    BONDEM_DAMAGE_INDICES,
    BONDEM_CELL_PASSES,
    BONDEM_QUASISTATIC_PASSES,
    BONDEM_CONTACT_SEARCH,
    BONDEM_CRACK_PASSES,
    P(take_steps, "sound not_finite runaway out_of_date"),
};
#undef P

// What a step is composed of.
#define S(kind, pass) described(#pass, kind, Called<pass>::call, pass)
const StepPassDescription step_passes[] = {
    S(serial, clear_row_forces),
    S(serial, follow_loads),
    S(serial, follow_couples),
    S(serial, follow_drives),
    S(serial, follow_body_forces),
    S(serial, follow_strains),
    S(of_elements, open_elements),
    S(of_elements, open_elements_and_rows),
    S(of_elements, open_body_work),
    S(bonds_of_blocks, add_beam_loads),
    S(bonds_of_blocks, add_alike_beam_loads),
    S(bonds_of_blocks, add_dashpot_loads),
    S(parts_of_shared, collect_sums),
    S(parts_of_shared, collect_dashpots),
    S(elements_of_blocks, add_dashpots),
    S(elements_of_blocks, add_body_forces),
    S(elements_of_blocks, move_elements),
    S(elements_of_blocks, move_rows),
    S(elements_of_blocks, move_resisted),
    S(elements_of_blocks, move_resisted_rows),
    S(elements_of_blocks, add_body_work),
    S(elements_of_blocks, reopen_elements),
    S(elements_of_blocks, reopen_rows),
    S(of_bonds, check_beams),
    S(of_bonds, sum_beam_energies),
    S(of_elements, sum_element_energies),
    S(serial, judge_energy),
    S(serial, write_ledger),
    S(serial, read_gauges),
    BONDEM_LAGGED_PASSES,
    BONDEM_DAMAGE_PASSES,
    BONDEM_CELL_STEP_PASSES,
    BONDEM_CONTACT_PASSES,
    BONDEM_CRACK_STEP_PASSES,
    BONDEM_STRESS_ONSET_PASSES,
};
#undef S

#define X(pass) IndexPass<pass>::described(#pass),
const PassDescription index_passes[] = {BONDEM_INDEX_PASSES(X)};
#undef X

}  // namespace
}  // namespace bondem

BONDEM_EXPORT const bondem::TableDescription *bondem_tables(bondem::Index *count) {
    *count = sizeof(bondem::tables) / sizeof(bondem::tables[0]);
    return bondem::tables;
}
BONDEM_EXPORT const bondem::PassDescription *bondem_passes(bondem::Index *count) {
    *count = sizeof(bondem::passes) / sizeof(bondem::passes[0]);
    return bondem::passes;
}
BONDEM_EXPORT const bondem::StepPassDescription *bondem_step_passes(bondem::Index *count) {
    *count = sizeof(bondem::step_passes) / sizeof(bondem::step_passes[0]);
    return bondem::step_passes;
}
BONDEM_EXPORT const bondem::PassDescription *bondem_index_passes(bondem::Index *count) {
    *count = sizeof(bondem::index_passes) / sizeof(bondem::index_passes[0]);
    return bondem::index_passes;
}
// Numbers of a register, as many as there are bonds in a group; tables of fewer bonds are filled.
BONDEM_EXPORT bondem::Index bondem_lanes() { return bondem::lanes; }
// The level that this library was compiled for.
BONDEM_EXPORT bondem::Index bondem_compiled_level() { return bondem::compiled_level; }
