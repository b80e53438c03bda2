"""Passes that Python calls, of `core/passes/assembly/beam_stiffness.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.stiffness_tables import BeamRows, BlockRows


def assemble_beams(beam_rows: BeamRows, block_rows: BlockRows) -> Call:
    """Fills the block rows of beams at rest."""
    return Call("assemble_beams", (beam_rows, block_rows))
