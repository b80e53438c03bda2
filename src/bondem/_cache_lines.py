"""Arrays of rows that the core reads as a whole: lines of the cache, and sums without rounding."""

import numpy as np

from bondem._tables.columns import ExactWord
from bondem._types import Floats, Ints


def lines(n: int) -> Floats:
    """Return zeros, (n, 8), aligned so that a row is one cache line and not the halves of two."""
    room = np.zeros(8 * n + 8)
    first = -room.ctypes.data % 64 // 8
    return room[first : first + 8 * n].reshape(n, 8)


def exact_sums(count: int = 1) -> Ints:
    """Return empty sums, a row each (`core/exact_sum.hpp`)."""
    return np.zeros((count, ExactWord.COUNT), dtype=np.int64)
