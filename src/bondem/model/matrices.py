"""Matrices of a model at rest: stiffness and mass, in the kernels' order."""

import numpy as np
from scipy.sparse import bsr_array

from bondem._types import Floats
from bondem.kernels.assembly import block_matrix_arrays
from bondem.kernels.cell_assembly import FacetRows, cell_matrix_arrays
from bondem.model.local_stiffness import local_stiffness
from bondem.model.model import Model
from bondem.model.stiffness import Stiffness


def stiffness_matrix(model: Model) -> Stiffness:
    """Return the stiffness K of the unconstrained lattice: 6×6 blocks, (u, θ) per element, internal order.

    It is the second derivative of the energy at rest; for bonds it is the same for both formulations. For the
    non-local law it is that of its springs alone, without the lagged stresses.
    """
    layout = model.layout
    size = 6 * len(layout.order)
    if model.non_local is not None:
        return Stiffness(local_stiffness(model.non_local, layout))
    if model.cells is None:
        bonds = model.bonds.rows(layout, model.period, np.ones(len(layout.i)))
        indptr, indices, data = block_matrix_arrays(bonds, layout.adjacency)
        return Stiffness(bsr_array((data, indices, indptr), shape=(size, size)))
    c = model.cells
    facets = FacetRows(c.k, c.lever_i, c.lever_j, c.H, c.share_i, c.share_j)
    indptr, indices, data, forms = cell_matrix_arrays(facets, layout.i, layout.j, layout.adjacency)
    own, form = c.grips.blocks()
    gripped = layout.rank[c.grips.cell]
    diagonal = indptr[gripped] + (layout.in_start[gripped + 1] - layout.in_start[gripped])
    np.add.at(data, diagonal, own)
    np.add.at(forms, diagonal, form[:, None])
    return Stiffness(
        bsr_array((data, indices, indptr), shape=(size, size)),
        bsr_array((forms, indices, indptr), shape=(size // 6, size)),
        c.weight,
    )


def mass_diagonal(model: Model) -> Floats:
    """Return the diagonal of the mass matrix: m, m, m, I, I, I per element [kg, kg·m²], internal order, (6 n,)."""
    order = model.layout.order
    return np.stack([model.mass[order]] * 3 + [model.inertia[order]] * 3, axis=1).ravel()
