"""Passes that steps are composed of, of `core/passes/cells/cell_strains.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.cell_tables import CellStrains, ElasticFacets, WallConstraints
from bondem._tables.step_tables import Moving, Rows, Timeline


def add_strain_work(
    moving: Moving, cell_strains: CellStrains, wall_constraints: WallConstraints, rows: Rows
) -> StepEntry:
    """Adds the work of strains that have changed, once the forces after the change are known.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("add_strain_work", (moving, cell_strains, wall_constraints, rows))


def begin_strain_work(
    moving: Moving, cell_strains: CellStrains, elastic_facets: ElasticFacets, wall_constraints: WallConstraints
) -> StepEntry:
    """Finds ∂U/∂factor from the stresses in the poses, before the first step of a call.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("begin_strain_work", (moving, cell_strains, elastic_facets, wall_constraints))


def follow_cell_strains(
    timeline: Timeline, cell_strains: CellStrains, elastic_facets: ElasticFacets, wall_constraints:
    WallConstraints
) -> StepEntry:
    """Sets stress-free strains, and with them the levers of facets and walls, to the time of the clock.

    Over rows of a table, in the order of the table. Writes `arm` of an element.
    """
    return StepEntry("follow_cell_strains", (timeline, cell_strains, elastic_facets, wall_constraints))


def sum_strain_powers(moving: Moving, cell_strains: CellStrains, elastic_facets: ElasticFacets) -> StepEntry:
    """Sums ∂U/∂factor of the facets of a portion, in steps that need this sum.

    Over bonds, in portions. Reads `pose`, `pose.stress` at both ends.
    """
    return StepEntry("sum_strain_powers", (moving, cell_strains, elastic_facets))
