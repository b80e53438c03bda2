"""Matrices of a model at rest: stiffness and mass, in the kernels' order."""

import numpy as np
from scipy.sparse import bsr_array

from bondem._types import Floats
from bondem.kernels.assembly import block_matrix_arrays
from bondem.model.model import Model


def stiffness_matrix(model: Model) -> bsr_array:
    """Stiffness K of the unconstrained lattice: 6×6 blocks, (u, θ) an element, internal order.

    It is the second derivative of the bond energy at rest; the same for both formulations.
    """
    layout = model.layout
    bonds = model.bonds.rows(layout, model.period, np.ones(len(layout.i)))
    indptr, indices, data = block_matrix_arrays(bonds, layout.adjacency)
    size = 6 * len(layout.order)
    return bsr_array((data, indices, indptr), shape=(size, size))


def mass_diagonal(model: Model) -> Floats:
    """Diagonal of the mass matrix: m, m, m, I, I, I an element [kg, kg·m²], internal order, shape (6 n,)."""
    order = model.layout.order
    return np.stack([model.mass[order]] * 3 + [model.inertia[order]] * 3, axis=1).ravel()
