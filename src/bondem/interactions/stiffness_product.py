"""Products K u of a stiffness and small motions, from derivatives of the forces that are exact to rounding."""

from collections.abc import Callable

import numpy as np

from bondem._cache_lines import lines
from bondem._core import bound_pass
from bondem._passes import Call
from bondem._tables.stiffness_tables import StiffnessProduct
from bondem._types import Floats, PerElement6

#: Function that returns K u of small motions u [m, rad], (n, 6): [N, N·m], (n, 6).
Product = Callable[[PerElement6], PerElement6]


def product_by(n: int, call: Callable[[StiffnessProduct], Call]) -> Product:
    """Return the product function that evaluates a pass over n elements, given its call with tables."""
    by = StiffnessProduct(np.zeros((n, 6)), np.zeros((n, 6)), lines(n), lines(n))
    multiply = bound_pass(call(by))

    def product(motion: PerElement6) -> PerElement6:
        by.given[:] = motion
        multiply()
        return by.found.copy()

    return product


def loads_in(sums: Floats) -> PerElement6:
    """Return force and torque [N, N·m], (n, 6), from rows of sums, (n, 8)."""
    return sums[:, [0, 1, 2, 4, 5, 6]]
