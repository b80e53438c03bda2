"""Cells that yield, facets of material planes, and cracks under strains that change, on a device."""

import numpy as np

from bondem._device import Launch
from bondem._passes import kernels
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
from bondem._tables.device_tables import DeviceSpan, StrainPortions
from bondem._tables.step_tables import Moving, Rows
from bondem.dynamics.on_device.crack_onset_counterparts import on_surface
from bondem.dynamics.on_device.translation import Counterpart, KernelOf, Translation, bonds, elements, over

_OF_CELLS = ElasticFacets, FacetsOfCells, YieldingCells
_POWERS = DeviceSpan, Moving, CellStrains, ElasticFacets, CohesiveCracks, StrainPortions


def _still_surface(
    run: Translation, moving: Moving, walls: WallConstraints, tractions: FacetTractions, stresses: StressesOfCells
) -> list[Launch]:
    tables = run.span, moving, walls, on_surface(run, walls), tractions, stresses
    return [(kernels.add_still_surface_stress(*tables), run.span.n)]


def _planes(
    run: Translation, moving: Moving, facets: ElasticFacets, kept: FacetForces, strengths: FacetStrengths,
    onset: CrackOnset,
) -> list[Launch]:  # fmt: skip
    return [(kernels.mark_plane(run.span, moving, facets, kept, strengths, onset), len(strengths.planes))]


# ---- cells that yield


def _yield(
    run: Translation, moving: Moving, _: FacetStrengths, stresses: StressesOfCells, cells: YieldingCells,
    onset: CrackOnset,
) -> list[Launch]:  # fmt: skip
    return [(kernels.yield_cell(run.span, moving, stresses, cells, onset), run.span.n)]


def _work(
    run: Translation, tractions: FacetTractions, stresses: StressesOfCells, cells: YieldingCells, rows: Rows
) -> list[Launch]:
    count = run.held if len(stresses.pressed) else 0
    return [(kernels.add_yielding_work_of_row(run.span, run.cut, tractions, stresses, cells, rows), count)]


def _heat(
    run: Translation, stresses: StressesOfCells, cells: YieldingCells, found: CrackEnergies
) -> list[Launch]:  # fmt: skip
    return [(kernels.sum_portion_of_heat(run.span, stresses, cells, found), len(found.heat))]


def _stretch_walls_and_cracks(
    run: Translation, facets: ElasticFacets, walls: WallConstraints, cells: YieldingCells, cracks: CohesiveCracks
) -> list[Launch]:
    return [
        (kernels.stretch_wall_of_cell(run.span, walls, cells), len(walls.cell)),
        (kernels.stretch_crack_of_cells(run.span, facets, cells, cracks), run.span.m),
    ]


def _stretch_anew(
    run: Translation, strains: CellStrains, facets: ElasticFacets, of_cells: FacetsOfCells, walls: WallConstraints,
    cells: YieldingCells,
) -> list[Launch]:  # fmt: skip
    return [
        (kernels.keep_base_levers(strains, facets, cells), run.span.m),
        (kernels.stretch_cell_anew(strains, facets, of_cells, cells), run.span.n),
        (kernels.stretch_wall_anew(strains, walls, cells), len(walls.cell)),
    ]


# ---- work of strains at cracks


def _powers(one: KernelOf) -> Counterpart:
    def counterpart(
        run: Translation, moving: Moving, strains: CellStrains, facets: ElasticFacets, cracks: CohesiveCracks
    ) -> list[Launch]:
        def make() -> StrainPortions:
            return StrainPortions(np.zeros(2, dtype=np.int64), np.zeros_like(strains.power))

        portions = run.once(strains, make)
        return [
            (one(run.span, moving, strains, facets, cracks, portions), len(portions.power)),
            (kernels.add_crack_powers(strains, portions), len(strains.schedule)),
        ]

    return counterpart


COUNTERPARTS: dict[str, Counterpart] = {
    "find_still_stresses": over(kernels.find_still_stress, elements),
    "add_still_surface_stresses": _still_surface,
    "mark_cracking_planes": _planes,
    "yield_cells": _yield,
    "add_yielding_work": _work,
    "sum_heat": _heat,
    "stretch_all_cells": over(kernels.stretch_yielded_cell, elements, spans=False),
    "stretch_cells": over(kernels.stretch_growing_cell, elements),
    "stretch_walls_and_cracks": _stretch_walls_and_cracks,
    "stretch_anew": _stretch_anew,
    "follow_levers": over(kernels.follow_lever, bonds, spans=False),
    "sum_crack_powers": _powers(kernels.sum_portion_of_crack_powers),
    "begin_crack_powers": _powers(kernels.begin_portion_of_crack_powers),
}
