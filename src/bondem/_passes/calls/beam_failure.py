"""Passes that Python calls, of `core/passes/damage/beam_failure.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.damage_tables import FailureIndices, Strengths
from bondem._tables.step_tables import Beams, Poses


def index_beams_by_elliptic(
    poses: Poses, beams: Beams, strengths: Strengths, failure_indices: FailureIndices
) -> Call:
    """Finds the index of every beam by a criterion in given poses, as many at once as there are lanes."""
    return Call("index_beams_by_elliptic", (poses, beams, strengths, failure_indices))


def index_beams_by_linear_sum(
    poses: Poses, beams: Beams, strengths: Strengths, failure_indices: FailureIndices
) -> Call:
    """Finds the index of every beam by a criterion in given poses, as many at once as there are lanes."""
    return Call("index_beams_by_linear_sum", (poses, beams, strengths, failure_indices))


def index_beams_by_mohr_coulomb(
    poses: Poses, beams: Beams, strengths: Strengths, failure_indices: FailureIndices
) -> Call:
    """Finds the index of every beam by a criterion in given poses, as many at once as there are lanes."""
    return Call("index_beams_by_mohr_coulomb", (poses, beams, strengths, failure_indices))


def index_beams_by_peripheral_stress(
    poses: Poses, beams: Beams, strengths: Strengths, failure_indices: FailureIndices
) -> Call:
    """Finds the index of every beam by a criterion in given poses, as many at once as there are lanes."""
    return Call("index_beams_by_peripheral_stress", (poses, beams, strengths, failure_indices))


#: Passes `index_beams_by_…` by the name of their criterion.
INDEX_BEAMS_BY = {
    "elliptic": index_beams_by_elliptic,
    "linear_sum": index_beams_by_linear_sum,
    "mohr_coulomb": index_beams_by_mohr_coulomb,
    "peripheral_stress": index_beams_by_peripheral_stress,
}
