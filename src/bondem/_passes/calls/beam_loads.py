"""Passes that Python calls, of `core/passes/beams/beam_loads.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.step_tables import Beams, BeamSums, Poses
from bondem._tables.stiffness_tables import BondTangents, StiffnessProduct


def differentiate_beams(poses: Poses, beams: Beams, bond_tangents: BondTangents) -> Call:
    """Sets the second derivative of the energy of each beam by the motions of its elements."""
    return Call("differentiate_beams", (poses, beams, bond_tangents))


def load_beams(poses: Poses, beams: Beams, beam_sums: BeamSums) -> Call:
    """Adds forces and torques of all beams in given poses to the rows of the sums."""
    return Call("load_beams", (poses, beams, beam_sums))


def multiply_beams(poses: Poses, stiffness_product: StiffnessProduct, beams: Beams) -> Call:
    """Multiplies small motions by the stiffness of beams in given poses."""
    return Call("multiply_beams", (poses, stiffness_product, beams))
