"""Construction of tables that only a device needs, declared in `core/tables/device_tables.hpp`."""

import numpy as np

from bondem._tables.device_tables import RowOrder
from bondem._types import Ints, Uint32s
from bondem.specimen.ordering import starts


def new_row_order(row: Ints | Uint32s, rows: int) -> RowOrder:
    """Return the loads or walls sorted by the row on which each acts, given these rows and their number."""
    return RowOrder(starts(row, rows), np.argsort(row, kind="stable").astype(np.int64))
