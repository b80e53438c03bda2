"""Tables of a device in addition to those of a step, as `core/tables/device_tables.hpp` declares them."""

import numpy as np

from bondem._tables.device_tables import RowOrder
from bondem._types import Ints, Uint32s


def new_row_order(row: Ints | Uint32s, rows: int) -> RowOrder:
    """Return the order of loads or walls on some rows."""
    counts = np.bincount(row, minlength=rows)
    start = np.concatenate([[0], np.cumsum(counts)]).astype(np.int64)
    return RowOrder(start, np.argsort(row, kind="stable").astype(np.int64))
