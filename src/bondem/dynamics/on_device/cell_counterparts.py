"""Kernel launches on a device for the passes of cells: dilatation, facets, walls that fix facets, tractions."""

from bondem._passes import kernels
from bondem._tables.cell_tables import CellStrains, FacetTractions, WallConstraints
from bondem.dynamics.on_device import counts
from bondem.dynamics.on_device.translation import Counterpart, Given, Translation, in_order, ordered, over

#: The order of walls that hold facets, by the rows of the boundary on which they act.
BY_ROW_OF_WALLS = ordered(WallConstraints, lambda walls: walls.row)


def _rows_with_walls(run: Translation, given: Given) -> int:
    return len(run.order_of(given[WallConstraints].row).start) - 1


COUNTERPARTS: dict[str, Counterpart] = {
    "accumulate_dilatation": over(kernels.dilate_facet, counts.bonds),
    "accumulate_left_dilatation": over(kernels.dilate_facet, counts.bonds),
    "collect_dilatation": over(kernels.gather_dilatation, counts.elements),
    "stress_cells": over(kernels.set_stress, counts.elements),
    "sum_stress_differences": over(kernels.sum_stress_difference, counts.elements),
    "add_stress_differences": over(kernels.add_stress_difference, counts.elements),
    "bend_layers": over(kernels.bend_layer, counts.elements),
    "twist_layers": over(kernels.twist_layer, counts.elements),
    "add_layer_torques": over(kernels.add_layer_torque, counts.elements),
    "find_accelerations": over(kernels.find_acceleration_of, counts.elements),
    "find_dilatation_inertia": over(kernels.find_dilatation_inertia_of, counts.elements),
    "find_inertia_forces": over(kernels.find_inertia_force_of, counts.elements),
    "add_inertia_forces": over(kernels.add_inertia_force_of, counts.elements),
    "subtract_dilatation_energies": over(kernels.subtract_portion_of_dilatation, counts.portions_of_elements),
    "sum_gradient_energies": over(kernels.sum_portion_of_gradients, counts.portions_of_elements),
    "add_facet_loads": over(kernels.load_facet, counts.bonds),
    "follow_walls": in_order(
        over(kernels.place_wall, counts.walls), over(kernels.begin_walls_of_row, counts.rows, BY_ROW_OF_WALLS)
    ),
    "add_wall_dilatation": over(kernels.dilate_walls_of_row, _rows_with_walls, BY_ROW_OF_WALLS),
    "apply_walls": over(kernels.apply_walls_of_row, counts.rows, BY_ROW_OF_WALLS),
    "add_wall_loads": over(kernels.add_wall_load, counts.owners),
    "follow_tractions": in_order(
        over(kernels.follow_traction, counts.length_of(FacetTractions, lambda of: of.schedule)),
        over(kernels.give_dilatation, counts.elements),
    ),
    "add_traction_work": over(kernels.add_traction_work_of_row, counts.owners),
    "follow_cell_strains": in_order(
        over(kernels.follow_cell_factors, counts.one_thread),
        over(kernels.stretch_facet_of_step, counts.bonds),
        over(kernels.stretch_wall_of_step, counts.length_of(CellStrains, lambda of: of.wall_still)),
    ),
    "begin_strain_work": in_order(
        over(kernels.begin_strain_portion, counts.portions_of_bonds),
        over(kernels.begin_cell_strains, counts.one_thread),
    ),
    "sum_strain_powers": over(kernels.sum_strain_portion, counts.portions_of_bonds),
    "add_strain_work": over(kernels.add_work_of_cell_strains, counts.one_thread),
    "check_facets": over(kernels.check_portion_of_facets, counts.portions_of_bonds),
    "sum_facet_energies": over(kernels.sum_portion_of_facets, counts.portions_of_bonds),
    "sum_dilatation_energies": over(kernels.sum_portion_of_cells, counts.portions_of_elements),
    "sum_energies_of_supports": over(kernels.add_energy_of_support, counts.walls),
}
