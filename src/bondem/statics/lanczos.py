"""Lowest eigenvalues by Lanczos iteration with a given inverse of the matrix."""

from collections.abc import Callable

import numpy as np
from scipy.sparse import csc_array
from scipy.sparse.linalg import LinearOperator, eigsh

from bondem._types import Floats


class _Inverse(LinearOperator):
    def __init__(self, size: int, inverse: Callable[[Floats], Floats]) -> None:
        self._inverse = inverse
        super().__init__(np.dtype(float), (size, size))

    def _matvec(self, x: Floats) -> Floats:
        return self._inverse(x)


def lowest_modes(
    matrix: csc_array,
    inverse: Callable[[Floats], Floats],
    start: Floats,
    *,
    mass: csc_array | None = None,
    count: int,
    tolerance: float,
) -> tuple[Floats, Floats]:
    """Return the lowest eigenvalues, ascending (count,), and vectors (rows, count) of matrix x = λ mass x.

    Args:
        matrix: symmetric matrix.
        inverse: function that returns x with matrix x = b for a vector b; directions that it never returns are left
            out.
        start: initial vector, (rows,).
        mass: symmetric, positive semi-definite matrix; None for the unit matrix.
        count: number of eigenvalues.
        tolerance: relative error of the eigenvalues.
    """
    values, vectors = eigsh(
        matrix, k=count, M=mass, sigma=0.0, OPinv=_Inverse(len(start), inverse), v0=start,
        tol=tolerance,
        return_eigenvectors=True,
    )  # fmt: skip
    order = np.argsort(values)
    return values[order], vectors[:, order]
