"""Passes that Python calls, of `core/passes/cells/observation.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.cell_tables import MomentsOfForces, TurnedVectors


def add_moments(moments_of_forces: MomentsOfForces) -> Call:
    """Adds the moments sym b⊗f of forces about the centres of their owners, times a sign."""
    return Call("add_moments", (moments_of_forces,))


def turn_vectors(turned_vectors: TurnedVectors) -> Call:
    """Turns vectors by the quaternions of their elements."""
    return Call("turn_vectors", (turned_vectors,))
