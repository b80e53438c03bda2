"""The stiffness matrix of the facets of cells at rest, and what the dilatation of each cell is a sum of."""

from typing import NamedTuple

import numpy as np

from bondem._compile import device, kernel, prange
from bondem.kernels.tables import Adjacency


class FacetRows(NamedTuple):
    """Constants of m facets, a row each; see `bondem.model.cell_constants`."""

    k: np.ndarray  #: (m,)
    lever_i: np.ndarray  #: (m, 3)
    lever_j: np.ndarray
    H: np.ndarray  #: (m, 3, 3)
    share_i: np.ndarray  #: (m, 3)
    share_j: np.ndarray


@device
def _cross(b, r, c):
    """Entry (r, c) of [b]×, with [b]× v = b × v."""
    if r == c:
        return 0.0
    value = b[3 - r - c]
    return -value if (c - r) % 3 == 1 else value


@device
def _blocks(k, near, far, H, own, other):
    """Add the diagonal block of one end, and put the block towards the other end.

    The gap of a facet is δ = ±(u + φ × b) of its two ends, and the energy ½ k δ² + ½ ρ·H ρ with ρ the relative
    rotation; `near` and `far` are b of this end and the other.
    """
    for r in range(3):
        for c in range(3):
            unit = 1.0 if r == c else 0.0
            n, f = _cross(near, r, c), _cross(far, r, c)
            both = mine = 0.0  # -[near]× [far]× and -[near]× [near]×
            for d in range(3):
                both -= _cross(near, r, d) * _cross(far, d, c)
                mine -= _cross(near, r, d) * _cross(near, d, c)
            own[r, c] += k * unit
            own[r, 3 + c] -= k * n
            own[3 + r, c] += k * n
            own[3 + r, 3 + c] += k * mine + H[r, c]
            other[r, c] = -k * unit
            other[r, 3 + c] = k * f
            other[3 + r, c] = -k * n
            other[3 + r, 3 + c] = -k * both - H[r, c]


@device
def _form(share, lever, sign, out):
    """What the motion (u, φ) of an end adds to V θ: sign · share·(u + φ × lever)."""
    out[0] += sign * share[0]
    out[1] += sign * share[1]
    out[2] += sign * share[2]
    out[3] += sign * (lever[1] * share[2] - lever[2] * share[1])
    out[4] += sign * (lever[2] * share[0] - lever[0] * share[2])
    out[5] += sign * (lever[0] * share[1] - lever[1] * share[0])


@kernel(parallel=True)
def assemble_cells(facets, ends_i, ends_j, adjacency, indptr, indices, data, forms):
    """Fill block rows of 6×6 and of 1×6, degrees of freedom (u, φ) an element; facets and elements in their order."""
    in_start, out_start = adjacency.in_start, adjacency.out_start
    k, H, lever_i, lever_j = facets.k, facets.H, facets.lever_i, facets.lever_j
    share_i, share_j = facets.share_i, facets.share_j
    for p in prange(len(out_start) - 1):
        slot = indptr[p]
        diagonal = slot + in_start[p + 1] - in_start[p]
        indices[diagonal] = p
        data[diagonal] = 0.0
        forms[diagonal] = 0.0
        for b in range(in_start[p], in_start[p + 1]):
            indices[slot] = ends_i[b]
            _blocks(k[b], lever_j[b], lever_i[b], H[b], data[diagonal], data[slot])
            forms[slot] = 0.0
            _form(share_j[b], lever_j[b], 1.0, forms[diagonal, 0])
            _form(share_j[b], lever_i[b], -1.0, forms[slot, 0])
            slot += 1
        slot += 1
        for e in range(out_start[p], out_start[p + 1]):
            b = adjacency.out_bond[e]
            indices[slot] = ends_j[b]
            _blocks(k[b], lever_i[b], lever_j[b], H[b], data[diagonal], data[slot])
            forms[slot] = 0.0
            _form(share_i[b], lever_i[b], -1.0, forms[diagonal, 0])
            _form(share_i[b], lever_j[b], 1.0, forms[slot, 0])
            slot += 1


def cell_matrix_arrays(
    facets: FacetRows, ends_i: np.ndarray, ends_j: np.ndarray, adjacency: Adjacency
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:  # fmt: skip
    """Row pointers, columns, blocks (…, 6, 6) of the facets' stiffness and blocks (…, 1, 6) of V θ."""
    n = len(adjacency.out_start) - 1
    indptr = (adjacency.in_start + adjacency.out_start + np.arange(n + 1)).astype(np.int32)
    indices = np.empty(indptr[-1], dtype=np.int32)
    data, forms = np.empty((indptr[-1], 6, 6)), np.empty((indptr[-1], 1, 6))
    assemble_cells(facets, ends_i, ends_j, adjacency, indptr, indices, data, forms)
    return indptr, indices, data, forms
