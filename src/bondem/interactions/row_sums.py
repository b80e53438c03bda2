"""Sums of the rows of a table by the element that owns each, and products that enter such sums."""

import numpy as np

from bondem._types import Floats, Ints, Uint32s

# Rows and columns of the components xx, yy, zz, xy, xz, yz of a symmetric tensor.
_A, _B = [0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]


def row_sums(owner: Ints | Uint32s, rows: Floats, n: int) -> Floats:
    """Return the sum of the rows (k, c) of each of n owners, (n, c), in the order of the rows."""
    return np.stack([np.bincount(owner, weights=column, minlength=n) for column in rows.T], axis=1).astype(float)


def symmetric_products(a: Floats, b: Floats) -> Floats:
    """Return the symmetric part of a⊗b of vectors (k, 3): xx, yy, zz, xy, xz, yz, (k, 6)."""
    return 0.5 * (a[:, _A] * b[:, _B] + a[:, _B] * b[:, _A])
