"""Passes that steps are composed of, of `core/passes/cells/facet_loads.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.cell_tables import ElasticFacets, FacetForces
from bondem._tables.step_tables import Moving, StepBlocks


def add_and_keep_facet_loads(
    moving: Moving, elastic_facets: ElasticFacets, facet_forces: FacetForces, step_blocks: StepBlocks
) -> StepEntry:
    """Adds and stores the forces of the facets of a block, and adds up the moments V σ of their cells.

    Over bonds of a block. Reads `pose`, `pose.stress` at both ends; adds `FacetForces.sums`, `StepBlocks.sums`
    to elements.
    """
    return StepEntry("add_and_keep_facet_loads", (moving, elastic_facets, facet_forces, step_blocks))


def add_facet_loads(moving: Moving, elastic_facets: ElasticFacets, step_blocks: StepBlocks) -> StepEntry:
    """Adds forces and torques of the facets of a block to the sums of their cells, whose stresses are known.

    Over bonds of a block. Reads `pose`, `pose.stress` at both ends; adds `sums` to elements.
    """
    return StepEntry("add_facet_loads", (moving, elastic_facets, step_blocks))
