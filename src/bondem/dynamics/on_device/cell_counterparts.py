"""Bodies of cells on a device: dilatation, facets, walls that hold facets, tractions."""

import numpy as np

from bondem._device import IndexPass, Launch
from bondem._tables.cell_tables import (
    CellDilatation,
    CellStrains,
    CorrectedMass,
    DilatationEnergy,
    DilatationGradients,
    ElasticFacets,
    FacetTractions,
    WallConstraints,
)
from bondem._tables.device_tables import BondsOfElements, DeviceSpan, LoadsOfBonds, RowOrder, WallEnergy
from bondem._tables.step_tables import Beams, Moving, Portions, Rows, StepCut, Timeline
from bondem.dynamics.on_device.device_tables import WORKS
from bondem.dynamics.on_device.translation import Counterpart, Translation, elements, over

_dilate_facet = IndexPass("dilate_facet", Moving, ElasticFacets, LoadsOfBonds)
_gather_dilatation = IndexPass("gather_dilatation", CellDilatation, BondsOfElements, LoadsOfBonds)
_set_stress = IndexPass("set_stress", Moving, CellDilatation)
_sum_difference = IndexPass("sum_stress_difference", Moving, DilatationGradients)
_add_difference = IndexPass("add_stress_difference", Moving, CellDilatation, DilatationGradients)
_bend_layer = IndexPass("bend_layer", Moving, WallConstraints, DilatationGradients)
_twist_layer = IndexPass("twist_layer", Moving, WallConstraints, DilatationGradients)
_add_layer_torque = IndexPass("add_layer_torque", DilatationGradients, StepCut)
_sum_portion_of_gradients = IndexPass(
    "sum_portion_of_gradients", DeviceSpan, Moving, CellDilatation, WallConstraints, DilatationGradients
)  # fmt: skip
_add_gradient_energy = IndexPass("add_gradient_energy", DilatationGradients, Portions)
_OF_CELLS = Moving, ElasticFacets, WallConstraints, CorrectedMass
_find_acceleration = IndexPass("find_acceleration_of", Moving, Rows, StepCut, CorrectedMass)
_find_inertia = IndexPass("find_dilatation_inertia_of", *_OF_CELLS)
_find_inertia_force = IndexPass("find_inertia_force_of", *_OF_CELLS)
_add_inertia_force = IndexPass("add_inertia_force_of", CorrectedMass, StepCut)
_subtract_portion = IndexPass("subtract_portion_of_dilatation", DeviceSpan, *_OF_CELLS, Portions)
_load_facet = IndexPass("load_facet", Moving, ElasticFacets, LoadsOfBonds)
_place_wall = IndexPass("place_wall", DeviceSpan, WallConstraints)
_begin_walls_of_row = IndexPass("begin_walls_of_row", DeviceSpan, Moving, WallConstraints, RowOrder, Rows)
_dilate_walls_of_row = IndexPass("dilate_walls_of_row", Moving, WallConstraints, RowOrder, CellDilatation)
_apply_walls_of_row = IndexPass("apply_walls_of_row", Moving, WallConstraints, RowOrder, Rows)
_add_wall_load = IndexPass("add_wall_load", Rows, StepCut)
_follow_traction = IndexPass("follow_traction", DeviceSpan, Timeline, FacetTractions)
_give_dilatation = IndexPass("give_dilatation", DeviceSpan, FacetTractions, CellDilatation)
_add_traction_work_of_row = IndexPass("add_traction_work_of_row", Moving, StepCut, FacetTractions, Rows)
_check_portion = IndexPass("check_portion_of_facets", DeviceSpan, Moving, Beams, ElasticFacets, Portions)
_sum_portion_of_facets = IndexPass("sum_portion_of_facets", DeviceSpan, Moving, ElasticFacets, Portions)
_sum_portion_of_cells = IndexPass("sum_portion_of_cells", DeviceSpan, CellDilatation, DilatationEnergy)
_sum_portion_of_walls = IndexPass("sum_portion_of_walls", Moving, WallConstraints, WallEnergy)
_add_energies = IndexPass("add_energies", DilatationEnergy, WallEnergy, Portions)


