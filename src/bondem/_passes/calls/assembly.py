"""Passes that Python calls, of `core/passes/assembly`; written by `python -m tests.core.passes`."""

from bondem._passes import Call
from bondem._tables.stiffness_tables import BeamRows, BlockRows, DilatationRows, FacetRows


def assemble_beams(beam_rows: BeamRows, block_rows: BlockRows) -> Call:
    """Fills the block rows of beams at rest."""
    return Call("assemble_beams", (beam_rows, block_rows))


def assemble_facets(facet_rows: FacetRows, block_rows: BlockRows, dilatation_rows: DilatationRows) -> Call:
    """Fills the block rows of facets at rest, and those of the dilatation of cells."""
    return Call("assemble_facets", (facet_rows, block_rows, dilatation_rows))
