"""Cells that yield, facets of material planes, and cracks under strains that change, on a device."""

import numpy as np

from bondem._passes import kernels
from bondem._tables.cell_tables import (
    CellStrains,
    WallConstraints,
)
from bondem._tables.crack_tables import (
    CrackEnergies,
    FacetStrengths,
    StressesOfCells,
)
from bondem._tables.device_tables import StrainPortions
from bondem.dynamics.on_device.crack_onset_counterparts import ON_SURFACE
from bondem.dynamics.on_device.translation import (
    Counterpart,
    Given,
    Made,
    Translation,
    bonds,
    elements,
    in_order,
    length_of,
    over,
)


def _powers(run: Translation, given: Given) -> StrainPortions:
    strains = given[CellStrains]
    return run.once(strains, lambda: StrainPortions(np.zeros(2, dtype=np.int64), np.zeros_like(strains.power)))


def _pressed_rows(run: Translation, given: Given) -> int:
    """Return the number of elements that own rows, or none where no surface carries a pressure."""
    return run.held if len(given[StressesOfCells].pressed) else 0


_POWERS: Made = {StrainPortions: _powers}
_PORTIONS = length_of(CellStrains, lambda of: of.power)
_ADD_POWERS = over(kernels.add_crack_powers, length_of(CellStrains, lambda of: of.schedule), _POWERS)
_WALLS = length_of(WallConstraints, lambda walls: walls.cell)

COUNTERPARTS: dict[str, Counterpart] = {
    "find_still_stresses": over(kernels.find_still_stress, elements),
    "add_still_surface_stresses": over(kernels.add_still_surface_stress, elements, ON_SURFACE),
    "mark_cracking_planes": over(kernels.mark_plane, length_of(FacetStrengths, lambda of: of.planes)),
    "yield_cells": over(kernels.yield_cell, elements),
    "add_yielding_work": over(kernels.add_yielding_work_of_row, _pressed_rows),
    "sum_heat": over(kernels.sum_portion_of_heat, length_of(CrackEnergies, lambda of: of.heat)),
    "stretch_all_cells": over(kernels.stretch_yielded_cell, elements),
    "stretch_cells": over(kernels.stretch_growing_cell, elements),
    "stretch_walls_and_cracks": in_order(
        over(kernels.stretch_wall_of_cell, _WALLS), over(kernels.stretch_crack_of_cells, bonds)
    ),
    "stretch_anew": in_order(
        over(kernels.keep_base_levers, bonds),
        over(kernels.stretch_cell_anew, elements),
        over(kernels.stretch_wall_anew, _WALLS),
    ),
    "follow_levers": over(kernels.follow_lever, bonds),
    "sum_crack_powers": in_order(over(kernels.sum_portion_of_crack_powers, _PORTIONS, _POWERS), _ADD_POWERS),
    "begin_crack_powers": in_order(
        over(kernels.begin_portion_of_crack_powers, _PORTIONS, _POWERS), _ADD_POWERS
    ),
}
