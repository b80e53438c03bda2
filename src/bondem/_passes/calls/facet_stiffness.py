"""Passes that Python calls, of `core/passes/assembly/facet_stiffness.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.stiffness_tables import BlockRows, DilatationRows, FacetRows


def assemble_facets(facet_rows: FacetRows, block_rows: BlockRows, dilatation_rows: DilatationRows) -> Call:
    """Fills the block rows of facets at rest, and those of the dilatation of cells."""
    return Call("assemble_facets", (facet_rows, block_rows, dilatation_rows))
