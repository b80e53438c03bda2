"""Passes that steps are composed of, of `core/passes/cells/dilatation.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.cell_tables import CellDilatation, ElasticFacets
from bondem._tables.damage_tables import Candidates, FailureBounds
from bondem._tables.step_tables import Moving, StepBlocks


def accumulate_and_mark(
    moving: Moving, elastic_facets: ElasticFacets, cell_dilatation: CellDilatation, failure_bounds: FailureBounds,
    candidates: Candidates
) -> StepEntry:
    """Adds contributions of facets to V θ of their cells, and marks facets near to failure.

    Over bonds of a block. Reads `pose`, `pose.stress` at both ends; adds `swelling` to elements.
    """
    return StepEntry("accumulate_and_mark", (moving, elastic_facets, cell_dilatation, failure_bounds, candidates))


def accumulate_dilatation(
    moving: Moving, elastic_facets: ElasticFacets, cell_dilatation: CellDilatation
) -> StepEntry:
    """Adds contributions of the facets of a block to V θ of their cells.

    Over bonds of a block. Reads `pose` at both ends; adds `swelling` to elements.
    """
    return StepEntry("accumulate_dilatation", (moving, elastic_facets, cell_dilatation))


def accumulate_left_dilatation(
    moving: Moving, elastic_facets: ElasticFacets, cell_dilatation: CellDilatation
) -> StepEntry:
    """Adds contributions of facets to V θ of their cells in bodies with many broken facets.

    Over bonds of a block. Reads `pose` at both ends; adds `swelling` to elements.
    """
    return StepEntry("accumulate_left_dilatation", (moving, elastic_facets, cell_dilatation))


def collect_dilatation(step_blocks: StepBlocks, cell_dilatation: CellDilatation) -> StepEntry:
    """Adds contributions of facets of other domains to V θ of shared cells, and sets their rows to zero.

    Over elements that domains share. Changes `swelling` of an element.
    """
    return StepEntry("collect_dilatation", (step_blocks, cell_dilatation))


def stress_cells(moving: Moving, cell_dilatation: CellDilatation) -> StepEntry:
    """Sets the stresses of cells by their complete V θ, which is set to zero.

    Over elements of a block, then shared ones. Reads `given`, `weight` of an element; changes `swelling` of an
    element; writes `pose.stress` of an element.
    """
    return StepEntry("stress_cells", (moving, cell_dilatation))
