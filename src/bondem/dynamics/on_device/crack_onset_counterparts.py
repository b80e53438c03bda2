"""Stresses of cells, and facets that begin to crack, on a device; and energies of bodies with cracks."""

import numpy as np

from bondem._passes import kernels
from bondem._tables.cell_tables import (
    FacetForces,
    WallConstraints,
)
from bondem._tables.columns import BONDS_OF_PORTION
from bondem._tables.crack_tables import CrackEnergies, FacetStrengths
from bondem._tables.device_tables import (
    CrackPortions,
    CrushingPortions,
    FacetArms,
    RowOrder,
)
from bondem.dynamics.on_device.cell_counterparts import ENERGY_OF_WALLS, OF_WALLS
from bondem.dynamics.on_device.device_tables import new_row_order
from bondem.dynamics.on_device.translation import (
    Counterpart,
    Given,
    Made,
    Translation,
    bonds,
    elements,
    in_order,
    length_of,
    one_thread,
    over,
)


def _arms(run: Translation, kept: FacetForces) -> FacetArms:
    def make() -> FacetArms:
        made = FacetArms(np.zeros((7, run.span.m)))
        run.scratch += [made.arm, kept.sums]
        return made

    return run.once(kept, make)


def on_surface(run: Translation, walls: WallConstraints) -> RowOrder:
    """Return the walls of each cell."""
    return run.once(walls.cell, lambda: new_row_order(walls.cell, run.span.n))


_ARMS: Made = {FacetArms: lambda run, given: _arms(run, given[FacetForces])}
#: The walls of each cell.
ON_SURFACE: Made = {RowOrder: lambda run, given: on_surface(run, given[WallConstraints])}


def _portions(run: Translation, _: Given) -> int:
    return -(-run.span.m // BONDS_OF_PORTION)


def _energies(run: Translation, given: Given) -> CrackPortions:
    return run.once(given[CrackEnergies], lambda: CrackPortions(np.zeros((_portions(run, given), 3))))


def _crushing(run: Translation, given: Given) -> CrushingPortions:
    return run.once(given[FacetStrengths], lambda: CrushingPortions(np.zeros(_portions(run, given))))


_ENERGIES: Made = {CrackPortions: _energies}
_CRUSHING: Made = {CrushingPortions: _crushing}

COUNTERPARTS: dict[str, Counterpart] = {
    "add_and_keep_facet_loads": over(kernels.load_kept_facet, bonds, _ARMS),
    "collect_facet_moments": in_order(),  # a step on a device is one block
    "take_moments": over(kernels.gather_facet_moments, elements, _ARMS),
    "sum_moments": over(kernels.sum_moments_of_cell, elements),
    "find_cell_stresses": over(kernels.find_cell_stress, elements),
    "add_surface_stresses": over(kernels.add_surface_stress, elements, ON_SURFACE),
    "judge_cells": over(kernels.judge_cell, elements),
    "mark_cracking_facets": over(kernels.mark_facet, bonds),
    "begin_cracks": over(kernels.begin_marked_crack, bonds),
    "sum_stressed_dilatation": over(kernels.sum_stressed_portion, length_of(CrackEnergies, lambda of: of.dilatation)),
    "sum_crack_energies": over(kernels.sum_portion_of_cracks, _portions, _ENERGIES),
    "add_crack_energies": in_order(
        ENERGY_OF_WALLS, over(kernels.add_energies_of_cracks, one_thread, {**OF_WALLS, **_ENERGIES})
    ),
    "write_heat": over(kernels.write_energy_of_yielding, one_thread),
    "write_crushing_of_facets": in_order(
        over(kernels.sum_portion_of_crushing, _portions, _CRUSHING),
        over(kernels.write_all_crushing_of_facets, one_thread, _CRUSHING),
    ),
}
