"""Stiffness of a model at rest, by its bonds and by the dilatation of its cells."""

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from scipy.sparse import bsr_array, csc_array, csr_array, dia_array

from bondem._tables.stiffness_tables import BlockRows
from bondem._types import Floats
from bondem.specimen.ordering import Layout


@dataclass(frozen=True, eq=False)
class Stiffness:
    """The matrix K = B + Fᵀ (W + S) F + Tᵀ T, with degrees of freedom (u, θ) per element.

    B contains the bonds, each of which couples two elements. The dilatation of a cell couples all its neighbours with
    each other. An explicit matrix would have four times as many blocks, so that the other terms remain products.

    Attributes:
        bonds: B, 6×6 blocks, with a diagonal block in every row, (6 n, 6 n).
        forms: F, volume change V θ of each cell by unit motions [m², m³], 1×6 blocks, (n, 6 n), or None.
        weight: W, λ / V of each cell [Pa/m³], (n,), or (0,).
        spread: S, springs between the dilatations of neighbouring cells [Pa/m³], (n, n), or None.
        turns: T, bending of layers one cell thick, 1×6 blocks, (2 n, 6 n), or None.
    """

    bonds: bsr_array
    forms: bsr_array | None = None
    weight: Floats = field(default_factory=lambda: np.zeros(0))
    spread: csr_array | None = None
    turns: bsr_array | None = None

    @property
    def shape(self) -> tuple[int, int]:
        """Shape (6 n, 6 n)."""
        size = 6 * (len(self.bonds.indptr) - 1)
        return size, size

    @property
    def neighbours(self) -> int:
        """Number of off-diagonal blocks; each pair of elements counts twice."""
        return len(self.bonds.indices) - self.shape[0] // 6

    @cached_property
    def _rows(self) -> tuple[csr_array, csr_array]:
        assert self.forms is not None
        rows = csr_array(self.forms.tocsr())
        return rows, csr_array(rows.T.tocsr())

    @property
    def _weights(self) -> dia_array | csr_array:
        own = dia_array((self.weight[None], [0]), shape=(len(self.weight),) * 2)
        return own if self.spread is None else csr_array(own + self.spread)

    def __matmul__(self, motion: Floats) -> Floats:
        """Return K u of motions (6 n,) or (6 n, k)."""
        force = self.bonds @ motion
        if self.forms is None:
            return force
        rows, columns = self._rows
        weight = self.weight if motion.ndim == 1 else self.weight[:, None]
        swelling = rows @ motion
        stress = weight * swelling
        if self.spread is not None:
            stress += self.spread @ swelling
        force += columns @ stress
        if self.turns is not None:
            force += self.turns.T @ (self.turns @ motion)
        return np.asarray(force, dtype=float)

    def diagonal_blocks(self) -> Floats:
        """Return the diagonal blocks of K without S, (n, 6, 6)."""
        n = self.shape[0] // 6
        row = np.repeat(np.arange(n), np.diff(self.bonds.indptr))
        blocks = self.bonds.data[self.bonds.indices == row]
        if self.forms is None:
            return np.asarray(blocks, dtype=float)
        blocks = blocks + _squares(self.forms, self.weight)
        if self.turns is not None:
            blocks += _squares(self.turns, np.ones(2 * n))
        return np.asarray(blocks, dtype=float)

    def scaled(self, root: Floats) -> "Stiffness":
        """Return Rᵀ K R with the block-diagonal matrix R of the blocks `root` of the elements, (n, 6, 6)."""
        B, F = self.bonds, self.forms
        row = np.repeat(np.arange(len(root)), np.diff(B.indptr))
        turned = np.swapaxes(root, 1, 2)
        bonds = bsr_array((turned[row] @ B.data @ root[B.indices], B.indices, B.indptr), shape=B.shape)
        if F is None:
            return Stiffness(bonds)
        turns = None if self.turns is None else _by_columns(self.turns, root)
        return Stiffness(bonds, _by_columns(F, root), self.weight, self.spread, turns)

    def projected(self, basis: bsr_array) -> csc_array:
        """Return Pᵀ K P of a basis P, (6 n, k)."""
        coarse = csc_array((basis.T @ (self.bonds @ basis)).tocsc())
        if self.forms is None:
            return coarse
        forms = csr_array(csr_array(self.forms.tocsr()) @ csr_array(basis.tocsr()))
        coarse = csc_array(coarse + forms.T @ (self._weights @ forms))
        if self.turns is None:
            return coarse
        turns = csr_array(csr_array(self.turns.tocsr()) @ csr_array(basis.tocsr()))
        return csc_array(coarse + turns.T @ turns)

    def tocsc(self) -> csc_array:
        """Return K as one matrix."""
        whole = csc_array(self.bonds.tocsc())
        if self.forms is None:
            return whole
        rows, columns = self._rows
        whole = csc_array(whole + columns @ (self._weights @ rows))
        if self.turns is None:
            return whole
        turns = csr_array(self.turns.tocsr())
        return csc_array(whole + turns.T @ turns)


def _squares(forms: bsr_array, weight: Floats) -> Floats:
    """Return Σ weight f⊗f over the rows of forms, for each element, (n, 6, 6)."""
    form, n = forms.data[:, 0], forms.shape[1] // 6
    weighted = np.repeat(weight, np.diff(forms.indptr))[:, None] * form
    found = np.zeros((n, 6, 6))
    order = np.argsort(forms.indices, kind="stable")
    element, start = np.unique(forms.indices[order], return_index=True)
    if len(element):
        found[element] = np.add.reduceat(weighted[order][:, :, None] * form[order][:, None, :], start)
    return found


def _by_columns(forms: bsr_array, root: Floats) -> bsr_array:
    """Multiply `forms` from the right by the block-diagonal matrix of blocks `root` of the elements, (n, 6, 6)."""
    return bsr_array((forms.data @ root[forms.indices], forms.indices, forms.indptr), shape=forms.shape)


def new_block_rows(layout: Layout) -> BlockRows:
    """Return empty rows of 6×6 blocks for the matrix of a layout, with their columns to be filled."""
    n = len(layout.out_start) - 1
    indptr = (layout.in_start + layout.out_start + np.arange(n + 1)).astype(np.int32)
    indices, data = np.empty(indptr[-1], np.int32), np.empty((indptr[-1], 6, 6))
    return BlockRows(layout.in_start, layout.out_start, layout.out_bond, indptr, indices, data)
