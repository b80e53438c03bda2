#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"

namespace bondem {

// Sums the differences between the stresses of each cell and those of its neighbours.
void sum_stress_differences(const Turn &turn, const Moving &all, const DilatationGradients &gradients);
// Adds the forces of the springs between cells to their stresses.
void add_stress_differences(const Turn &turn, const Moving &all, const CellDilatation &cells,
                            const DilatationGradients &gradients);
// Computes how layers one cell thick are bent at each cell.
void bend_layers(const Turn &turn, const Moving &all, const WallConstraints &walls,
                 const DilatationGradients &gradients);
// Computes the torques of bent layers on each cell.
void twist_layers(const Turn &turn, const Moving &all, const WallConstraints &walls,
                 const DilatationGradients &gradients);
// Adds the torques of bent layers to the sums of the cells.
void add_layer_torques(const Turn &turn, const DilatationGradients &gradients, const StepCut &cut);
// Sums the energies of gradients in portions of cells, for the dilatation that facets have added up.
void sum_gradient_energies(const Turn &turn, const Moving &all, const CellDilatation &cells,
                           const WallConstraints &walls, const DilatationGradients &gradients);
// Adds the energies of gradients to those of the facets.
void add_gradient_energies(const Turn &turn, const DilatationGradients &gradients, const Portions &portions);

}  // namespace bondem
