"""Empty table for the energy balance of a run."""

import numpy as np

from bondem._cache_lines import exact_sums
from bondem._tables.columns import HistoryColumn
from bondem._tables.step_tables import Ledger


def new_ledger() -> Ledger:
    """Return a table of the energy balance with all sums zero."""
    counts = np.zeros(3, dtype=np.int64), np.zeros(4, dtype=np.int64)
    return Ledger(exact_sums(HistoryColumn.COUNT), counts[0], np.zeros(2), counts[1])
