// Passes for gradients of the dilatation (`gradients.hpp`): springs between the stresses of neighbouring cells, and
// torques of bent layers one cell thick. These springs and torques are computed after the stresses of cells and
// before the loads of facets. The torques are added to the sums of cells after these loads.
#include "../../ledger.hpp"
#include "../../registered.hpp"
#include "cell_passes.hpp"
#include "gradients.hpp"

namespace bondem {

// Sums the differences between the stresses of each cell and those of its neighbours.
void sum_stress_differences(const Range &range, const Moving &all, const DilatationGradients &gradients) {
    const auto stress = [&](Index q) { return all.pose(q, stress_column); };
    for (Index p = range.first; p < range.last; p++) gradients.difference(p) = difference_of(gradients, p, stress);
}
BONDEM_PASS(sum_stress_differences, of_elements, "ends pose.stress; adds difference")

// Adds the stresses of the springs between neighbouring cells to the stresses of the cells.
void add_stress_differences(const Range &range, const Moving &all, const CellDilatation &cells,
                            const DilatationGradients &gradients) {
    for (Index p = range.first; p < range.last; p++)
        all.pose(p, stress_column) += cells.weight(p) * gradients.difference(p);
}
BONDEM_PASS(add_stress_differences, of_elements, "own CellDilatation.weight difference; changes pose.stress")

// Computes how layers one cell thick are bent at each cell.
void bend_layers(const Range &range, const Moving &all, const WallConstraints &walls,
                 const DilatationGradients &gradients) {
    for (Index p = range.first; p < range.last; p++) bend_cell(all.pose, walls, gradients, p);
}
BONDEM_PASS(bend_layers, of_elements, "own base; ends pose; adds bend")

// Computes the torques of bent layers on each cell.
void twist_layers(const Range &range, const Moving &all, const WallConstraints &walls,
                 const DilatationGradients &gradients) {
    for (Index p = range.first; p < range.last; p++) twist_cell(all.pose, walls, gradients, p);
}
BONDEM_PASS(twist_layers, of_elements, "own base; ends bend pose; adds torque")

// Adds the torques of bent layers to the sums of the cells.
void add_layer_torques(const Range &range, const DilatationGradients &gradients, const StepBlocks &blocks) {
    for (Index e = range.first; e < range.last; e++)
        for (Index axis = 0; axis < 3; axis++)
            blocks.sums(range.row[e], 4 + axis) += gradients.torque(range.element[e], axis);
}
BONDEM_PASS(add_layer_torques, elements_of_blocks, "own torque; changes sums")

void sum_gradient_energies(const Range &range, const Moving &all, const CellDilatation &cells,
                           const WallConstraints &walls, const DilatationGradients &gradients, const Ledger &ledger) {
    add_up(ledger, history_column::normal, range.first, range.last,
           [&](Index p) { return energy_of_gradients(all.pose, cells, walls, gradients, p); });
}
BONDEM_PASS(sum_gradient_energies, of_elements, "ends pose; adds bend")

}  // namespace bondem
