"""Passes that steps are composed of, of `core/passes/cells/wall_constraints.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.cell_tables import CellDilatation, WallConstraints
from bondem._tables.step_tables import Moving, Rows, StepBlocks


def add_wall_dilatation(
    moving: Moving, wall_constraints: WallConstraints, cell_dilatation: CellDilatation
) -> StepEntry:
    """Adds contributions of walls to V θ of their cells.

    Over rows of a table, in the order of the table. Reads `arm`, `pose`, `wall` of an element; changes
    `swelling` of an element.
    """
    return StepEntry("add_wall_dilatation", (moving, wall_constraints, cell_dilatation))


def add_wall_loads(rows: Rows, step_blocks: StepBlocks) -> StepEntry:
    """Adds the forces of walls to the sums of their cells.

    Over elements of a block, then shared ones. Reads `support` of an element; changes `sums` of an element.
    """
    return StepEntry("add_wall_loads", (rows, step_blocks))


def apply_walls(moving: Moving, wall_constraints: WallConstraints, rows: Rows) -> StepEntry:
    """Sets the forces of walls on the rows of their cells, whose stresses are known, and adds the work of walls
    that move: the trapezoid of the force over the displacement.

    Over rows of a table, in the order of the table. Reads `arm`, `pose`, `pose.stress` of an element; changes
    `base`, `load`, `loss`, `wall` of an element; writes `support` of an element.
    """
    return StepEntry("apply_walls", (moving, wall_constraints, rows))


def follow_walls(moving: Moving, wall_constraints: WallConstraints, rows: Rows) -> StepEntry:
    """Moves walls to their places at the time of the clock, and updates their forces before the first step of a
    call.

    Over rows of a table, in the order of the table. Reads `base` of an element; changes `increment`, `wall` of
    an element.
    """
    return StepEntry("follow_walls", (moving, wall_constraints, rows))
