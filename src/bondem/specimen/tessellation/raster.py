"""Grids for centres of mass, so that levers between centres and facets are whole multiples of a pitch.

The state of a body at rest depends on differences of lengths that cancel. On a grid they cancel to the last bit, and
levers fit into 32 bits: the loops of a step read half as much.
"""

import numpy as np

from bondem._types import Floats, PerElement3

# Numbers of bits of the ratio of a length to the pitch: for levers, which have 32 bits with their sign; for centres,
# whose grid is coarser, so that the grid of the levers contains it.
LEVER_BITS, CENTRE_BITS = 30, 28


def pitch(length: float, period: Floats | None, bits: int) -> Floats:
    """Return the pitch along x, y, z [m], (3,), of the finest grid on which `length` [m] is at most 2^bits pitches.

    Pitches are powers of two, or edges of the periodic cell over powers of two. The finer of two grids therefore
    has all points of the coarser one.
    """
    whole = np.ones(3) if period is None else np.asarray(period, dtype=float)
    return np.asarray(whole * 2.0 ** (np.ceil(np.log2(length / whole)) - bits), dtype=float)


def on_raster(position: PerElement3, pitch: Floats) -> PerElement3:
    """Return positions [m], (n, 3), rounded to the nearest points of a grid."""
    return np.asarray(np.rint(position / pitch) * pitch, dtype=float)
