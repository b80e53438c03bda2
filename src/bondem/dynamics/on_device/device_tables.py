"""Tables of a device beside those of a step, as `core/tables/device_tables.hpp` declares them."""

import numpy as np

from bondem._tables.device_tables import RowOrder
from bondem._types import Ints, Uint32s


def new_row_order(row: Ints | Uint32s, rows: int) -> RowOrder:
    """Return the order of loads or walls on some rows."""
    counts = np.bincount(row, minlength=rows)
    start = np.concatenate([[0], np.cumsum(counts)]).astype(np.int64)
    return RowOrder(start, np.argsort(row, kind="stable").astype(np.int64))


#: Columns of sums, as in `core/gpu/record.hpp`: energies of elements and of bonds, bonds turned too far and numbers
#: that are not finite, works.
SUM_COLUMNS = (
    "translation", "rotation", "damped", "rubbed", "normal", "shear", "bending", "twisting", "wide", "lost",
    "not_finite", "work", "supplied",
)  # fmt: skip
#: Columns behind them in a record: energies of contacts, of non-local stresses, that bonds released, of plasticity,
#: and of the released energy that of crushing; work of walls.
FURTHER_COLUMNS = ("contact", "non_local", "released", "plastic", "crushing", "walls")
#: Portions of a group, and works or walls of a portion.
GROUP, WORKS = 64, 1024
