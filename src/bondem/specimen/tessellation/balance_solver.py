"""Solution of the equations of the balanced shares: symmetric tensors Y of the cells, by conjugate gradients.

The operator is N Y = Σ sym((Y_p - Y_q) b ⊗ b) over the facets of cell p, a Laplacian of tensors on the graph of the
cells. b is the vector to the neighbour q, scaled as in `CellBranches`. The average over all directions of b is the
scalar Laplacian of weights |b|² / 3 for each component. The preconditioner is the inverse of its diagonal, plus the
inverse of this Laplacian between groups of neighbouring cells, which reduces errors of long wavelength.
"""

import numpy as np
from scipy.sparse import csc_array, dia_array
from scipy.sparse.linalg import LinearOperator, cg, splu

from bondem._blas import one_blas_thread
from bondem._core import run_pass
from bondem._indices import components, group_starts, inverse
from bondem._passes import calls
from bondem._tables.tessellation_tables import BalanceField, CellBranches
from bondem._threads import current_threads
from bondem._types import Floats, Pairs, PerBond, PerBond3, PerElement3
from bondem.geometry.morton import morton_order

# Largest number of iterations; bodies of 1e5 cells take about 130.
_MOST = 2000
# Number of cells in a group, and addition to the diagonal of the singular matrix of groups, over its mean.
_GROUP, _FREE = 32, 1e-8
# Share of the diagonal that is added to N, because rounding errors of the right-hand side in the null space of N
# would make the iteration diverge.
_RESISTED = 1e-11
#: Components of a symmetric tensor in the order of the core, and their scale in rows: √2 off the diagonal.
ROW, COLUMN = np.array([0, 1, 2, 0, 0, 1]), np.array([0, 1, 2, 1, 2, 2])
SCALE = np.where(ROW == COLUMN, 1.0, np.sqrt(2.0))


@one_blas_thread
def solved_balance(position: PerElement3, pairs: Pairs, branch: PerBond3, right: Floats, most: float) -> Floats:
    """Return the symmetric tensors Y that solve Σ sym((Y_p - Y_q) b ⊗ b) = `right` over the facets of each cell p.

    Tensors are rows xx, yy, zz, xy, xz, yz, (n, 6), with the last three times √2.

    Args:
        position: centres of the cells [m], (n, 3).
        pairs: cells of each facet, (m, 2).
        branch: b of each facet [m^1.5], (m, 3).
        right: right-hand sides [m³], (n, 6).
        most: norm of the remainder at which the iteration ends [m³].
    """
    n = len(position)
    order = morton_order(position)
    rank = inverse(order)
    ends = rank[pairs]
    branches = _of_cells(n, ends, branch)
    weight = (branch**2).sum(axis=1) / 3.0
    diagonal = np.asarray(np.bincount(ends[:, 0], weight, n) + np.bincount(ends[:, 1], weight, n), dtype=float)
    right, found = _without_means(right[order], ends), np.empty((n, 6))

    def applied(given: Floats) -> Floats:
        run_pass(calls.apply_balance(branches, BalanceField(given.reshape(n, 6), found)), threads=current_threads())
        return (found + _RESISTED * diagonal[:, None] * given.reshape(n, 6)).ravel()

    shape = (6 * n, 6 * n)
    y, _ = cg(
        LinearOperator(shape, matvec=applied, dtype=float), right.ravel(), rtol=0.0, atol=most, maxiter=_MOST,
        M=_preconditioner(ends, weight, diagonal),
    )  # fmt: skip
    return np.asarray(y, dtype=float).reshape(n, 6)[rank]


def _of_cells(n: int, ends: Pairs, branch: PerBond3) -> CellBranches:
    """Return neighbour and branch of each facet, cell by cell; facets of which a cell is the second come last."""
    near, far = ends.ravel(order="F"), ends[:, ::-1].ravel(order="F")
    order = np.argsort(near, kind="stable")
    both = np.concatenate([branch, branch])[order]
    return CellBranches(group_starts(near, n), far[order].astype(np.uint32), np.ascontiguousarray(both))


def _without_means(right: Floats, ends: Pairs) -> Floats:
    """Return right-hand sides, less their mean over each connected piece, which is a rounding error."""
    piece = components(ends, len(right))
    size = np.bincount(piece)
    return right - np.column_stack([(np.bincount(piece, column) / size)[piece] for column in right.T])


def _preconditioner(ends: Pairs, weight: PerBond, diagonal: Floats) -> LinearOperator:
    """Return the preconditioner: the inverse of `diagonal`, (n,), plus that of a Laplacian of groups of cells.

    The Laplacian has a `weight` per facet, a third of its squared branch vector of unit m^1.5 [m³], (m,).
    """
    n = len(diagonal)
    inverse = np.divide(1.0, diagonal, out=np.zeros(n), where=diagonal > 0.0)[:, None]
    begin = np.arange(0, n, _GROUP)
    groups = len(begin)
    a, b = (ends // _GROUP).T
    between = a != b
    a, b, weight = a[between], b[between], weight[between]
    half = csc_array((weight, (a, b)), shape=(groups, groups))
    both = half + half.T
    sums = np.asarray(both.sum(axis=0)).ravel()
    coarse = dia_array((sums[None] + _FREE * diagonal.mean(), [0]), shape=both.shape) - both
    solver = splu(csc_array(coarse))
    group = np.arange(n) // _GROUP

    def applied(residual: Floats) -> Floats:
        rows = residual.reshape(n, 6)
        return (inverse * rows + solver.solve(np.add.reduceat(rows, begin))[group]).ravel()

    return LinearOperator((6 * n, 6 * n), matvec=applied, dtype=float)
