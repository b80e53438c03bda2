"""Room for the sums of a step over portions of elements and of bonds."""

import numpy as np

from bondem._tables.columns import BONDS_OF_PORTION, ELEMENTS_OF_PORTION
from bondem._tables.step_tables import Portions


def new_portions(n: int, m: int) -> Portions:
    """Return room for the portions of n elements and m bonds."""
    element, bond = -(-n // ELEMENTS_OF_PORTION), -(-m // BONDS_OF_PORTION)
    return Portions(
        np.zeros((element, 4)), np.zeros((bond, 4)), np.zeros((bond, 3), dtype=np.int64), np.zeros(3),
        np.zeros(4, dtype=np.int64),
    )  # fmt: skip
