"""Kernel launches on a device for the passes of yielding cells, material planes, and changing strains at cracks."""

from bondem._passes import kernels
from bondem._tables.crack_tables import FacetStrengths, StressesOfCells
from bondem.dynamics.on_device import counts
from bondem.dynamics.on_device.crack_onset_counterparts import ON_SURFACE
from bondem.dynamics.on_device.translation import Counterpart, Given, Translation, in_order, over


def _pressed_rows(run: Translation, given: Given) -> int:
    """Return the number of fixed, driven or loaded elements, or 0 if no surface carries a pressure."""
    return run.owners if len(given[StressesOfCells].pressed) else 0


COUNTERPARTS: dict[str, Counterpart] = {
    "find_still_stresses": over(kernels.find_still_stress, counts.elements),
    "add_still_surface_stresses": over(kernels.add_still_surface_stress, counts.elements, ON_SURFACE),
    "mark_cracking_planes": over(kernels.mark_plane, counts.length_of(FacetStrengths, lambda of: of.planes)),
    "yield_cells": over(kernels.yield_cell, counts.elements),
    "add_yielding_work": over(kernels.add_yielding_work_of_row, _pressed_rows),
    "sum_heat": over(kernels.sum_portion_of_heat, counts.portions_of_elements),
    "stretch_all_cells": over(kernels.stretch_yielded_cell, counts.elements),
    "stretch_cells": over(kernels.stretch_growing_cell, counts.elements),
    "stretch_walls_and_cracks": in_order(
        over(kernels.stretch_wall_of_cell, counts.walls), over(kernels.stretch_crack_of_cells, counts.bonds)
    ),
    "stretch_anew": in_order(
        over(kernels.keep_base_levers, counts.bonds),
        over(kernels.stretch_cell_anew, counts.elements),
        over(kernels.stretch_wall_anew, counts.walls),
    ),
    "follow_levers": over(kernels.follow_lever, counts.bonds),
    "sum_crack_powers": over(kernels.add_crack_power, counts.bonds),
    "begin_crack_powers": over(kernels.begin_crack_power, counts.bonds),
}
