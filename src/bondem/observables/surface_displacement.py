"""Displacement of the surface of a body of cells: free facets open until they carry the applied traction."""

import numpy as np

from bondem._checks import instance
from bondem._types import Floats, PerElement3
from bondem.interactions.cells.cell_body import body_of
from bondem.model.model import Model


def surface_displacement(
    model: Model, displacement: PerElement3, rotation: PerElement3, *, traction: Floats | None = None
) -> Floats:
    """Compute displacements of the centroids of the free facets [m], shape (k, 3), in the order of `cells.free`.

    The part of a cell between its centre and a free facet deforms, too. With the stress σ = λ θ of the cell, its
    depth d along the normal m, and the traction t, the facet opens by (d / 2 G)(t - σ m). A facet that a wall
    constrains moves with the wall.

    Args:
        model: a body of cells.
        displacement, rotation: small displacements and rotations of its elements [m, rad], (n, 3) each.
        traction: tractions on the free facets [Pa], (k, 3); None for none.

    Raises:
        InputError: The model has no cells.
    """
    instance("surface_displacement", "model", model, Model, "bd.Model(...)")
    _, cells = body_of(model.lattice)
    traction = np.zeros((len(cells.free.cell), 3)) if traction is None else traction
    return model.interaction.surface_motion(displacement, rotation, traction)
