"""Sums over the bonds or facets of each element: rows of tables with these sums, and products of vectors for them."""

import numpy as np

from bondem._tables.step_tables import StepBlocks
from bondem._types import Floats, Ints, Uint32s
from bondem.specimen.ordering import Layout

# Rows and columns of the components xx, yy, zz, xy, xz, yz of a symmetric tensor.
_A, _B = [0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]


def row_sums(owner: Ints | Uint32s, rows: Floats, n: int) -> Floats:
    """Return the sums of rows (k, c) by owner, (n, c); `owner` is the number of the owner of each row, (k,)."""
    return np.stack([np.bincount(owner, weights=column, minlength=n) for column in rows.T], axis=1).astype(float)


def rows_of_ends(blocks: StepBlocks, layout: Layout) -> np.ndarray:
    """Return the row to which each bond adds for its element i, uint32, (m,), in a table with a row per element.

    Rows after those of the elements are contributions of bonds between domains, in the order of `blocks.part`.
    """
    i = layout.i
    row = blocks.row_i[: len(i)].astype(np.int64)
    return np.where(row < blocks.parts, i, len(layout.order) + row - blocks.parts).astype(np.uint32)


def symmetric_products(a: Floats, b: Floats) -> Floats:
    """Return the symmetric part of a⊗b of vectors (k, 3): xx, yy, zz, xy, xz, yz, (k, 6)."""
    return 0.5 * (a[:, _A] * b[:, _B] + a[:, _B] * b[:, _A])
