"""Passes that Python calls, of `core/passes/non_local/element_stresses.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.step_tables import LaggedStresses, Poses


def turn_all_stresses(poses: Poses, lagged_stresses: LaggedStresses) -> Call:
    """Turns the stresses of all elements in given poses."""
    return Call("turn_all_stresses", (poses, lagged_stresses))
