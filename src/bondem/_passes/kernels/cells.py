"""Passes over an index, for devices, of `core/gpu/cells.hpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Kernel
from bondem._tables.cell_tables import (
    CellDilatation,
    CorrectedMass,
    DilatationGradients,
    ElasticFacets,
    FacetTractions,
    WallConstraints,
)
from bondem._tables.device_tables import BondsOfElements, DeviceSpan, LoadsOfBonds, RowOrder
from bondem._tables.step_tables import Ledger, Moving, Rows, StepBlocks, Timeline


def add_energy_of_support(moving: Moving, wall_constraints: WallConstraints, ledger: Ledger) -> Kernel:
    """Sums the energies of half facets at walls.

    Over one index.
    """
    return Kernel("add_energy_of_support", (moving, wall_constraints, ledger))


def add_inertia_force_of(corrected_mass: CorrectedMass, step_blocks: StepBlocks) -> Kernel:
    """Adds the forces of the correction to the sums of the elements.

    Over one index.
    """
    return Kernel("add_inertia_force_of", (corrected_mass, step_blocks))


def add_layer_torque(dilatation_gradients: DilatationGradients, step_blocks: StepBlocks) -> Kernel:
    """Adds the torques of bent layers to the sums of the cells.

    Over one index.
    """
    return Kernel("add_layer_torque", (dilatation_gradients, step_blocks))


def add_stress_difference(
    moving: Moving, cell_dilatation: CellDilatation, dilatation_gradients: DilatationGradients
) -> Kernel:
    """Adds the stresses of the springs between neighbouring cells to the stresses of the cells.

    Over one index.
    """
    return Kernel("add_stress_difference", (moving, cell_dilatation, dilatation_gradients))


def add_traction_work_of_row(
    moving: Moving, step_blocks: StepBlocks, facet_tractions: FacetTractions, rows: Rows
) -> Kernel:
    """Adds the work of tractions of cell number h of those that own rows of the boundary."""
    return Kernel("add_traction_work_of_row", (moving, step_blocks, facet_tractions, rows))


def add_wall_load(rows: Rows, step_blocks: StepBlocks) -> Kernel:
    """Adds the loads of walls to the sums of element number h of those that own rows of the boundary."""
    return Kernel("add_wall_load", (rows, step_blocks))


def apply_walls_of_row(moving: Moving, wall_constraints: WallConstraints, row_order: RowOrder, rows: Rows) -> Kernel:
    """Sets the forces of walls on the rows of their cells, whose stresses are known, and adds the work of walls
    that move: the trapezoid of the force over the displacement.

    Over one index.
    """
    return Kernel("apply_walls_of_row", (moving, wall_constraints, row_order, rows))


def begin_walls_of_row(
    device_span: DeviceSpan, moving: Moving, wall_constraints: WallConstraints, row_order: RowOrder, rows: Rows
) -> Kernel:
    """Computes the forces and torques of the walls of row r before the first step of a call."""
    return Kernel("begin_walls_of_row", (device_span, moving, wall_constraints, row_order, rows))


def bend_layer(
    moving: Moving, wall_constraints: WallConstraints, dilatation_gradients: DilatationGradients
) -> Kernel:
    """Computes how layers one cell thick are bent at each cell.

    Over one index.
    """
    return Kernel("bend_layer", (moving, wall_constraints, dilatation_gradients))


def check_portion_of_facets(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, ledger: Ledger
) -> Kernel:
    """Counts unbroken facets of a portion beyond safe angles (c1 or c2 < 0.7, w² < 0.75) and valid ones (0, 0.25);
    c, w as in `laws/beam.hpp`.

    Over one index.
    """
    return Kernel("check_portion_of_facets", (device_span, moving, elastic_facets, ledger))


def dilate_facet(moving: Moving, elastic_facets: ElasticFacets, loads_of_bonds: LoadsOfBonds) -> Kernel:
    """Pass of one index, defined in `core/gpu/cells.hpp`."""
    return Kernel("dilate_facet", (moving, elastic_facets, loads_of_bonds))


def dilate_walls_of_row(
    moving: Moving, wall_constraints: WallConstraints, row_order: RowOrder, cell_dilatation: CellDilatation
) -> Kernel:
    """Adds contributions of walls to V θ of their cells.

    Over one index.
    """
    return Kernel("dilate_walls_of_row", (moving, wall_constraints, row_order, cell_dilatation))


def find_acceleration_of(
    moving: Moving, rows: Rows, step_blocks: StepBlocks, corrected_mass: CorrectedMass
) -> Kernel:
    """Computes the accelerations of the elements by their loads alone.

    Over one index.
    """
    return Kernel("find_acceleration_of", (moving, rows, step_blocks, corrected_mass))


def find_dilatation_inertia_of(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, corrected_mass:
    CorrectedMass
) -> Kernel:
    """Computes ρ β θ̈ of the cells by the accelerations of the elements.

    Over one index.
    """
    return Kernel("find_dilatation_inertia_of", (moving, elastic_facets, wall_constraints, corrected_mass))


def find_inertia_force_of(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, corrected_mass:
    CorrectedMass
) -> Kernel:
    """Computes the forces of the correction on the elements.

    Over one index.
    """
    return Kernel("find_inertia_force_of", (moving, elastic_facets, wall_constraints, corrected_mass))


def follow_traction(device_span: DeviceSpan, timeline: Timeline, facet_tractions: FacetTractions) -> Kernel:
    """Launched for `follow_tractions`: sets the factors of tractions at the time of the clock, and their
    contributions to V θ of cells.

    Over one index.
    """
    return Kernel("follow_traction", (device_span, timeline, facet_tractions))


def gather_dilatation(
    cell_dilatation: CellDilatation, bonds_of_elements: BondsOfElements, loads_of_bonds: LoadsOfBonds
) -> Kernel:
    """Adds contributions of facets of other domains to V θ of shared cells, and sets their rows to zero.

    Over one index.
    """
    return Kernel("gather_dilatation", (cell_dilatation, bonds_of_elements, loads_of_bonds))


def give_dilatation(
    device_span: DeviceSpan, facet_tractions: FacetTractions, cell_dilatation: CellDilatation
) -> Kernel:
    """Launched for `follow_tractions`: sets the factors of tractions at the time of the clock, and their
    contributions to V θ of cells.

    Over one index.
    """
    return Kernel("give_dilatation", (device_span, facet_tractions, cell_dilatation))


def load_facet(moving: Moving, elastic_facets: ElasticFacets, loads_of_bonds: LoadsOfBonds) -> Kernel:
    """Adds forces and torques of the facets of a block to the sums of their cells, whose stresses are known.

    Over one index.
    """
    return Kernel("load_facet", (moving, elastic_facets, loads_of_bonds))


def place_wall(device_span: DeviceSpan, wall_constraints: WallConstraints) -> Kernel:
    """Launched for `follow_walls`: moves walls to their places at the time of the clock, and updates their forces
    before the first step of a call.

    Over one index.
    """
    return Kernel("place_wall", (device_span, wall_constraints))


def set_stress(moving: Moving, cell_dilatation: CellDilatation) -> Kernel:
    """Sets the stresses of cells by their complete V θ, which is set to zero.

    Over one index.
    """
    return Kernel("set_stress", (moving, cell_dilatation))


def subtract_portion_of_dilatation(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints,
    corrected_mass: CorrectedMass, ledger: Ledger
) -> Kernel:
    """Subtracts the correction of the mass from the kinetic energies of a portion of cells.

    Over one index.
    """
    return Kernel("subtract_portion_of_dilatation", (
        device_span, moving, elastic_facets, wall_constraints, corrected_mass, ledger
    ))


def sum_portion_of_cells(device_span: DeviceSpan, cell_dilatation: CellDilatation, ledger: Ledger) -> Kernel:
    """Sums the energy of dilatation of a portion of cells, whose V θ is complete and is set to zero [J].

    Over one index.
    """
    return Kernel("sum_portion_of_cells", (device_span, cell_dilatation, ledger))


def sum_portion_of_facets(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, ledger: Ledger
) -> Kernel:
    """Sums normal, shear, bending and twisting energy of the facets of a portion, without dilatation [J].

    Over one index.
    """
    return Kernel("sum_portion_of_facets", (device_span, moving, elastic_facets, ledger))


def sum_portion_of_gradients(
    device_span: DeviceSpan, moving: Moving, cell_dilatation: CellDilatation, wall_constraints: WallConstraints,
    dilatation_gradients: DilatationGradients, ledger: Ledger
) -> Kernel:
    """Sums the energies of gradients in a portion of cells, for the dilatation that facets have added up.

    Over one index.
    """
    return Kernel("sum_portion_of_gradients", (
        device_span, moving, cell_dilatation, wall_constraints, dilatation_gradients, ledger
    ))


def sum_stress_difference(moving: Moving, dilatation_gradients: DilatationGradients) -> Kernel:
    """Sums the differences between the stresses of each cell and those of its neighbours.

    Over one index.
    """
    return Kernel("sum_stress_difference", (moving, dilatation_gradients))


def twist_layer(
    moving: Moving, wall_constraints: WallConstraints, dilatation_gradients: DilatationGradients
) -> Kernel:
    """Computes the torques of bent layers on each cell.

    Over one index.
    """
    return Kernel("twist_layer", (moving, wall_constraints, dilatation_gradients))
