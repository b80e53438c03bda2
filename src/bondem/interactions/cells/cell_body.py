"""Facets and cells of a lattice that the cell law needs."""

from bondem.errors import InputError
from bondem.specimen.lattice import Lattice
from bondem.specimen.tessellation.facets import Cells, Facets


def body_of(lattice: Lattice) -> tuple[Facets, Cells]:
    """Return the facets and cells of a body.

    Raises:
        InputError: The lattice has no cells.
    """
    if lattice.facets is None or lattice.cells is None:
        raise InputError(
            "CellBond needs a body cut into cells; connect particles with bd.connect(particles, method='laguerre')"
        )
    return lattice.facets, lattice.cells
