"""Construction of tables that only a device needs, declared in `core/tables/device_tables.hpp`."""

import numpy as np

from bondem._tables.device_tables import RowOrder
from bondem._types import Ints, Uint32s


def new_row_order(row: Ints | Uint32s, rows: int) -> RowOrder:
    """Return the loads or walls sorted by the row on which each acts, given these rows and their number."""
    counts = np.bincount(row, minlength=rows)
    start = np.concatenate([[0], np.cumsum(counts)]).astype(np.int64)
    return RowOrder(start, np.argsort(row, kind="stable").astype(np.int64))
