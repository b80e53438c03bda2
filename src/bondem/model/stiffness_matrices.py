"""Matrices of a model at rest: stiffness and mass, in internal order."""

import numpy as np
from scipy.sparse import bsr_array

from bondem._core import run_pass
from bondem._passes import calls
from bondem._tables.stiffness_tables import BeamRows, BlockRows, DilatationRows, FacetRows
from bondem._threads import current_threads
from bondem._types import Floats
from bondem.interactions.non_local.local_stiffness import local_stiffness
from bondem.model.model import Model
from bondem.model.stiffness import Stiffness
from bondem.specimen.ordering import Layout


def new_block_rows(layout: Layout) -> BlockRows:
    """Room for the rows of a layout."""
    n = len(layout.out_start) - 1
    indptr = (layout.in_start + layout.out_start + np.arange(n + 1)).astype(np.int32)
    indices, data = np.empty(indptr[-1], np.int32), np.empty((indptr[-1], 6, 6))
    return BlockRows(layout.in_start, layout.out_start, layout.out_bond, indptr, indices, data)




def stiffness_matrix(model: Model) -> Stiffness:
    """Return the stiffness K of the unconstrained lattice: 6×6 blocks, (u, θ) per element, internal order.

    It is the second derivative of the energy at rest; for bonds it is the same for both formulations. For the
    non-local law it is that of its springs alone, without the lagged stresses.
    """
    layout = model.layout
    size = 6 * len(layout.order)
    if model.non_local is not None:
        return Stiffness(local_stiffness(model.non_local, layout))
    rows = new_block_rows(layout)
    if model.cells is None:
        b = model.bonds
        columns = b.direction, b.length, b.lever, b.kn, b.ks, b.kb, b.kt
        beams = BeamRows(layout.i, layout.j, *map(np.ascontiguousarray, columns))
        run_pass(calls.assemble_beams(beams, rows), threads=current_threads())
        return Stiffness(bsr_array((rows.data, rows.indices, rows.indptr), shape=(size, size)))
    c = model.cells
    columns = c.k, c.lever_i, c.lever_j, c.H, c.share_i, c.share_j
    facets = FacetRows(layout.i, layout.j, *map(np.ascontiguousarray, columns))
    forms = np.empty((len(rows.indices), 1, 6))
    run_pass(calls.assemble_facets(facets, rows, DilatationRows(forms)), threads=current_threads())
    indptr, indices, data = rows.indptr, rows.indices, rows.data
    own, form = c.grips.blocks()
    gripped = layout.rank[c.grips.cell]
    diagonal = indptr[gripped] + (layout.in_start[gripped + 1] - layout.in_start[gripped])
    np.add.at(data, diagonal, own)
    np.add.at(forms, diagonal, form[:, None])
    return Stiffness(
        bsr_array((data, indices, indptr), shape=(size, size)),
        bsr_array((forms, indices, indptr), shape=(size // 6, size)),
        c.weight,
        c.gradients.coupling(c.weight),
        c.gradients.turns((c.gradients.way_a, c.gradients.way_b, c.gradients.held_way), size // 6),
    )


def mass_diagonal(model: Model) -> Floats:
    """Return the diagonal of the mass matrix: m, m, m, I, I, I per element [kg, kg·m²], internal order, (6 n,)."""
    order = model.layout.order
    return np.stack([model.mass[order]] * 3 + [model.inertia[order]] * 3, axis=1).ravel()
