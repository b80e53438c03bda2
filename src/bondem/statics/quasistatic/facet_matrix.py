"""Stiffness matrix of a body of cells, changed in place facet by facet."""

from dataclasses import replace

import numpy as np
from scipy.sparse import csr_array

from bondem._types import Floats, Ints
from bondem.interactions.stiffness import Stiffness
from bondem.specimen.ordering import Layout


class FacetMatrix:
    """Matrix K = B + Fᵀ W F of `Stiffness`, plain and scaled, in which single facets can change.

    F u are the volume changes V θ of the cells. The scaled matrix is Sᵀ K S, with a block S per element.

    Attributes:
        plain: K.
        scaled: Sᵀ K S.
        rounded: blocks of the scaled B and F in single precision, (b, 6, 6) and (b, 6).
    """

    def __init__(self, plain: Stiffness, layout: Layout, root: Floats) -> None:
        """Make the matrix from that of the whole body.

        Args:
            plain: matrix of the whole body, in internal order.
            layout: order of elements and bonds.
            root: scaling matrix S of each element, (n, 6, 6).
        """
        assert plain.forms is not None
        self.plain = replace(plain, weight=plain.weight.copy())
        self._i, self._j = layout.i.astype(np.int64), layout.j.astype(np.int64)
        diagonal, above, below = layout.blocks
        # (i, i), (i, j), (j, i) and (j, j) of each facet, (4, m)
        self._blocks = np.stack([diagonal[self._i], above, below, diagonal[self._j]])
        self._plain_rows = _by_rows(self.plain)
        self._plain_columns = self._plain_rows.T
        self.rescale(root)

    @property
    def sides(self) -> tuple[Ints, Ints]:
        """Cells on either side of each facet, (m,) each."""
        return self._i, self._j

    def rescale(self, root: Floats) -> None:
        """Replace the scaling matrices S of the elements, (n, 6, 6), and scale the matrix anew."""
        self._root = root
        self.scaled = self.plain.scaled(root)
        assert self.scaled.forms is not None
        bonds, forms = self.scaled.bonds.data, self.scaled.forms.data[:, 0]
        self.rounded = bonds.astype(np.float32), forms.astype(np.float32)

    def force(self, motion: Floats) -> Floats:
        """Return forces and torques K u [N, N·m] of motions [m, rad], (6 n,)."""
        weighted = self.plain.weight * (self._plain_rows @ motion)
        return np.asarray(self.plain.bonds @ motion, dtype=float) + self.swelling_force(weighted)

    def swelling_force(self, stress: Floats) -> Floats:
        """Return forces and torques [N, N·m], (6 n,), of the dilatation stresses λ θ of cells [Pa], (n,)."""
        return np.asarray(self._plain_columns @ stress, dtype=float)

    def add(self, facets: Ints, block: Floats, form_i: Floats, form_j: Floats) -> None:
        """Add contributions of some facets to the matrix.

        Args:
            facets: internal numbers, each once, (c,).
            block: additions to the stiffness of their two cells, (c, 12, 12).
            form_i, form_j: additions to the volume change of each cell, (c, 12).
        """
        turn = np.zeros((len(facets), 12, 12))
        turn[:, :6, :6], turn[:, 6:, 6:] = self._root[self._i[facets]], self._root[self._j[facets]]
        self._put(self.plain, facets, block, form_i, form_j)
        self.plain.__dict__.pop("_rows", None)  # cached rows of the forms, now out of date
        forms = ((form[:, None] @ turn)[:, 0] for form in (form_i, form_j))
        self._put(self.scaled, facets, np.swapaxes(turn, 1, 2) @ block @ turn, *forms)
        places = self._blocks[:, facets]
        assert self.scaled.forms is not None
        self.rounded[0][places] = self.scaled.bonds.data[places]
        self.rounded[1][places] = self.scaled.forms.data[places, 0]

    def _put(self, matrix: Stiffness, facets: Ints, block: Floats, form_i: Floats, form_j: Floats) -> None:
        assert matrix.forms is not None
        data, form, u, v = matrix.bonds.data, matrix.forms.data[:, 0], slice(6), slice(6, 12)
        ends = (u, u, form_i), (u, v, form_i), (v, u, form_j), (v, v, form_j)
        for place, (rows, columns, own) in zip(self._blocks[:, facets], ends, strict=True):
            np.add.at(data, place, block[:, rows, columns])
            np.add.at(form, place, own[:, columns])


def _by_rows(matrix: Stiffness) -> csr_array:
    """Return the matrix F of `FacetMatrix` by single rows, in the memory of its blocks."""
    assert matrix.forms is not None
    forms = matrix.forms
    columns = (6 * forms.indices[:, None] + np.arange(6, dtype=forms.indices.dtype)).ravel()
    return csr_array((forms.data.reshape(-1), columns, 6 * forms.indptr), shape=forms.shape, copy=False)


def facet_stiffness(
    arms: tuple[Floats, Floats], D: Floats, H: Floats, shares: tuple[Floats, Floats]
) -> tuple[Floats, Floats, Floats]:
    """Return the stiffness of facets, and their part in volume changes, for motions (u, φ) of their two cells.

    Args:
        arms: arms from the centre of either cell to the facets [m], (c, 3).
        D: force over the gap [N/m], (c, 3, 3).
        H: moment over the relative rotation [N·m], (c, 3, 3).
        shares: volume change of either cell over the gap [m²], (c, 3).

    Returns:
        Stiffness, (c, 12, 12), and the volume change of either cell under unit motions, (c, 12) each.
    """
    gap = np.zeros((len(D), 3, 12))
    gap[:, :, :3], gap[:, :, 6:9] = -np.eye(3), np.eye(3)
    gap[:, :, 3:6], gap[:, :, 9:] = _crossed(arms[0]), -_crossed(arms[1])
    block = np.swapaxes(gap, 1, 2) @ D @ gap
    own, other = slice(3, 6), slice(9, 12)
    for rows, columns, sign in ((own, own, 1.0), (other, other, 1.0), (own, other, -1.0), (other, own, -1.0)):
        block[:, rows, columns] += sign * H
    return block, (shares[0][:, None] @ gap)[:, 0], (shares[1][:, None] @ gap)[:, 0]


def _crossed(b: Floats) -> Floats:
    """Return [b]× with [b]× v = b × v, (c, 3, 3)."""
    found = np.zeros((len(b), 3, 3))
    for row, column, component in ((2, 1, 0), (0, 2, 1), (1, 0, 2)):
        found[:, row, column], found[:, column, row] = b[:, component], -b[:, component]
    return found
