"""Lowest eigenvalues by Lanczos iteration with a given inverse of the matrix."""

from collections.abc import Callable

import numpy as np
from scipy.sparse import csc_array, csr_array
from scipy.sparse.linalg import LinearOperator, eigsh

from bondem._types import Floats


def lowest_modes(
    matrix: csc_array | LinearOperator, inverse: Callable[[Floats], Floats], start: Floats, *,
    mass: csc_array | csr_array | None = None, count: int, tolerance: float,
) -> tuple[Floats, Floats]:  # fmt: skip
    """Return the lowest eigenvalues, ascending (count,), and vectors (rows, count) of matrix x = λ mass x.

    Args:
        matrix: symmetric matrix.
        inverse: function that returns x with matrix x = b for a vector b; directions that it never returns are left
            out.
        start: initial vector, (rows,).
        mass: symmetric, positive semi-definite matrix; None for the unit matrix.
        count: number of eigenvalues.
        tolerance: relative error of the eigenvalues; 0 for the precision of the machine.
    """
    solve = LinearOperator((len(start), len(start)), matvec=inverse, dtype=float)
    values, vectors = eigsh(
        matrix, k=count, M=mass, sigma=0.0, OPinv=solve, v0=start, tol=tolerance, return_eigenvectors=True
    )
    order = np.argsort(values)
    return values[order], vectors[:, order]
