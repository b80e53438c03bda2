"""Stresses of cells, and facets that begin to crack, on a device; and energies of bodies with cracks."""

import numpy as np

from bondem._device import Launch
from bondem._passes import kernels
from bondem._tables.cell_tables import (
    CellDilatation,
    ElasticFacets,
    FacetForces,
    FacetTractions,
    WallConstraints,
)
from bondem._tables.columns import BONDS_OF_PORTION
from bondem._tables.crack_tables import CohesiveCracks, CrackEnergies, FacetStrengths, StressesOfCells
from bondem._tables.damage_tables import EventLog
from bondem._tables.device_tables import (
    CrackPortions,
    CrushingPortions,
    DeviceSpan,
    FacetArms,
    RowOrder,
)
from bondem._tables.step_tables import HistoryRows, Moving, Portions, StepCut
from bondem.dynamics.on_device.cell_counterparts import energy_of_walls
from bondem.dynamics.on_device.device_tables import new_row_order
from bondem.dynamics.on_device.translation import Counterpart, Translation, bonds, elements, over

_ON_SURFACE = DeviceSpan, Moving, WallConstraints, RowOrder, FacetTractions, StressesOfCells


# ---- forces and stresses


def _arms(run: Translation, kept: FacetForces) -> FacetArms:
    def make() -> FacetArms:
        made = FacetArms(np.zeros((7, run.span.m)))
        run.scratch += [made.arm, kept.sums]
        return made

    return run.once(kept, make)


def _load(run: Translation, moving: Moving, facets: ElasticFacets, kept: FacetForces, _: StepCut) -> list[Launch]:
    return [(kernels.load_kept_facet(moving, facets, kept, run.loads, _arms(run, kept)), run.span.m)]


def _moments(run: Translation, kept: FacetForces) -> list[Launch]:
    return [(kernels.gather_facet_moments(kept, run.bonds, run.loads, _arms(run, kept)), run.span.n)]


def on_surface(run: Translation, walls: WallConstraints) -> RowOrder:
    """Return the walls of each cell."""
    return run.once(walls.cell, lambda: new_row_order(walls.cell, run.span.n))


def _surface(
    run: Translation, moving: Moving, walls: WallConstraints, tractions: FacetTractions, stresses: StressesOfCells
) -> list[Launch]:
    tables = run.span, moving, walls, on_surface(run, walls), tractions, stresses
    return [(kernels.add_surface_stress(*tables), run.span.n)]


# ---- records


def _energies(
    run: Translation, moving: Moving, facets: ElasticFacets, cracks: CohesiveCracks, found: CrackEnergies
) -> list[Launch]:
    portions = _crack_portions(run, found)
    return [(kernels.sum_portion_of_cracks(run.span, moving, facets, cracks, portions), len(portions.energy))]


def _crack_portions(run: Translation, found: CrackEnergies) -> CrackPortions:
    return run.once(found, lambda: CrackPortions(np.zeros((-(-run.span.m // BONDS_OF_PORTION), 3))))


def _add_energies_to(
    run: Translation, moving: Moving, walls: WallConstraints, found: CrackEnergies, portions: Portions
) -> list[Launch]:
    held, launches = energy_of_walls(run, moving, walls)
    return [*launches, (kernels.add_energies_of_cracks(held, found, _crack_portions(run, found), portions), 1)]


def _dilatation(
    run: Translation, moving: Moving, cells: CellDilatation, found: CrackEnergies
) -> list[Launch]:  # fmt: skip
    return [(kernels.sum_stressed_portion(run.span, moving, cells, found), len(found.dilatation))]


def _write(run: Translation, found: CrackEnergies, history: HistoryRows) -> list[Launch]:
    return [(kernels.write_energy_of_yielding(run.span, found, history), 1)]


def _write_crushing(
    run: Translation, strengths: FacetStrengths, cracks: CohesiveCracks, log: EventLog, history: HistoryRows
) -> list[Launch]:
    portions = run.once(strengths, lambda: CrushingPortions(np.zeros(-(-run.span.m // BONDS_OF_PORTION))))
    return [
        (kernels.sum_portion_of_crushing(run.span, strengths, cracks, portions), len(portions.energy)),
        (kernels.write_all_crushing_of_facets(run.span, portions, log, history), 1),
    ]


COUNTERPARTS: dict[str, Counterpart] = {
    "add_and_keep_facet_loads": _load,
    "collect_facet_moments": lambda *_: [],  # a step on a device is one block
    "take_moments": _moments,
    "sum_moments": over(kernels.sum_moments_of_cell, elements),
    "find_cell_stresses": over(kernels.find_cell_stress, elements),
    "add_surface_stresses": _surface,
    "judge_cells": over(kernels.judge_cell, elements),
    "mark_cracking_facets": over(kernels.mark_facet, bonds),
    "begin_cracks": over(kernels.begin_marked_crack, bonds),
    "sum_stressed_dilatation": _dilatation,
    "sum_crack_energies": _energies,
    "add_crack_energies": _add_energies_to,
    "write_heat": _write,
    "write_crushing_of_facets": _write_crushing,
}
