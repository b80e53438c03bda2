"""Bodies of cells on a device: dilatation, facets, walls that hold facets, tractions."""

import numpy as np

from bondem._device import Launch
from bondem._passes import kernels
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
from bondem._tables.columns import WORKS_OF_PORTION
from bondem._tables.device_tables import WallEnergy
from bondem._tables.step_tables import Beams, Moving, Portions, Rows, StepCut, Timeline
from bondem.dynamics.on_device.translation import Counterpart, Translation, elements, over

_OF_CELLS = Moving, ElasticFacets, WallConstraints, CorrectedMass




# ---- dilatation and forces


def _dilate(run: Translation, moving: Moving, facets: ElasticFacets, _: CellDilatation) -> list[Launch]:
    return [(kernels.dilate_facet(moving, facets, run.loads), run.span.m)]


def _gather(run: Translation, _: StepCut, cells: CellDilatation) -> list[Launch]:
    return [(kernels.gather_dilatation(cells, run.bonds, run.loads), run.span.n)]


def _stress(run: Translation, moving: Moving, cells: CellDilatation) -> list[Launch]:
    return [(kernels.set_stress(moving, cells), run.span.n)]


def _load(run: Translation, moving: Moving, facets: ElasticFacets, _: StepCut) -> list[Launch]:
    return [(kernels.load_facet(moving, facets, run.loads), run.span.m)]


def _gradient_energies(
    run: Translation, moving: Moving, cells: CellDilatation, walls: WallConstraints, gradients: DilatationGradients
) -> list[Launch]:
    return [(kernels.sum_portion_of_gradients(run.span, moving, cells, walls, gradients), len(gradients.energy))]


def _subtract_energies(
    run: Translation, moving: Moving, facets: ElasticFacets, walls: WallConstraints, mass: CorrectedMass,
    portions: Portions,
) -> list[Launch]:  # fmt: skip
    tables = run.span, moving, facets, walls, mass, portions
    return [(kernels.subtract_portion_of_dilatation(*tables), len(portions.elements))]


# ---- walls and tractions


def _follow_walls(run: Translation, moving: Moving, walls: WallConstraints, rows: Rows) -> list[Launch]:
    order = run.order_of(walls.row)
    return [
        (kernels.place_wall(run.span, walls), len(walls.cell)),
        (kernels.begin_walls_of_row(run.span, moving, walls, order, rows), len(rows.force)),
    ]


def _dilate_walls(run: Translation, moving: Moving, walls: WallConstraints, cells: CellDilatation) -> list[Launch]:
    order = run.order_of(walls.row)
    return [(kernels.dilate_walls_of_row(moving, walls, order, cells), len(order.start) - 1)]


def _apply_walls(run: Translation, moving: Moving, walls: WallConstraints, rows: Rows) -> list[Launch]:
    return [(kernels.apply_walls_of_row(moving, walls, run.order_of(walls.row), rows), len(rows.force))]


def _add_wall_loads(run: Translation, rows: Rows, cut: StepCut) -> list[Launch]:
    return [(kernels.add_wall_load(rows, cut), run.held)]


def _follow_tractions(
    run: Translation, timeline: Timeline, tractions: FacetTractions, cells: CellDilatation
) -> list[Launch]:
    return [
        (kernels.follow_traction(run.span, timeline, tractions), len(tractions.schedule)),
        (kernels.give_dilatation(run.span, tractions, cells), run.span.n),
    ]


def _add_traction_work(run: Translation, moving: Moving, tractions: FacetTractions, rows: Rows) -> list[Launch]:
    return [(kernels.add_traction_work_of_row(moving, run.cut, tractions, rows), run.held)]


# ---- strains that change


def _follow_strains(
    run: Translation, timeline: Timeline, strains: CellStrains, facets: ElasticFacets, walls: WallConstraints
) -> list[Launch]:
    return [
        (kernels.follow_cell_factors(run.span, timeline, strains), 1),
        (kernels.stretch_facet_of_step(strains, facets), run.span.m),
        (kernels.stretch_wall_of_step(strains, walls), len(strains.wall_still)),
    ]


def _powers(run: Translation, moving: Moving, strains: CellStrains, facets: ElasticFacets) -> list[Launch]:
    return [(kernels.sum_strain_portion(run.span, moving, strains, facets), len(strains.power))]


def _begin_strains(
    run: Translation, moving: Moving, strains: CellStrains, facets: ElasticFacets, walls: WallConstraints
) -> list[Launch]:
    return [*_powers(run, moving, strains, facets), (kernels.begin_cell_strains(run.span, moving, strains, walls), 1)]


def _add_strain_work(
    run: Translation, moving: Moving, strains: CellStrains, walls: WallConstraints, rows: Rows
) -> list[Launch]:
    return [(kernels.add_work_of_cell_strains(run.span, moving, strains, walls, rows), 1)]


# ---- guard and record


def _check(run: Translation, moving: Moving, beams: Beams, facets: ElasticFacets, portions: Portions) -> list[Launch]:
    return [(kernels.check_portion_of_facets(run.span, moving, beams, facets, portions), len(portions.turned))]


def _facet_energies(run: Translation, moving: Moving, facets: ElasticFacets, portions: Portions) -> list[Launch]:
    return [(kernels.sum_portion_of_facets(run.span, moving, facets, portions), len(portions.bonds))]


def _cell_energies(run: Translation, cells: CellDilatation, found: DilatationEnergy) -> list[Launch]:
    return [(kernels.sum_portion_of_cells(run.span, cells, found), len(found.energy))]


def energy_of_walls(run: Translation, moving: Moving, walls: WallConstraints) -> tuple[WallEnergy, list[Launch]]:
    """Return the energy of portions of walls, and the launches that find it."""
    held = run.once(walls, lambda: WallEnergy(np.zeros(-(-len(walls.cell) // WORKS_OF_PORTION))))
    return held, [(kernels.sum_portion_of_walls(moving, walls, held), len(held.energy))]


def _add_cell_energies(
    run: Translation, moving: Moving, walls: WallConstraints, found: DilatationEnergy, portions: Portions
) -> list[Launch]:
    held, launches = energy_of_walls(run, moving, walls)
    return [*launches, (kernels.add_energies(found, held, portions), 1)]


COUNTERPARTS: dict[str, Counterpart] = {
    "accumulate_dilatation": _dilate,
    "accumulate_left_dilatation": _dilate,
    "collect_dilatation": _gather,
    "stress_cells": _stress,
    "sum_stress_differences": over(kernels.sum_stress_difference, elements, spans=False),
    "add_stress_differences": over(kernels.add_stress_difference, elements, spans=False),
    "bend_layers": over(kernels.bend_layer, elements, spans=False),
    "twist_layers": over(kernels.twist_layer, elements, spans=False),
    "add_layer_torques": over(kernels.add_layer_torque, elements, spans=False),
    "find_accelerations": over(kernels.find_acceleration_of, elements, spans=False),
    "find_dilatation_inertia": over(kernels.find_dilatation_inertia_of, elements, spans=False),
    "find_inertia_forces": over(kernels.find_inertia_force_of, elements, spans=False),
    "add_inertia_forces": over(kernels.add_inertia_force_of, elements, spans=False),
    "subtract_dilatation_energies": _subtract_energies,
    "sum_gradient_energies": _gradient_energies,
    "add_gradient_energies": over(kernels.add_gradient_energy, lambda _: 1, spans=False),
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
