"""Access to the facets and cells of a lattice, for the cell law."""

from bondem._types import Floats, Ints
from bondem.interactions.row_sums import row_sums
from bondem.specimen.lattice import Lattice
from bondem.specimen.tessellation.facets import Cells, Facets


def body_of(lattice: Lattice) -> tuple[Facets, Cells]:
    """Return the facets and cells of a lattice that is cut into cells.

    Raises:
        InputError: The lattice has no cells.
    """
    body = lattice.elements.require_cells(
        "CellBond needs a body cut into cells; connect particles with bd.connect(particles, method='laguerre')"
    )
    return body.facets, body.cells


def sums_of_normals(cell: Ints, weight: Floats, normal: Floats, n: int) -> Floats:
    """Return Σ w n⊗n over the facets of each cell, in the unit of w, (n, 3, 3); w (k,), n (k, 3)."""
    products = (weight[:, None] * normal)[:, :, None] * normal[:, None, :]
    return row_sums(cell, products.reshape(-1, 9), n).reshape(n, 3, 3)
