"""Counterparts on a device of the passes of cells: dilatation, facets, walls that hold facets, tractions."""

from bondem._passes import kernels
from bondem._tables.cell_tables import CellStrains, FacetTractions, WallConstraints
from bondem._tables.step_tables import Rows
from bondem.dynamics.on_device.translation import (
    Counterpart,
    Given,
    Translation,
    bonds,
    elements,
    in_order,
    length_of,
    one_thread,
    ordered,
    over,
    owners,
    portions_of_bonds,
    portions_of_elements,
)

#: The order of walls that hold facets, by the rows of the boundary on which they act.
BY_ROW_OF_WALLS = ordered(WallConstraints, lambda walls: walls.row)
_ROWS = length_of(Rows, lambda rows: rows.force)
_WALLS = length_of(WallConstraints, lambda walls: walls.cell)


def _rows_with_walls(run: Translation, given: Given) -> int:
    return len(run.order_of(given[WallConstraints].row).start) - 1


COUNTERPARTS: dict[str, Counterpart] = {
    "accumulate_dilatation": over(kernels.dilate_facet, bonds),
    "accumulate_left_dilatation": over(kernels.dilate_facet, bonds),
    "collect_dilatation": over(kernels.gather_dilatation, elements),
    "stress_cells": over(kernels.set_stress, elements),
    "sum_stress_differences": over(kernels.sum_stress_difference, elements),
    "add_stress_differences": over(kernels.add_stress_difference, elements),
    "bend_layers": over(kernels.bend_layer, elements),
    "twist_layers": over(kernels.twist_layer, elements),
    "add_layer_torques": over(kernels.add_layer_torque, elements),
    "find_accelerations": over(kernels.find_acceleration_of, elements),
    "find_dilatation_inertia": over(kernels.find_dilatation_inertia_of, elements),
    "find_inertia_forces": over(kernels.find_inertia_force_of, elements),
    "add_inertia_forces": over(kernels.add_inertia_force_of, elements),
    "subtract_dilatation_energies": over(kernels.subtract_portion_of_dilatation, portions_of_elements),
    "sum_gradient_energies": over(kernels.sum_portion_of_gradients, portions_of_elements),
    "add_facet_loads": over(kernels.load_facet, bonds),
    "follow_walls": in_order(
        over(kernels.place_wall, _WALLS),
        over(kernels.begin_walls_of_row, _ROWS, BY_ROW_OF_WALLS),
    ),
    "add_wall_dilatation": over(kernels.dilate_walls_of_row, _rows_with_walls, BY_ROW_OF_WALLS),
    "apply_walls": over(kernels.apply_walls_of_row, _ROWS, BY_ROW_OF_WALLS),
    "add_wall_loads": over(kernels.add_wall_load, owners),
    "follow_tractions": in_order(
        over(kernels.follow_traction, length_of(FacetTractions, lambda of: of.schedule)),
        over(kernels.give_dilatation, elements),
    ),
    "add_traction_work": over(kernels.add_traction_work_of_row, owners),
    "follow_cell_strains": in_order(
        over(kernels.follow_cell_factors, one_thread),
        over(kernels.stretch_facet_of_step, bonds),
        over(kernels.stretch_wall_of_step, length_of(CellStrains, lambda of: of.wall_still)),
    ),
    "begin_strain_work": in_order(
        over(kernels.begin_strain_portion, portions_of_bonds), over(kernels.begin_cell_strains, one_thread)
    ),
    "sum_strain_powers": over(kernels.sum_strain_portion, portions_of_bonds),
    "add_strain_work": over(kernels.add_work_of_cell_strains, one_thread),
    "check_facets": over(kernels.check_portion_of_facets, portions_of_bonds),
    "sum_facet_energies": over(kernels.sum_portion_of_facets, portions_of_bonds),
    "sum_dilatation_energies": over(kernels.sum_portion_of_cells, portions_of_elements),
    "sum_energies_of_supports": over(kernels.add_energy_of_support, _WALLS),
}
