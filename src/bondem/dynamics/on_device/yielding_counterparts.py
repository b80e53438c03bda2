"""Cells that yield, facets of material planes, and cracks under strains that change, on a device."""

import numpy as np

from bondem._device import IndexPass, Launch
from bondem._tables.cell_tables import (
    CellStrains,
    ElasticFacets,
    FacetForces,
    FacetsOfCells,
    FacetTractions,
    WallConstraints,
)
from bondem._tables.crack_tables import (
    CohesiveCracks,
    CrackEnergies,
    CrackOnset,
    FacetStrengths,
    StressesOfCells,
    YieldingCells,
)
from bondem._tables.device_tables import DeviceSpan, RowOrder, StrainPortions
from bondem._tables.step_tables import Moving, Rows, StepCut
from bondem.dynamics.on_device.crack_onset_counterparts import on_surface
from bondem.dynamics.on_device.translation import Counterpart, Translation, bonds, elements, over

_find_still_stress = IndexPass("find_still_stress", DeviceSpan, Moving, FacetForces, StressesOfCells)
_add_still_surface_stress = IndexPass(
    "add_still_surface_stress", DeviceSpan, Moving, WallConstraints, RowOrder, FacetTractions, StressesOfCells
)
_mark_plane = IndexPass("mark_plane", DeviceSpan, Moving, ElasticFacets, FacetForces, FacetStrengths, CrackOnset)
_yield_cell = IndexPass("yield_cell", DeviceSpan, Moving, StressesOfCells, YieldingCells, CrackOnset)
_add_work_of_row = IndexPass(
    "add_yielding_work_of_row", DeviceSpan, StepCut, FacetTractions, StressesOfCells, YieldingCells, Rows
)
_sum_heat = IndexPass("sum_portion_of_heat", DeviceSpan, StressesOfCells, YieldingCells, CrackEnergies)
_OF_CELLS = ElasticFacets, FacetsOfCells, YieldingCells
_stretch_yielded_cell = IndexPass("stretch_yielded_cell", *_OF_CELLS)
_stretch_growing_cell = IndexPass("stretch_growing_cell", DeviceSpan, *_OF_CELLS)
_stretch_wall = IndexPass("stretch_wall_of_cell", DeviceSpan, WallConstraints, YieldingCells)
_stretch_crack = IndexPass("stretch_crack_of_cells", DeviceSpan, ElasticFacets, YieldingCells, CohesiveCracks)
_keep_base_levers = IndexPass("keep_base_levers", CellStrains, ElasticFacets, YieldingCells)
_stretch_cell_anew = IndexPass("stretch_cell_anew", CellStrains, *_OF_CELLS)
_stretch_wall_anew = IndexPass("stretch_wall_anew", CellStrains, WallConstraints, YieldingCells)
_follow_lever = IndexPass("follow_lever", CellStrains, ElasticFacets, CohesiveCracks)
_POWERS = DeviceSpan, Moving, CellStrains, ElasticFacets, CohesiveCracks, StrainPortions
_sum_powers = IndexPass("sum_portion_of_crack_powers", *_POWERS)
_begin_powers = IndexPass("begin_portion_of_crack_powers", *_POWERS)
_add_powers = IndexPass("add_crack_powers", CellStrains, StrainPortions)


def _still_surface(
    run: Translation, moving: Moving, walls: WallConstraints, tractions: FacetTractions, stresses: StressesOfCells
) -> list[Launch]:
    tables = run.span, moving, walls, on_surface(run, walls), tractions, stresses
    return [(_add_still_surface_stress, run.span.n, tables)]


def _planes(
    run: Translation, moving: Moving, facets: ElasticFacets, kept: FacetForces, strengths: FacetStrengths,
    onset: CrackOnset,
) -> list[Launch]:  # fmt: skip
    return [(_mark_plane, len(strengths.planes), (run.span, moving, facets, kept, strengths, onset))]


# ---- cells that yield


def _yield(
    run: Translation, moving: Moving, _: FacetStrengths, stresses: StressesOfCells, cells: YieldingCells,
    onset: CrackOnset,
) -> list[Launch]:  # fmt: skip
    return [(_yield_cell, run.span.n, (run.span, moving, stresses, cells, onset))]


def _work(
    run: Translation, tractions: FacetTractions, stresses: StressesOfCells, cells: YieldingCells, rows: Rows
) -> list[Launch]:
    count = run.held if len(stresses.pressed) else 0
    return [(_add_work_of_row, count, (run.span, run.cut, tractions, stresses, cells, rows))]


def _heat(
    run: Translation, stresses: StressesOfCells, cells: YieldingCells, found: CrackEnergies
) -> list[Launch]:  # fmt: skip
    return [(_sum_heat, len(found.heat), (run.span, stresses, cells, found))]


def _stretch_walls_and_cracks(
    run: Translation, facets: ElasticFacets, walls: WallConstraints, cells: YieldingCells, cracks: CohesiveCracks
) -> list[Launch]:
    return [
        (_stretch_wall, len(walls.cell), (run.span, walls, cells)),
        (_stretch_crack, run.span.m, (run.span, facets, cells, cracks)),
    ]


def _stretch_anew(
    run: Translation, strains: CellStrains, facets: ElasticFacets, of_cells: FacetsOfCells, walls: WallConstraints,
    cells: YieldingCells,
) -> list[Launch]:  # fmt: skip
    return [
        (_keep_base_levers, run.span.m, (strains, facets, cells)),
        (_stretch_cell_anew, run.span.n, (strains, facets, of_cells, cells)),
        (_stretch_wall_anew, len(walls.cell), (strains, walls, cells)),
    ]


# ---- work of strains at cracks


def _powers(one: IndexPass) -> Counterpart:
    def counterpart(
        run: Translation, moving: Moving, strains: CellStrains, facets: ElasticFacets, cracks: CohesiveCracks
    ) -> list[Launch]:
        def make() -> StrainPortions:
            return StrainPortions(np.zeros(2, dtype=np.int64), np.zeros_like(strains.power))

        portions = run.once(strains, make)
        return [
            (one, len(portions.power), (run.span, moving, strains, facets, cracks, portions)),
            (_add_powers, len(strains.schedule), (strains, portions)),
        ]

    return counterpart


COUNTERPARTS: dict[str, Counterpart] = {
    "find_still_stresses": over(_find_still_stress, elements),
    "add_still_surface_stresses": _still_surface,
    "mark_cracking_planes": _planes,
    "yield_cells": _yield,
    "add_yielding_work": _work,
    "sum_heat": _heat,
    "stretch_all_cells": over(_stretch_yielded_cell, elements, spans=False),
    "stretch_cells": over(_stretch_growing_cell, elements),
    "stretch_walls_and_cracks": _stretch_walls_and_cracks,
    "stretch_anew": _stretch_anew,
    "follow_levers": over(_follow_lever, bonds, spans=False),
    "sum_crack_powers": _powers(_sum_powers),
    "begin_crack_powers": _powers(_begin_powers),
}
