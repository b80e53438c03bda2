"""Passes that Python calls, of `core/passes/statics/dynamic_relaxation.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.statics_tables import DynamicRelaxation, RelaxationSpan
from bondem._tables.step_tables import Beams, BeamSums, UniformBeams


def relax_beams(
    beams: Beams, beam_sums: BeamSums, dynamic_relaxation: DynamicRelaxation, relaxation_span: RelaxationSpan
) -> Call:
    """Takes steps until the forces of beams balance the loads; rows of the sums are those of the elements, and
    zero.
    """
    return Call("relax_beams", (beams, beam_sums, dynamic_relaxation, relaxation_span))


def relax_uniform_beams(
    beams: Beams, uniform_beams: UniformBeams, beam_sums: BeamSums, dynamic_relaxation: DynamicRelaxation,
    relaxation_span: RelaxationSpan
) -> Call:
    """Takes steps until the forces of beams that differ in length only balance the loads."""
    return Call("relax_uniform_beams", (beams, uniform_beams, beam_sums, dynamic_relaxation, relaxation_span))
