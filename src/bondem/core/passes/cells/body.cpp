// Functions of a body of cells in given poses: forces, stiffness, energies, and displacements of walls.
#include "../../registered.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/step_tables.hpp"
#include "../assembly/derivatives.hpp"
#include "accumulation.hpp"
#include "energies.hpp"
#include "gradients.hpp"
#include "walls.hpp"

namespace bondem {
namespace {

template <class Pose>
void dilate(const Pose &pose, const Array<const double, 2> &rest, const ElasticFacets &facets, const CellDilatation &cells,
            const WallConstraints &walls) {
    for (Index g = 0; g < walls.cell.size(); g++)
        cells.swelling(walls.cell(g)) += dilatation_of_support(pose, rest, walls, g);
    NoFacetMarks none;
    accumulate(0, facets.i.size(), pose, facets, cells, none);
}

// Sets the stresses of all cells in rows of `to_cells`, and adds force and torque of facets and walls to the sums;
// for a pose of duals, the changes of both.
template <class Pose>
void load(const Pose &pose, const Array<double, 2> &to_cells, const Array<const double, 2> &rest,
          const ElasticFacets &facets, const CellDilatation &cells, const DilatationGradients &gradients,
          const WallConstraints &walls, const BeamSums &to) {
    const Index n = rest.size();
    dilate(pose, rest, facets, cells, walls);
    for (Index p = 0; p < n; p++) stress_cell(to_cells, cells, p);
    const auto stress = [&](Index q) { return to_cells(q, stress_column); };
    for (Index p = 0; p < n; p++) gradients.difference(p) = difference_of(gradients, p, stress);
    for (Index p = 0; p < n; p++) to_cells(p, stress_column) += cells.weight(p) * gradients.difference(p);
    if (has_layers(gradients)) {
        for (Index p = 0; p < n; p++) bend_cell(pose, walls, gradients, p);
        for (Index p = 0; p < n; p++) {
            twist_cell(pose, walls, gradients, p);
            for (Index axis = 0; axis < 3; axis++) to.sums(p, 4 + axis) += gradients.torque(p, axis);
        }
    }
    add_loads_of_facets(0, facets.i.size(), pose, facets, to.row_i.data, to.row_j.data, to.sums.data);
    for (Index g = 0; g < walls.cell.size(); g++) {
        load_support(pose, rest, walls, g);
        for (Index axis = 0; axis < 3; axis++) {
            to.sums(walls.cell(g), axis) += walls.load(g, axis);
            to.sums(walls.cell(g), 4 + axis) += walls.load(g, 3 + axis);
        }
    }
}

}  // namespace

// Sets the stresses of all cells in given poses, and adds force and torque of facets and walls to the sums.
Index load_body(Index, const CellPoses &all, const ElasticFacets &facets, const CellDilatation &cells,
                const DilatationGradients &gradients, const WallConstraints &walls, const BeamSums &to) {
    load(all.pose.data, all.pose, all.rest, facets, cells, gradients, walls, to);
    return 0;
}
BONDEM_CALL(load_body, "")

// Multiplies small motions by the stiffness of a body. Stresses and bending are those that `load_body` left;
// tractions add nothing to V θ.
Index multiply_body(Index, const CellPoses &all, const StiffnessProduct &by, const ElasticFacets &facets,
                    const CellDilatation &cells, const DilatationGradients &gradients, const WallConstraints &walls) {
    const BeamSums to = {facets.i, facets.j, by.sums};
    multiply(all.pose.data, by, [&](const MovedPoses &moved) {
        load(moved, by.motion, all.rest, facets, cells, gradients, walls, to);
    });
    return 0;
}
BONDEM_CALL(multiply_body, "")

// Sets the second derivative of the energy of each facet by the motions of its cells, at the stresses in the poses.
Index differentiate_facets(Index, const Poses &all, const ElasticFacets &facets, const BondTangents &to) {
    using T = Dual<Lanes>;
    const FacetColumns columns(facets);
    differentiate(all.pose.data, facets, to, [&](Index k, const PairOfRows<T> &rows) __attribute__((always_inline)) {
        const T s = number<T>(columns.integrity, k);
        return facet_loads(ends_of(rows, columns.period), columns.shape<T>(k), columns.stiffness<T>(k, s),
                           stresses_of(rows.first, rows.second, s));
    });
    return 0;
}
BONDEM_CALL(differentiate_facets, "")

// Sums the energies of all facets, cells and walls [J]; that of dilatation is part of the normal energy.
Index measure_cell_energies(Index, const CellPoses &all, const ElasticFacets &facets, const CellDilatation &cells,
                            const DilatationGradients &gradients, const WallConstraints &walls,
                            const CellEnergies &found) {
    dilate(all.pose.data, all.rest, facets, cells, walls);
    ModeSums sum = {};
    sum_energies(0, facets.i.size(), all.pose.data, facets, sum);
    ExactSum &normal = sum.mode[0];
    for (Index p = 0; p < all.pose.size(); p++) normal.add(energy_of_gradients(all.pose, cells, walls, gradients, p));
    for (Index g = 0; g < walls.cell.size(); g++) normal.add(energy_of_support(all.pose, all.rest, walls, g));
    for (Index p = 0; p < all.pose.size(); p++) normal.add(take_dilatation_energy(cells, p));
    sum.put(found.energy.data);
    return 0;
}
BONDEM_CALL(measure_cell_energies, "")

// Moves all walls to their places at a time.
Index place_walls(Index, const WallConstraints &walls, const WallTime &at) {
    for (Index g = 0; g < walls.cell.size(); g++) place_support(walls, at.time, g);
    return 0;
}
BONDEM_CALL(place_walls, "")

}  // namespace bondem
