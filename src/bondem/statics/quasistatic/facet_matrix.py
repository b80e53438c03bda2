"""Stiffness matrix of a body of cells, changed in place facet by facet."""

from dataclasses import replace

import numpy as np
from scipy.sparse import csr_array

from bondem._types import Floats, Ints
from bondem.model.stiffness import Stiffness
from bondem.specimen.ordering import Layout


class FacetMatrix:
    """The matrix K = B + Fᵀ W F of `Stiffness`, with entries of single facets that can change.

    It is scaled by blocks S of its elements, Sᵀ K S, and changes with the unscaled matrix.

    Attributes:
        plain: K.
        scaled: Sᵀ K S.
    """

    def __init__(self, plain: Stiffness, layout: Layout, root: Floats) -> None:
        """Make the matrix from that of the whole body.

        Args:
            plain: matrix of the whole body, in internal order.
            layout: order of elements and bonds.
            root: S of each element, (n, 6, 6).
        """
        assert plain.forms is not None
        self.plain = replace(plain, weight=plain.weight.copy())
        self._i, self._j = layout.i.astype(np.int64), layout.j.astype(np.int64)
        start, inward = plain.bonds.indptr.astype(np.int64), np.diff(layout.in_start)
        self._diagonal = start[:-1] + inward
        place = np.arange(len(self._i))
        self._below = start[self._j] + place - layout.in_start[self._j]  # row j, column i
        above = np.empty(len(place), dtype=np.int64)
        leaving = self._i[layout.out_bond]
        above[layout.out_bond] = self._diagonal[leaving] + 1 + place - layout.out_start[leaving]
        self._above = above  # row i, column j
        self._plain_rows = _by_rows(self.plain)
        self.rescale(root)

    @property
    def sides(self) -> tuple[Ints, Ints]:
        """Cells on either side of each facet, (m,) each."""
        return self._i, self._j

    def rescale(self, root: Floats) -> None:
        """Scale by other blocks S."""
        self._root = root
        self.scaled = self.plain.scaled(root)
        self._scaled_rows = _by_rows(self.scaled)

    def __matmul__(self, motion: Floats) -> Floats:
        """Return Sᵀ K S x of (6 n,)."""
        weighted = self.plain.weight * (self._scaled_rows @ motion)
        return np.asarray(self.scaled.bonds @ motion + self._scaled_rows.T @ weighted, dtype=float)

    def force(self, motion: Floats) -> Floats:
        """Return K u of (6 n,)."""
        weighted = self.plain.weight * (self._plain_rows @ motion)
        return np.asarray(self.plain.bonds @ motion, dtype=float) + self.swelling_force(weighted)

    def swelling_force(self, stress: Floats) -> Floats:
        """Return Fᵀ σ of (n,), (6 n,)."""
        return np.asarray(self._plain_rows.T @ stress, dtype=float)

    def add(self, k: int, block: Floats, form_i: Floats, form_j: Floats) -> None:
        """Add to the contribution of facet k.

        Args:
            k: internal number.
            block: addition to the stiffness of its two cells, (12, 12).
            form_i, form_j: additions to V θ of each cell, (12,).
        """
        i, j = self._i[k], self._j[k]
        self._put(self.plain, k, block, form_i, form_j)
        self.plain.__dict__.pop("_rows", None)  # what it has made of its forms, once
        turn = np.zeros((12, 12))
        turn[:6, :6], turn[6:, 6:] = self._root[i], self._root[j]
        self._put(self.scaled, k, turn.T @ block @ turn, form_i @ turn, form_j @ turn)

    def _put(self, matrix: Stiffness, k: int, block: Floats, form_i: Floats, form_j: Floats) -> None:
        assert matrix.forms is not None
        i, j = self._diagonal[self._i[k]], self._diagonal[self._j[k]]
        above, below = self._above[k], self._below[k]
        data, form = matrix.bonds.data, matrix.forms.data[:, 0]
        for place, part in ((i, block[:6, :6]), (above, block[:6, 6:]), (below, block[6:, :6]), (j, block[6:, 6:])):
            data[place] += part
        for place, part in ((i, form_i[:6]), (above, form_i[6:]), (below, form_j[:6]), (j, form_j[6:])):
            form[place] += part


def _by_rows(matrix: Stiffness) -> csr_array:
    """Return F by single rows, in the same memory."""
    assert matrix.forms is not None
    forms = matrix.forms
    columns = (6 * forms.indices[:, None] + np.arange(6, dtype=forms.indices.dtype)).ravel()
    return csr_array((forms.data.reshape(-1), columns, 6 * forms.indptr), shape=forms.shape, copy=False)


def facet_stiffness(
    arms: tuple[Floats, Floats], D: Floats, H: Floats, shares: tuple[Floats, Floats]
) -> tuple[Floats, Floats, Floats]:
    """Return the stiffness of a facet for motions (u, φ) of its two cells, (12, 12), and its part in V θ, (12,) each.

    Args:
        arms: arms from the centre of either cell to the facet [m], (3,).
        D: force over the gap [N/m], (3, 3).
        H: moment over the relative rotation [N·m], (3, 3).
        shares: V θ of either cell over the gap [m²], (3,).
    """
    gap = np.hstack([-np.eye(3), _crossed(arms[0]), np.eye(3), -_crossed(arms[1])])
    turn = np.zeros((3, 12))
    turn[:, 3:6], turn[:, 9:] = -np.eye(3), np.eye(3)
    return gap.T @ D @ gap + turn.T @ H @ turn, shares[0] @ gap, shares[1] @ gap


def _crossed(b: Floats) -> Floats:
    """Return [b]× with [b]× v = b × v."""
    return np.array([[0.0, -b[2], b[1]], [b[2], 0.0, -b[0]], [-b[1], b[0], 0.0]])
