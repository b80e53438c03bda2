// Passes over a body of cells in any poses: its forces, its energies, and the places of its walls.
#include "../../registered.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/step_tables.hpp"
#include "accumulation.hpp"
#include "energies.hpp"
#include "facet_sums.hpp"
#include "gradients.hpp"
#include "walls.hpp"

namespace bondem {
namespace {

void dilate(const CellPoses &all, const ElasticFacets &facets, const CellDilatation &cells, const WallConstraints &walls) {
    for (Index g = 0; g < walls.cell.size(); g++)
        cells.swelling(walls.cell(g)) += dilatation_of_hold(all.pose, all.rest, walls, g);
    NoFacetMarks none;
    accumulate(0, facets.i.size(), all.pose.data, facets, cells, none);
}

}  // namespace

// Sets the stresses of all cells in any poses, and adds force and torque of facets and walls to the sums.
Index load_body(Index, const CellPoses &all, const ElasticFacets &facets, const CellDilatation &cells,
                const DilatationGradients &gradients, const WallConstraints &walls, const BeamSums &to) {
    const Index n = all.pose.size();
    dilate(all, facets, cells, walls);
    for (Index p = 0; p < n; p++) stress_cell(all.pose, cells, p);
    const auto stress = [&](Index q) { return all.pose(q, stress_column); };
    for (Index p = 0; p < n; p++) gradients.difference(p) = difference_of(gradients, p, stress);
    for (Index p = 0; p < n; p++) all.pose(p, stress_column) += cells.weight(p) * gradients.difference(p);
    if (has_layers(gradients)) {
        for (Index p = 0; p < n; p++) bend_cell(all.pose, walls, gradients, p);
        for (Index p = 0; p < n; p++) {
            twist_cell(all.pose, walls, gradients, p);
            for (Index axis = 0; axis < 3; axis++) to.sums(p, 4 + axis) += gradients.torque(p, axis);
        }
    }
    add_loads_of_facets(0, facets.i.size(), all.pose.data, facets, to.row_i.data, to.row_j.data, to.sums.data);
    for (Index g = 0; g < walls.cell.size(); g++) {
        load_hold(all.pose, all.rest, walls, g);
        for (Index axis = 0; axis < 3; axis++) {
            to.sums(walls.cell(g), axis) += walls.load(g, axis);
            to.sums(walls.cell(g), 4 + axis) += walls.load(g, 3 + axis);
        }
    }
    return 0;
}
BONDEM_CALL(load_body, "")

// Adds force and torque of all facets at the stresses in the poses; rows of the sums are given.
Index load_facets(Index, const Poses &all, const ElasticFacets &facets, const BeamSums &to) {
    add_loads_of_facets(0, facets.i.size(), all.pose.data, facets, to.row_i.data, to.row_j.data, to.sums.data);
    return 0;
}
BONDEM_CALL(load_facets, "")

// Sums the energies of all facets, cells and walls [J]; that of dilatation is part of the normal energy.
Index measure_cell_energies(Index, const CellPoses &all, const ElasticFacets &facets, const CellDilatation &cells,
                            const DilatationGradients &gradients, const WallConstraints &walls,
                            const CellEnergies &found) {
    dilate(all, facets, cells, walls);
    ModeSums sum = {};
    sum_energies(0, facets.i.size(), all.pose.data, facets, sum);
    ExactSum &normal = sum.mode[0];
    for (Index p = 0; p < all.pose.size(); p++) normal.add(energy_of_gradients(all.pose, cells, walls, gradients, p));
    for (Index g = 0; g < walls.cell.size(); g++) normal.add(energy_of_hold(all.pose, all.rest, walls, g));
    for (Index p = 0; p < all.pose.size(); p++) normal.add(take_dilatation_energy(cells, p));
    sum.put(found.energy.data);
    return 0;
}
BONDEM_CALL(measure_cell_energies, "")

// Brings walls to a time.
Index place_walls(Index, const WallConstraints &walls, const WallTime &at) {
    for (Index g = 0; g < walls.cell.size(); g++) place_hold(walls, at.time, g);
    return 0;
}
BONDEM_CALL(place_walls, "")

}  // namespace bondem
