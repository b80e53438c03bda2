"""Conjugate gradients in the core, for a body whose facets lose integrity.

`core/tables/quasistatic_tables.hpp` declares types and shapes.
"""

import numpy as np
from scipy.linalg import cholesky_banded
from scipy.sparse import coo_array
from scipy.sparse.csgraph import reverse_cuthill_mckee

from bondem._core import bound_pass
from bondem._indices import inverse
from bondem._passes import calls
from bondem._tables.quasistatic_tables import ClumpCorrection, ConjugateGradients, ScaledMatrix
from bondem._types import Floats
from bondem.statics.linear import Iteration
from bondem.statics.quasistatic.facet_matrix import FacetMatrix

# Largest number of rounds of conjugate gradients.
_ROUNDS = 5000


def new_clump_correction(iteration: Iteration) -> ClumpCorrection:
    """Return the table of the coarse correction of an iteration, with a banded Cholesky factor of its matrix."""
    clumps = iteration.coarse
    matrix = coo_array(clumps.regular)
    sequence = reverse_cuthill_mckee(clumps.regular.tocsr(), symmetric_mode=True)
    order = inverse(sequence)
    row, column = order[matrix.row], order[matrix.col]
    low = row >= column
    band = np.zeros((int((row - column).max()) + 1, len(order)))
    band[(row - column)[low], column[low]] = matrix.data[low]
    factor = np.ascontiguousarray(cholesky_banded(band, lower=True, overwrite_ab=True).T)
    basis = clumps.prolongation
    return ClumpCorrection(
        6 * basis.indices.astype(np.int64), order, basis.data, factor, np.ascontiguousarray(iteration.rigid.T),
        np.zeros(len(order)),
    )  # fmt: skip


class GradientSolver:
    """Conjugate gradients with one preconditioner, and with the present values of a matrix that changes in place.

    Attributes:
        rounds: number of rounds of the last solution.
        first: residual times preconditioned residual of the last guess, about twice the energy of its error.
    """

    def __init__(self, body: FacetMatrix, iteration: Iteration) -> None:
        """Make the tables of the scaled matrix of a body, and of the coarse correction of an iteration."""
        matrix = body.scaled
        assert matrix.forms is not None
        bonds, n = matrix.bonds, len(matrix.weight)
        row = np.repeat(np.arange(n), np.diff(bonds.indptr))
        scaled = ScaledMatrix(
            bonds.indptr.astype(np.int64), bonds.indices.astype(np.int64), np.flatnonzero(bonds.indices == row),
            bonds.data, matrix.forms.data[:, 0], *body.rounded, matrix.weight,
        )  # fmt: skip
        self._search = ConjugateGradients(
            np.zeros(2), _ROUNDS, np.zeros(6 * n), np.zeros(6 * n), np.zeros((4, 6 * n)), np.zeros(n),
            np.zeros(1, dtype=np.int64), np.zeros(1),
        )  # fmt: skip
        self._solve = bound_pass(calls.conjugate_gradients(scaled, new_clump_correction(iteration), self._search))
        self.rounds, self.first = 0, 0.0

    def solve(self, right: Floats, guess: Floats, *, stop: float, energy: float) -> Floats | None:
        """Return x with |f - K x| <= `stop` or r·z <= `energy`, (6 n,); None if the iteration does not converge.

        Args:
            right: right-hand side f in scaled unknowns, (6 n,).
            guess: initial x, (6 n,).
            stop: residual at which the iteration ends.
            energy: r·z at which it ends, residual times preconditioned residual, about twice the energy of the error.
        """
        search = self._search
        search.limits[:] = stop, energy
        search.residual[:], search.found[:] = right, guess
        ended = self._solve()
        self.rounds, self.first = int(search.rounds[0]), float(search.first[0])
        return search.found.copy() if ended == "converged" else None
