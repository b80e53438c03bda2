"""Kernel launches on a device for the passes of cell stresses, initiation of cracks, and energies with cracks."""

import numpy as np

from bondem._passes import kernels
from bondem._tables.cell_tables import FacetForces, WallConstraints
from bondem._tables.device_tables import FacetArms, RowOrder
from bondem.dynamics.on_device import counts
from bondem.dynamics.on_device.translation import Counterpart, Made, Translation, in_order, new_row_order, over


def _arms(run: Translation, stored: FacetForces) -> FacetArms:
    def make() -> FacetArms:
        made = FacetArms(np.zeros((7, run.span.m)))
        run.scratch += [made.arm, stored.sums]
        return made

    return run.once(stored, make)


def on_surface(run: Translation, walls: WallConstraints) -> RowOrder:
    """Return the table that lists the walls of each cell."""
    return run.once(walls.cell, lambda: new_row_order(walls.cell, run.span.n))


_ARMS: Made = {FacetArms: lambda run, given: _arms(run, given[FacetForces])}
#: The walls of each cell.
ON_SURFACE: Made = {RowOrder: lambda run, given: on_surface(run, given[WallConstraints])}

COUNTERPARTS: dict[str, Counterpart] = {
    "add_and_keep_facet_loads": over(kernels.load_stored_facet, counts.bonds, _ARMS),
    "collect_facet_moments": in_order(),  # a step on a device is one block
    "take_moments": over(kernels.gather_facet_moments, counts.elements, _ARMS),
    "sum_moments": over(kernels.sum_moments_of_cell, counts.elements),
    "find_cell_stresses": over(kernels.find_cell_stress, counts.elements),
    "add_surface_stresses": over(kernels.add_surface_stress, counts.elements, ON_SURFACE),
    "judge_cells": over(kernels.judge_cell, counts.elements),
    "mark_cracking_facets": over(kernels.mark_facet, counts.bonds),
    "begin_cracks": over(kernels.begin_marked_crack, counts.bonds),
    "sum_stressed_dilatation": over(kernels.sum_stressed_portion, counts.portions_of_elements),
    "sum_crack_energies": over(kernels.sum_portion_of_cracks, counts.portions_of_bonds),
    "write_crushing_of_facets": in_order(
        over(kernels.sum_portion_of_crushing, counts.portions_of_bonds),
        over(kernels.write_all_crushing_of_facets, counts.one_thread),
    ),
}
