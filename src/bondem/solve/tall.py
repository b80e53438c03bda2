"""Products with tall thin matrices, such as the few vectors of an eigenvalue iteration.

They are cut into pieces that BLAS leaves to one thread: results then do not depend on the number of threads,
and BLAS's threads do not compete with those of the kernels, which costs far more than it gains.
"""

import numpy as np

from bondem._types import Floats

# OpenBLAS threads a product of more than 2^18 multiplications.
_SERIAL = 1 << 18


def _pieces(matrix: Floats, length: int) -> tuple[Floats, Floats]:
    """A (rows, k) matrix as equal pieces (count, length, k) and the rest."""
    rows, width = matrix.shape
    whole = rows - rows % length
    return matrix[:whole].reshape(rows // length, length, width), matrix[whole:]


def _length(p: int, q: int) -> int:
    return max(_SERIAL // max(p * q, 1), 1)


def gram(a: Floats, b: Floats) -> Floats:
    """aᵀ b for a (rows, p), b (rows, q)."""
    length = _length(a.shape[1], b.shape[1])
    (p, p_rest), (q, q_rest) = _pieces(a, length), _pieces(b, length)
    return (np.swapaxes(p, 1, 2) @ q).sum(axis=0) + p_rest.T @ q_rest


def combine(a: Floats, turn: Floats) -> Floats:
    """a @ turn for a (rows, p), turn (p, q)."""
    pieces, rest = _pieces(a, _length(*turn.shape))
    result = np.empty((len(a), turn.shape[1]))
    whole = len(a) - len(rest)
    np.matmul(pieces, turn, out=result[:whole].reshape(*pieces.shape[:2], turn.shape[1]))
    result[whole:] = rest @ turn
    return result


def dot(a: Floats, b: Floats) -> float:
    """a·b of two vectors."""
    return float(np.einsum("i,i->", a, b))
