"""How the surface of a body of cells moves, where walls and loads are: half a cell outside the outermost elements."""

import numpy as np

from bondem._types import Floats
from bondem.model.cell_constants import body_of
from bondem.model.model import Model
from bondem.observe.cell_forces import CellForces, SmallMotion


def surface_displacement(model: Model, result: SmallMotion) -> Floats:
    """Displacement of the centroids of the facets on the surface [m], in the order of `cells.free`, (k, 3).

    A facet moves with its cell and opens, by d/2G (t - λθ M⁻¹n) under the traction t of the loads; where a wall holds
    it, it moves with the wall.

    Args:
        model: a body of cells.
        result: its linear static solution.
    """
    constants, forces = model.cell_constants, CellForces.of(model, result)
    _, cells = body_of(model.lattice)
    free, grips = cells.free, constants.grips
    cell = free.cell
    traction = forces.load / free.area[:, None] - forces.stress[cell, None] * constants.free_normal
    opening = (0.5 * free.depth / constants.G[cell])[:, None] * traction
    moved = result.displacement[cell] + np.cross(result.rotation[cell], forces.load_arm) + opening
    held = grips.holds.facet
    moved[held] = np.where(grips.axes > 0.0, grips.motion, moved[held])
    return moved
