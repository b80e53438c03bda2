// How the tables and passes of cells describe themselves to Python.
#pragma once
#include "described.hpp"
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

#define F BONDEM_FIELD

BONDEM_TABLE(ElasticFacets, F(i, "m"), F(j, "m"), F(integrity, "m"), F(k, "m"), F(pitch, "3"), F(lever_i, "3 m"),
             F(lever_j, "3 m"), F(share_i, "3 m"), F(share_j, "3 m"), F(H, "6 m"), F(normal, "3 m"), F(period, "6"))
BONDEM_TABLE(CellDilatation, F(weight, "n"), F(given, "n"), F(swelling, "*"), F(to_i, "m"))
BONDEM_TABLE(DilatationGradients, F(start, "n+1"), F(other, "springs"), F(spring, "springs"), F(difference, "n"),
             F(layer, "layered+1"), F(next, "turns"), F(way, "turns 12"), F(hold, "layered+1"),
             F(wall, "layer_walls"), F(wall_way, "layer_walls 6"), F(weight, "layered 2"), F(bend, "layered 2"),
             F(torque, "layered 3"), F(energy, "element_portions"))
BONDEM_TABLE(CorrectedMass, F(in_start, "n+1"), F(out_start, "n+1"), F(out_bond, "*"), F(factor, "n"), F(wall_start, "n+1"), F(wall, "held"), F(acceleration, "n 6"),
             F(inertia, "n"), F(force, "n 6"))
BONDEM_TABLE(DilatationEnergy, F(energy, "element_portions"))
BONDEM_TABLE(CellEnergies, F(energy, "4"))
BONDEM_TABLE(CellPoses, F(pose, "n 8"), F(rest, "n 3"))
BONDEM_TABLE(FacetForces, F(bends, "m"), F(force, "3 m"), F(moment, "n 7"), F(sums, "* 8"))
BONDEM_TABLE(FacetsOfCells, F(in_start, "n+1"), F(out_start, "n+1"), F(out_bond, "*"))
BONDEM_TABLE(FacetRelease, F(whole, "n"), F(weight, "n"), F(given, "n"), F(slack_i, "bonds"), F(slack_j, "bonds"),
             F(in_start, "n+1"), F(out_start, "n+1"), F(out_bond, "bonds"), F(wall_start, "n+1"), F(wall, "held"),
             F(changed, "n"), F(changes, "1"))
BONDEM_TABLE(WallConstraints, F(cell, "held"), F(row, "held"), F(k, "held"), F(lever, "held 3"), F(arm, "held 3"),
             F(share, "held 3"), F(H, "held 6"), F(base, "held 7"), F(axes, "held 3"), F(drive, "held 3"),
             F(rate, "hold_schedules"), F(times, "hold_times"), F(values, "hold_times"), F(start, "hold_schedules+1"),
             F(place, ""), F(wall, "held 3"), F(came, "held 3"), F(load, "held 6"), F(friction, "held"), F(inward, "held 3"))
BONDEM_TABLE(FacetTractions, F(value, "tractions n"), F(schedule, "tractions"), F(place, ""), F(factor, "tractions"),
             F(came, "tractions"))
BONDEM_TABLE(CellStrains, F(schedule, "strains"), F(base_i, "3 strained"), F(base_j, "3 strained"), F(still, "strained"),
             F(part, "strains strained"), F(wall_base, "held 3"), F(wall_still, "held"), F(wall_part, "strains held"),
             F(place, ""), F(factor, "4 strains"), F(power, "bond_portions strains"), F(cracked, "strains"),
             F(due, "2"))
BONDEM_TABLE(WallTime, F(time, ""))
BONDEM_TABLE(TurnedVectors, F(quaternion, "vectors 4"), F(vector, "vectors 3"), F(turned, "vectors 3"))
BONDEM_TABLE(MomentsOfForces, F(moment, "* 6"), F(owner, "vectors"), F(arm, "vectors 3"), F(force, "vectors 3"), F(sign, ""))

#undef F

// Lines of the lists in `index.cpp`.
#define BONDEM_CELL_TABLES                                                                                      \
    described<ElasticFacets>(), described<CellDilatation>(), described<DilatationGradients>(),                  \
        described<CorrectedMass>(), described<DilatationEnergy>(), \
        described<CellEnergies>(), described<CellPoses>(), described<FacetForces>(), described<FacetsOfCells>(), \
        described<WallConstraints>(), described<FacetTractions>(), described<CellStrains>(), described<WallTime>(), \
        described<FacetRelease>(), described<TurnedVectors>(), described<MomentsOfForces>()
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
