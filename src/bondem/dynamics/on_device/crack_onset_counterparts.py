"""Stresses of cells, and facets that begin to crack, on a device; and energies of bodies with cracks."""

import numpy as np

from bondem._device import IndexPass, Launch
from bondem._tables.cell_tables import (
    CellDilatation,
    ElasticFacets,
    FacetForces,
    FacetsOfCells,
    FacetTractions,
    WallConstraints,
)
from bondem._tables.crack_tables import CohesiveCracks, CrackEnergies, CrackOnset, FacetStrengths, StressesOfCells
from bondem._tables.damage_tables import EventLog
from bondem._tables.device_tables import (
    BondsOfElements,
    CrackPortions,
    CrushingPortions,
    DeviceSpan,
    FacetArms,
    LoadsOfBonds,
    RowOrder,
    WallEnergy,
)
from bondem._tables.step_tables import HistoryRows, Moving, Portions, StepCut
from bondem.dynamics.on_device.cell_counterparts import energy_of_walls
from bondem.dynamics.on_device.device_tables import new_row_order
from bondem.dynamics.on_device.translation import Counterpart, Translation, bonds, elements, over

_load_facet = IndexPass("load_kept_facet", Moving, ElasticFacets, FacetForces, LoadsOfBonds, FacetArms)
_gather_facet_moments = IndexPass("gather_facet_moments", FacetForces, BondsOfElements, LoadsOfBonds, FacetArms)
_sum_moments = IndexPass(
    "sum_moments_of_cell", DeviceSpan, Moving, ElasticFacets, FacetsOfCells, FacetForces
)  # fmt: skip
_find_stress = IndexPass("find_cell_stress", DeviceSpan, Moving, FacetForces, StressesOfCells)
_ON_SURFACE = DeviceSpan, Moving, WallConstraints, RowOrder, FacetTractions, StressesOfCells
_add_surface_stress = IndexPass("add_surface_stress", *_ON_SURFACE)
_judge_cell = IndexPass("judge_cell", DeviceSpan, FacetStrengths, StressesOfCells, CrackOnset)
_mark_facet = IndexPass(
    "mark_facet", DeviceSpan, Moving, ElasticFacets, FacetForces, FacetStrengths, StressesOfCells, CrackOnset
)
_begin_crack = IndexPass(
    "begin_marked_crack", DeviceSpan, ElasticFacets, FacetForces, FacetStrengths, CrackOnset, CohesiveCracks
)
_sum_stressed = IndexPass("sum_stressed_portion", DeviceSpan, Moving, CellDilatation, CrackEnergies)
_sum_cracks = IndexPass(
    "sum_portion_of_cracks", DeviceSpan, Moving, ElasticFacets, CohesiveCracks, CrackPortions
)  # fmt: skip
_add_energies = IndexPass("add_energies_of_cracks", WallEnergy, CrackEnergies, CrackPortions, Portions)
_write_heat = IndexPass("write_energy_of_yielding", DeviceSpan, CrackEnergies, HistoryRows)
_sum_crushing = IndexPass(
    "sum_portion_of_crushing", DeviceSpan, FacetStrengths, CohesiveCracks, CrushingPortions
)  # fmt: skip
_crushing = IndexPass("write_all_crushing_of_facets", DeviceSpan, CrushingPortions, EventLog, HistoryRows)


# ---- forces and stresses


def _arms(run: Translation, kept: FacetForces) -> FacetArms:
    def make() -> FacetArms:
        made = FacetArms(np.zeros((7, run.span.m)))
        run.scratch += [made.arm, kept.sums]
        return made

    return run.once(kept, make)


def _load(run: Translation, moving: Moving, facets: ElasticFacets, kept: FacetForces, _: StepCut) -> list[Launch]:
    return [(_load_facet, run.span.m, (moving, facets, kept, run.loads, _arms(run, kept)))]


def _moments(run: Translation, kept: FacetForces) -> list[Launch]:
    return [(_gather_facet_moments, run.span.n, (kept, run.bonds, run.loads, _arms(run, kept)))]


def on_surface(run: Translation, walls: WallConstraints) -> RowOrder:
    """Return the walls of each cell."""
    return run.once(walls.cell, lambda: new_row_order(walls.cell, run.span.n))


def _surface(
    run: Translation, moving: Moving, walls: WallConstraints, tractions: FacetTractions, stresses: StressesOfCells
) -> list[Launch]:
    tables = run.span, moving, walls, on_surface(run, walls), tractions, stresses
    return [(_add_surface_stress, run.span.n, tables)]


# ---- records


def _energies(
    run: Translation, moving: Moving, facets: ElasticFacets, cracks: CohesiveCracks, found: CrackEnergies
) -> list[Launch]:
    portions = _crack_portions(run, found)
    return [(_sum_cracks, len(portions.energy), (run.span, moving, facets, cracks, portions))]


def _crack_portions(run: Translation, found: CrackEnergies) -> CrackPortions:
    return run.once(found, lambda: CrackPortions(np.zeros((-(-run.span.m // 2048), 3))))


def _add_energies_to(
    run: Translation, moving: Moving, walls: WallConstraints, found: CrackEnergies, portions: Portions
) -> list[Launch]:
    held, launches = energy_of_walls(run, moving, walls)
    return [*launches, (_add_energies, 1, (held, found, _crack_portions(run, found), portions))]


def _dilatation(
    run: Translation, moving: Moving, cells: CellDilatation, found: CrackEnergies
) -> list[Launch]:  # fmt: skip
    return [(_sum_stressed, len(found.dilatation), (run.span, moving, cells, found))]


def _write(run: Translation, found: CrackEnergies, history: HistoryRows) -> list[Launch]:
    return [(_write_heat, 1, (run.span, found, history))]


def _write_crushing(
    run: Translation, strengths: FacetStrengths, cracks: CohesiveCracks, log: EventLog, history: HistoryRows
) -> list[Launch]:
    portions = run.once(strengths, lambda: CrushingPortions(np.zeros(-(-run.span.m // 2048))))
    return [
        (_sum_crushing, len(portions.energy), (run.span, strengths, cracks, portions)),
        (_crushing, 1, (run.span, portions, log, history)),
    ]


COUNTERPARTS: dict[str, Counterpart] = {
    "add_and_keep_facet_loads": _load,
    "collect_facet_moments": lambda *_: [],  # a step on a device is one block
    "take_moments": _moments,
    "sum_moments": over(_sum_moments, elements),
    "find_cell_stresses": over(_find_stress, elements),
    "add_surface_stresses": _surface,
    "judge_cells": over(_judge_cell, elements),
    "mark_cracking_facets": over(_mark_facet, bonds),
    "begin_cracks": over(_begin_crack, bonds),
    "sum_stressed_dilatation": _dilatation,
    "sum_crack_energies": _energies,
    "add_crack_energies": _add_energies_to,
    "write_heat": _write,
    "write_crushing_of_facets": _write_crushing,
}
