"""Balanced shares: contributions of facets to the dilatation of their cells that make uniform stresses exact.

With shares s the dilatation of cell p is V_p θ_p = Σ s_p·δ over its facets, of area A, unit normal n outwards and
opening δ. Two conditions make every uniform stress an exact solution in every cell:

    balance       s_i + s_j = A n on inner facets,  s = A n on the surface
    consistency   Σ_inner sym(s_p ⊗ B) + Σ_surface sym(s_p ⊗ (c - g_p)) = V_p 1   in every cell

g_p is the centre (generator) of the cell, B = g_q - g_p the branch to its neighbour, and c the centroid of a facet.
d_p is the distance of g_p from the facet, L = d_i + d_j and w_p = d_p / L. The shares s_i = A (w_i n + a) and
s_j = A (w_j n - a) satisfy the balance for any correction a, one vector per facet. The corrections follow from
consistency. By the divergence theorem the equations of all cells add up to zero, so that they have solutions in every
body. The solution is that of least Σ W |a|² with W = √(A Ā) L / (4 w_i w_j) and the mean area Ā. The root keeps
corrections of small facets small, and the product w_i w_j those of a facet close to a centre.

With a symmetric tensor Y of each cell as multiplier, a = (A / W) (Y_i - Y_j) B, and Y solves a symmetric system of
six equations per cell (`balance_solver`). Y is determined up to a constant.

Related: face vectors of least norm that make a discrete divergence conservative and linearly exact (Chiu et al. 2012;
Trask, Bochev and Perego 2020).
"""

from typing import NamedTuple

import numpy as np

from bondem._types import Floats, Ints, Pairs, PerBond, PerBond3, PerElement, PerElement3
from bondem.specimen.tessellation.balance_solver import COLUMN, ROW, SCALE, solved_balance
from bondem.specimen.tessellation.facets import FreeFacets

#: Error of θ over the cells under a unit strain at which the iteration ends, root mean square [-].
TOLERANCE = 1e-8
# Errors below this are rounding: bodies of cubes need no correction.
_ROUNDING = 1e-13


class Shares(NamedTuple):
    """Shares of all inner facets in the dilatation of their cells, and the error that they leave.

    Attributes:
        i, j: shares s of each facet in the dilatations θ of cells i and j [m²], (m, 3): V θ is Σ s·δ with jumps δ.
        remainder: error of θ of each cell under a unit strain [-], shape (n,).
    """

    i: PerBond3
    j: PerBond3
    remainder: PerElement


def balanced_shares(
    pairs: Pairs, vector: PerBond3, weight: tuple[PerBond, PerBond], branch: PerBond3,
    free: FreeFacets, volume: PerElement, position: PerElement3,
) -> Shares:  # fmt: skip
    """Compute the shares of all inner facets in the dilatation of their cells.

    Args:
        pairs: cells i, j of each facet, (m, 2).
        vector: area vectors A n of the facets, from i to j [m²], (m, 3).
        weight: w_i and w_j, the parts of the branch on both sides of the facet, positive [-], (m,) each.
        branch: vectors from centre i to centre j [m], (m, 3).
        free: facets on the surface, with their shares.
        volume: volumes of the cells [m³], (n,).
        position: centres [m], (n, 3).
    """
    i, j = pairs.T
    w_i, w_j = (part[:, None] for part in weight)
    n = len(volume)
    plain = _tensors(vector, branch)
    missing = np.outer(volume, ROW == COLUMN) - _sum(i, w_i * plain, n) - _sum(j, w_j * plain, n)
    missing -= _sum(free.cell, _tensors(free.share, free.centroid - position[free.cell]), n)
    size = float(np.linalg.norm(volume))
    area = np.linalg.norm(vector, axis=1, keepdims=True)
    usual = area.mean() if len(area) else 1.0  # a body of one cell has free facets only
    freedom = 4.0 * w_i * w_j * area * np.sqrt(area / usual) / np.linalg.norm(branch, axis=1, keepdims=True)
    correction = np.zeros_like(branch)
    if len(pairs) and np.linalg.norm(missing * SCALE) > _ROUNDING * size:
        y = solved_balance(position, pairs, np.sqrt(freedom) * branch, missing * SCALE, TOLERANCE * size) / SCALE
        correction = freedom * _times(y[i] - y[j], branch)
    shift = _tensors(correction, branch)
    left = missing - _sum(i, shift, n) + _sum(j, shift, n)
    if not np.linalg.norm(left) <= np.linalg.norm(missing):  # no solution was found
        correction, left = np.zeros_like(branch), missing
    remainder = np.linalg.norm(left * SCALE, axis=1) / volume
    return Shares(w_i * vector + correction, w_j * vector - correction, remainder)


def _tensors(a: Floats, b: Floats) -> Floats:
    """Return sym(a ⊗ b) of vectors (k, 3) as rows of six components, (k, 6)."""
    return 0.5 * (a[:, ROW] * b[:, COLUMN] + a[:, COLUMN] * b[:, ROW])


def _times(tensor: Floats, vector: Floats) -> Floats:
    """Return products of symmetric tensors (k, 6) with vectors, (k, 3)."""
    xx, yy, zz, xy, xz, yz = tensor.T
    x, y, z = vector.T
    return np.column_stack([xx * x + xy * y + xz * z, xy * x + yy * y + yz * z, xz * x + yz * y + zz * z])


def _sum(cell: Ints, value: Floats, n: int) -> Floats:
    """Return the sums of values (k, 6) over each cell, (n, 6)."""
    sums = [np.bincount(cell, weights=column, minlength=n) for column in value.T]
    return np.column_stack(sums).astype(float)
