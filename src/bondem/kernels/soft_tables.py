"""The table of beams that soften, as kernels take it."""

from typing import NamedTuple

import numpy as np

# Columns of a beam that has begun to soften: which, its opening λ then and where nothing is left [√J], -∂U/∂s a step
# ago [J], energy dissipated [J], what of it was the larger part of the index.
SOFT_BOND, FIRST, LAST, RATE, SPENT, MODE = range(6)
SOFT_COLUMNS = 6
# How many there are: beams that have begun, and those that were looked at in the last step.
BEGUN, LOOKED_AT = range(2)
# Columns of what one does in a step: force on its second end [N], energy dissipated [J], and 1 where it has broken.
PUSH, LOST, PARTS = 0, 3, 4
SOFT_OUTPUT_COLUMNS = 5


class SoftBonds(NamedTuple):
    """Beams that soften, m beams, n elements; kernels write all but the first three."""

    tear: np.ndarray  #: G_f A [J], (m,)
    shear: np.ndarray  #: G_II A [J], (m,)
    handed: bool  #: whether a contact bears what presses on a beam that has broken
    row: np.ndarray  #: beams in the order in which they began, (m, 6)
    sizes: np.ndarray  #: of the lists (`BEGUN` …), (2,)
    active: np.ndarray  #: rows that are looked at, in that order, (m,)
    output: np.ndarray  #: of each row, (m, 5)
    load: np.ndarray  #: force and torque of contacts and of these on each element [N, N·m], (n, 6)
