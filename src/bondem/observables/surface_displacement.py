"""Displacement of the surface of a body of cells: free facets open until they carry the applied traction."""

import numpy as np

from bondem._checks import instance
from bondem._types import Floats, PerElement3
from bondem.interactions.cells.cell_body import body_of
from bondem.interactions.cells.cell_strain import CellStrain
from bondem.model.model import Model


def surface_displacement(
    model: Model, displacement: PerElement3, rotation: PerElement3, *, traction: Floats | None = None
) -> Floats:
    """Compute displacements of the centroids of the free facets [m], shape (k, 3), in the order of `cells.free`.

    A facet lies half a cell outside of its element, and that half is strained too. With the stress σ = λ θ of the
    cell, the facet opens by (d / 2 G)(t - σ m). A facet that a wall holds moves with the wall.

    Args:
        model: a body of cells.
        displacement, rotation: small displacements and rotations of its elements [m, rad], (n, 3) each.
        traction: tractions on the free facets [Pa], (k, 3); None for none.

    Raises:
        InputError: The model has no cells.
    """
    instance("surface_displacement", "model", model, Model, "bd.Model(...)")
    _, cells = body_of(model.lattice)
    free = cells.free
    arm = free.centroid - cells.centroid[free.cell]
    rigid = displacement[free.cell] + np.cross(rotation[free.cell], arm)
    if model.cells is None:  # another law of a body, whose facets do not open
        return rigid
    constants = model.cell_constants
    pressed = None if traction is None else constants.pressed_by(free.area[:, None] * traction)
    wall = constants.grips.motion
    found = CellStrain.of(model.lattice, constants, displacement, rotation, wall=wall, pressed=pressed)
    pull = -found.stress(constants)[free.cell, None] * constants.way
    if traction is not None:
        pull = pull + traction
    moved = rigid + constants.softness[:, None] * pull
    grips = constants.grips
    moved[grips.holds.facet] = np.where(grips.axes > 0.0, grips.motion, moved[grips.holds.facet])
    return moved