_follow_factors = IndexPass("follow_cell_factors", DeviceSpan, Timeline, CellStrains)
_stretch_facet = IndexPass("stretch_facet_of_step", CellStrains, ElasticFacets)
_stretch_wall = IndexPass("stretch_wall_of_step", CellStrains, WallConstraints)
_sum_strain_portion = IndexPass("sum_strain_portion", DeviceSpan, Moving, CellStrains, ElasticFacets)
_begin_cell_strains = IndexPass("begin_cell_strains", DeviceSpan, Moving, CellStrains, WallConstraints)
_add_work = IndexPass("add_work_of_cell_strains", DeviceSpan, Moving, CellStrains, WallConstraints, Rows)


# ---- dilatation and forces


def _dilate(run: Translation, moving: Moving, facets: ElasticFacets, _: CellDilatation) -> list[Launch]:
    return [(_dilate_facet, run.span.m, (moving, facets, run.loads))]


def _gather(run: Translation, _: StepCut, cells: CellDilatation) -> list[Launch]:
    return [(_gather_dilatation, run.span.n, (cells, run.bonds, run.loads))]


def _stress(run: Translation, moving: Moving, cells: CellDilatation) -> list[Launch]:
    return [(_set_stress, run.span.n, (moving, cells))]


def _load(run: Translation, moving: Moving, facets: ElasticFacets, _: StepCut) -> list[Launch]:
    return [(_load_facet, run.span.m, (moving, facets, run.loads))]


def _gradient_energies(
    run: Translation, moving: Moving, cells: CellDilatation, walls: WallConstraints, gradients: DilatationGradients
) -> list[Launch]:
    return [(_sum_portion_of_gradients, len(gradients.energy), (run.span, moving, cells, walls, gradients))]


def _subtract_energies(
    run: Translation, moving: Moving, facets: ElasticFacets, walls: WallConstraints, mass: CorrectedMass,
    portions: Portions,
) -> list[Launch]:  # fmt: skip
    return [(_subtract_portion, len(portions.elements), (run.span, moving, facets, walls, mass, portions))]


# ---- walls and tractions


def _follow_walls(run: Translation, moving: Moving, walls: WallConstraints, rows: Rows) -> list[Launch]:
    tables = run.span, moving, walls, run.order_of(walls.row), rows
    return [(_place_wall, len(walls.cell), (run.span, walls)), (_begin_walls_of_row, len(rows.force), tables)]


def _dilate_walls(run: Translation, moving: Moving, walls: WallConstraints, cells: CellDilatation) -> list[Launch]:
    order = run.order_of(walls.row)
    return [(_dilate_walls_of_row, len(order.start) - 1, (moving, walls, order, cells))]


def _apply_walls(run: Translation, moving: Moving, walls: WallConstraints, rows: Rows) -> list[Launch]:
    return [(_apply_walls_of_row, len(rows.force), (moving, walls, run.order_of(walls.row), rows))]


def _add_wall_loads(run: Translation, rows: Rows, cut: StepCut) -> list[Launch]:
    return [(_add_wall_load, run.held, (rows, cut))]


def _follow_tractions(
    run: Translation, timeline: Timeline, tractions: FacetTractions, cells: CellDilatation
) -> list[Launch]:
    return [
        (_follow_traction, len(tractions.schedule), (run.span, timeline, tractions)),
        (_give_dilatation, run.span.n, (run.span, tractions, cells)),
    ]


def _add_traction_work(run: Translation, moving: Moving, tractions: FacetTractions, rows: Rows) -> list[Launch]:
    return [(_add_traction_work_of_row, run.held, (moving, run.cut, tractions, rows))]


# ---- strains that change


def _follow_strains(
    run: Translation, timeline: Timeline, strains: CellStrains, facets: ElasticFacets, walls: WallConstraints
) -> list[Launch]:
    return [
        (_follow_factors, 1, (run.span, timeline, strains)),
        (_stretch_facet, run.span.m, (strains, facets)),
        (_stretch_wall, len(strains.wall_still), (strains, walls)),
    ]


