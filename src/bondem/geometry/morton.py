"""Morton order (Z curve): points near in space are near in order, and so in memory."""

import numpy as np

from bondem._types import Floats, Ints

_BITS = 21


def morton_code(position: Floats) -> np.ndarray:
    """Return the place of each point (n, 3) along the Z-order curve through its bounding cube, uint64, shape (n,)."""
    lower = position.min(axis=0)
    extent = float(np.ptp(position, axis=0).max()) or 1.0
    cells = ((position - lower) / extent * (2**_BITS - 1)).astype(np.uint64)
    code = np.zeros(len(position), dtype=np.uint64)
    for axis in range(3):
        code |= _spread_bits(cells[:, axis]) << np.uint64(axis)
    return code


def morton_order(position: Floats) -> Ints:
    """Return the permutation that sorts points (n, 3) along the Z-order curve, (n,)."""
    return np.argsort(morton_code(position), kind="stable")


def _spread_bits(x: np.ndarray) -> np.ndarray:
    for shift, mask in (
        (32, 0x1F00000000FFFF),
        (16, 0x1F0000FF0000FF),
        (8, 0x100F00F00F00F00F),
        (4, 0x10C30C30C30C30C3),
        (2, 0x1249249249249249),
    ):
        x = (x | (x << np.uint64(shift))) & np.uint64(mask)
    return x
