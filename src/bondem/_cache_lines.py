"""Arrays for the core: rows aligned with cache lines, and exact sums."""

import numpy as np

from bondem._tables.columns import ExactWord
from bondem._types import Floats, Ints


def lines(n: int) -> Floats:
    """Return zeros, (n, 8), aligned so that each row fills exactly one cache line."""
    room = np.zeros(8 * n + 8)
    first = -room.ctypes.data % 64 // 8
    return room[first : first + 8 * n].reshape(n, 8)


def exact_sums(count: int = 1) -> Ints:
    """Return `count` exact sums (`core/exact_sum.hpp`) of value zero, as rows of words."""
    return np.zeros((count, ExactWord.COUNT), dtype=np.int64)
