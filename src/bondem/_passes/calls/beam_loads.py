"""Passes that Python calls, of `core/passes/beams/beam_loads.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.step_tables import AlikeBeams, Beams, BeamSums, Poses


def load_alike_beams(poses: Poses, beams: Beams, alike_beams: AlikeBeams, beam_sums: BeamSums) -> Call:
    """Adds forces and torques of all beams in any poses that differ in length only."""
    return Call("load_alike_beams", (poses, beams, alike_beams, beam_sums))


def load_beams(poses: Poses, beams: Beams, beam_sums: BeamSums) -> Call:
    """Adds forces and torques of all beams in any poses; rows of the sums are given."""
    return Call("load_beams", (poses, beams, beam_sums))
