"""Passes that steps are composed of, of `core/passes/cracks/crack_strains.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.cell_tables import CellStrains, ElasticFacets
from bondem._tables.crack_tables import CohesiveCracks
from bondem._tables.step_tables import Moving


def begin_crack_powers(
    moving: Moving, cell_strains: CellStrains, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks
) -> StepEntry:
    """Adds ∂U/∂factor of the stress-free strains by the forces of active cracks, before the first step of a call.

    Over cracks or their cells, of which threads may share portions. Reads `pose` at both ends.
    """
    return StepEntry("begin_crack_powers", (moving, cell_strains, elastic_facets, cohesive_cracks))


def sum_crack_powers(
    moving: Moving, cell_strains: CellStrains, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks
) -> StepEntry:
    """Adds ∂U/∂factor of the stress-free strains at active cracks, in steps that need it.

    Over cracks or their cells, of which threads may share portions. Reads `pose` at both ends.
    """
    return StepEntry("sum_crack_powers", (moving, cell_strains, elastic_facets, cohesive_cracks))
