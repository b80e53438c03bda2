"""Passes that Python calls, of `core/passes/non_local/non_local_bonds.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.non_local_tables import ExtraForces, NonLocalBonds, SmallPairs, SmallSprings, SmallSteps
from bondem._tables.step_tables import Beams, Poses


def find_small_extra_forces(small_pairs: SmallPairs, extra_forces: ExtraForces) -> Call:
    """Finds extra forces at small strain, where frames of elements are those of space."""
    return Call("find_small_extra_forces", (small_pairs, extra_forces))


def load_non_local_bonds(poses: Poses, beams: Beams, non_local_bonds: NonLocalBonds) -> Call:
    """Finds forces and torques of all bonds in given poses from their stored values."""
    return Call("load_non_local_bonds", (poses, beams, non_local_bonds))


def take_small_steps(small_pairs: SmallPairs, small_springs: SmallSprings, small_steps: SmallSteps) -> Call:
    """Takes steps of small motions with extra forces that lag a step behind, until their energy is 1e30 times the
    first.
    """
    return Call("take_small_steps", (small_pairs, small_springs, small_steps))
