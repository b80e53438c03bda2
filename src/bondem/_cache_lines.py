"""Arrays of which each row is one cache line."""

import numpy as np

from bondem._types import Floats


def lines(n: int) -> Floats:
    """Return zeros, (n, 8), aligned so that a row is one cache line and not the halves of two."""
    room = np.zeros(8 * n + 8)
    first = -room.ctypes.data % 64 // 8
    return room[first : first + 8 * n].reshape(n, 8)
