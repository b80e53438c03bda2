"""Passes that steps are composed of, of `core/passes/motion/move.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.step_tables import Moving, Resistance, Rows, StepBlocks


def move_elements(moving: Moving, step_blocks: StepBlocks) -> StepEntry:
    """Closes the step, and opens the next, for elements that own no row of the boundary.

    Over elements of a block, then shared ones. Changes `acceleration`, `motion`, `pose`, `sums` of an element.
    """
    return StepEntry("move_elements", (moving, step_blocks))


def move_resisted(moving: Moving, step_blocks: StepBlocks, resistance: Resistance) -> StepEntry:
    """Closes the step, and opens the next, for damped elements that own no row of the boundary.

    Over elements of a block, then shared ones. Changes `acceleration`, `dashed`, `loss`, `motion`, `pose`,
    `sums` of an element.
    """
    return StepEntry("move_resisted", (moving, step_blocks, resistance))


def move_resisted_rows(moving: Moving, step_blocks: StepBlocks, rows: Rows, resistance: Resistance) -> StepEntry:
    """Closes the step, and opens the next, for damped elements that own rows of the boundary.

    Over elements of a block, then shared ones. Reads `force`, `full`, `half` of an element; changes
    `acceleration`, `dashed`, `loss`, `motion`, `pose`, `sums` of an element; writes `reaction` of an element.
    """
    return StepEntry("move_resisted_rows", (moving, step_blocks, rows, resistance))


def move_rows(moving: Moving, step_blocks: StepBlocks, rows: Rows) -> StepEntry:
    """Closes the step, and opens the next, for elements that own rows of the boundary.

    Over elements of a block, then shared ones. Reads `force`, `full`, `half` of an element; changes
    `acceleration`, `motion`, `pose`, `sums` of an element; writes `reaction` of an element.
    """
    return StepEntry("move_rows", (moving, step_blocks, rows))


def open_elements(moving: Moving) -> StepEntry:
    """Opens a step after a pause for all elements, none of which owns a row of the boundary.

    Over elements, in portions. Reads `acceleration` of an element; changes `motion`, `pose` of an element.
    """
    return StepEntry("open_elements", (moving,))


def open_elements_and_rows(moving: Moving, rows: Rows) -> StepEntry:
    """Opens a step after a pause for all elements, some of which own rows of the boundary.

    Over elements, in portions. Reads `acceleration`, `half` of an element; changes `motion`, `pose` of an
    element.
    """
    return StepEntry("open_elements_and_rows", (moving, rows))


def reopen_elements(moving: Moving) -> StepEntry:
    """Opens a step for elements of a list that own no row of the boundary.

    Over elements of a block, then shared ones. Reads `acceleration` of an element; changes `motion`, `pose` of
    an element.
    """
    return StepEntry("reopen_elements", (moving,))


def reopen_rows(moving: Moving, rows: Rows) -> StepEntry:
    """Opens a step for elements of a list that own rows of the boundary.

    Over elements of a block, then shared ones. Reads `acceleration`, `half` of an element; changes `motion`,
    `pose` of an element.
    """
    return StepEntry("reopen_rows", (moving, rows))