def _powers(run: Translation, moving: Moving, strains: CellStrains, facets: ElasticFacets) -> list[Launch]:
    return [(_sum_strain_portion, len(strains.power), (run.span, moving, strains, facets))]


def _begin_strains(
    run: Translation, moving: Moving, strains: CellStrains, facets: ElasticFacets, walls: WallConstraints
) -> list[Launch]:
    return [*_powers(run, moving, strains, facets), (_begin_cell_strains, 1, (run.span, moving, strains, walls))]


def _add_strain_work(
    run: Translation, moving: Moving, strains: CellStrains, walls: WallConstraints, rows: Rows
) -> list[Launch]:
    return [(_add_work, 1, (run.span, moving, strains, walls, rows))]


# ---- guard and record


def _check(run: Translation, moving: Moving, beams: Beams, facets: ElasticFacets, portions: Portions) -> list[Launch]:
    return [(_check_portion, len(portions.turned), (run.span, moving, beams, facets, portions))]


def _facet_energies(run: Translation, moving: Moving, facets: ElasticFacets, portions: Portions) -> list[Launch]:
    return [(_sum_portion_of_facets, len(portions.bonds), (run.span, moving, facets, portions))]


def _cell_energies(run: Translation, cells: CellDilatation, found: DilatationEnergy) -> list[Launch]:
    return [(_sum_portion_of_cells, len(found.energy), (run.span, cells, found))]


def energy_of_walls(run: Translation, moving: Moving, walls: WallConstraints) -> tuple[WallEnergy, list[Launch]]:
    """Return the energy of portions of walls, and the launches that find it."""
    held = run.once(walls, lambda: WallEnergy(np.zeros(-(-len(walls.cell) // WORKS))))
    return held, [(_sum_portion_of_walls, len(held.energy), (moving, walls, held))]


def _add_cell_energies(
    run: Translation, moving: Moving, walls: WallConstraints, found: DilatationEnergy, portions: Portions
) -> list[Launch]:
    held, launches = energy_of_walls(run, moving, walls)
    return [*launches, (_add_energies, 1, (found, held, portions))]


COUNTERPARTS: dict[str, Counterpart] = {
    "accumulate_dilatation": _dilate,
    "accumulate_left_dilatation": _dilate,
    "collect_dilatation": _gather,
    "stress_cells": _stress,
    "sum_stress_differences": over(_sum_difference, elements, spans=False),
    "add_stress_differences": over(_add_difference, elements, spans=False),
    "bend_layers": over(_bend_layer, elements, spans=False),
    "twist_layers": over(_twist_layer, elements, spans=False),
    "add_layer_torques": over(_add_layer_torque, elements, spans=False),
    "find_accelerations": over(_find_acceleration, elements, spans=False),
    "find_dilatation_inertia": over(_find_inertia, elements, spans=False),
    "find_inertia_forces": over(_find_inertia_force, elements, spans=False),
    "add_inertia_forces": over(_add_inertia_force, elements, spans=False),
    "subtract_dilatation_energies": _subtract_energies,
    "sum_gradient_energies": _gradient_energies,
    "add_gradient_energies": over(_add_gradient_energy, lambda _: 1, spans=False),
    "add_facet_loads": _load,
    "follow_walls": _follow_walls,
    "add_wall_dilatation": _dilate_walls,
    "apply_walls": _apply_walls,
    "add_wall_loads": _add_wall_loads,
    "follow_tractions": _follow_tractions,
    "add_traction_work": _add_traction_work,
    "follow_cell_strains": _follow_strains,
    "begin_strain_work": _begin_strains,
    "sum_strain_powers": _powers,
    "add_strain_work": _add_strain_work,
    "check_facets": _check,
    "sum_facet_energies": _facet_energies,
    "sum_dilatation_energies": _cell_energies,
    "add_cell_energies": _add_cell_energies,
}
