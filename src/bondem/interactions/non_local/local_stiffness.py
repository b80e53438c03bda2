"""Stiffness matrix of the springs of the non-local law at rest."""

import numpy as np
from scipy.sparse import bsr_array

from bondem._indices import group_starts
from bondem._types import Floats
from bondem.interactions.non_local.non_local_constants import NonLocalConstants
from bondem.interactions.row_sums import row_sums
from bondem.specimen.ordering import Layout


def local_stiffness(constants: NonLocalConstants, layout: Layout) -> bsr_array:
    """Return the second derivative of ½ kn δ_n² + ½ kt |δ_t|², 6×6 blocks of (u, θ), internal order, (6 n, 6 n)."""
    n, m = len(layout.order), len(layout.i)
    P = constants.normal[:, :, None] * constants.normal[:, None, :] * (constants.kn - constants.kt)[:, None, None]
    P += constants.kt[:, None, None] * np.eye(3)
    # δ = B (u, θ) of each end, with its sign
    B = np.zeros((2, m, 3, 6))
    for end, (lever, sign) in enumerate(((constants.lever_i, -1.0), (constants.lever_j, 1.0))):
        B[end, :, :, :3] = sign * np.eye(3)
        B[end, :, :, 3:] = -sign * _crossing(lever)
    ends = np.stack([layout.i, layout.j]).astype(np.int64)
    PB = P @ B
    diagonal = np.zeros((n, 6, 6))
    for end in range(2):
        own = np.swapaxes(B[end], 1, 2) @ PB[end]
        diagonal += row_sums(ends[end], own.reshape(m, 36), n).reshape(n, 6, 6)
    beside = np.swapaxes(B[0], 1, 2) @ PB[1]
    row = np.concatenate([np.arange(n), ends[0], ends[1]])
    column = np.concatenate([np.arange(n), ends[1], ends[0]])
    blocks = np.concatenate([diagonal, beside, np.swapaxes(beside, 1, 2)])
    order = np.lexsort((column, row))
    indptr, indices = group_starts(row, n).astype(np.int32), column[order].astype(np.int32)
    return bsr_array((blocks[order], indices, indptr), shape=(6 * n, 6 * n))


def _crossing(lever: Floats) -> Floats:
    """Return [b]× with [b]× v = b × v, (m, 3, 3)."""
    cross = np.zeros((len(lever), 3, 3))
    cross[:, 0, 1], cross[:, 0, 2], cross[:, 1, 2] = -lever[:, 2], lever[:, 1], -lever[:, 0]
    return cross - np.swapaxes(cross, 1, 2)
