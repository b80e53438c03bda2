"""Passes that Python calls, of `core/passes/non_local/pair_failure.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.damage_tables import FailureIndices, Strengths
from bondem._tables.step_tables import Beams, LaggedStresses


def index_pairs(
    beams: Beams, lagged_stresses: LaggedStresses, strengths: Strengths, failure_indices: FailureIndices
) -> Call:
    """Finds the index of the criterion of every bond from the stresses in space."""
    return Call("index_pairs", (beams, lagged_stresses, strengths, failure_indices))
