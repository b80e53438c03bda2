"""Passes that steps are composed of, of `core/passes/cells/dilatation_gradients.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.cell_tables import CellDilatation, DilatationGradients, WallConstraints
from bondem._tables.step_tables import Ledger, Moving, StepBlocks


def add_layer_torques(dilatation_gradients: DilatationGradients, step_blocks: StepBlocks) -> StepEntry:
    """Adds the torques of bent layers to the sums of the cells.

    Over elements of a block, then shared ones. Reads `torque` of an element; changes `sums` of an element.
    """
    return StepEntry("add_layer_torques", (dilatation_gradients, step_blocks))


def add_stress_differences(
    moving: Moving, cell_dilatation: CellDilatation, dilatation_gradients: DilatationGradients
) -> StepEntry:
    """Adds the stresses of the springs between neighbouring cells to the stresses of the cells.

    Over elements, in portions. Reads `CellDilatation.weight`, `difference` of an element; changes `pose.stress`
    of an element.
    """
    return StepEntry("add_stress_differences", (moving, cell_dilatation, dilatation_gradients))


def bend_layers(
    moving: Moving, wall_constraints: WallConstraints, dilatation_gradients: DilatationGradients
) -> StepEntry:
    """Computes how layers one cell thick are bent at each cell.

    Over elements, in portions. Reads `base` of an element; reads `pose` at both ends; adds `bend` to elements.
    """
    return StepEntry("bend_layers", (moving, wall_constraints, dilatation_gradients))


def sum_gradient_energies(
    moving: Moving, cell_dilatation: CellDilatation, wall_constraints: WallConstraints, dilatation_gradients:
    DilatationGradients, ledger: Ledger
) -> StepEntry:
    """Sums the energies of gradients in a portion of cells, for the dilatation that facets have added up.

    Over elements, in portions. Reads `pose` at both ends; adds `bend` to elements.
    """
    return StepEntry("sum_gradient_energies", (
        moving, cell_dilatation, wall_constraints, dilatation_gradients, ledger
    ))


def sum_stress_differences(moving: Moving, dilatation_gradients: DilatationGradients) -> StepEntry:
    """Sums the differences between the stresses of each cell and those of its neighbours.

    Over elements, in portions. Reads `pose.stress` at both ends; adds `difference` to elements.
    """
    return StepEntry("sum_stress_differences", (moving, dilatation_gradients))


def twist_layers(
    moving: Moving, wall_constraints: WallConstraints, dilatation_gradients: DilatationGradients
) -> StepEntry:
    """Computes the torques of bent layers on each cell.

    Over elements, in portions. Reads `base` of an element; reads `bend`, `pose` at both ends; adds `torque` to
    elements.
    """
    return StepEntry("twist_layers", (moving, wall_constraints, dilatation_gradients))
