"""Room for the sums of a step over portions of elements and of bonds."""

import numpy as np

from bondem._tables.step_tables import Portions

# Elements and bonds of a portion, as in `core/steps.hpp`.
_ELEMENTS, BONDS_OF_PORTION = 1024, 2048


def new_portions(n: int, m: int) -> Portions:
    """Return room for the portions of n elements and m bonds."""
    element, bond = -(-n // _ELEMENTS), -(-m // BONDS_OF_PORTION)
    return Portions(
        np.zeros((element, 4)), np.zeros((bond, 4)), np.zeros((bond, 3), dtype=np.int64), np.zeros(3),
        np.zeros(4, dtype=np.int64),
    )  # fmt: skip
