"""Passes that steps are composed of, of `core/passes/non_local/element_stresses.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.step_tables import LaggedStresses, Moving, StepBlocks


def collect_moments(step_blocks: StepBlocks, lagged_stresses: LaggedStresses) -> StepEntry:
    """Adds moments of bonds of other domains to the stresses of shared elements, and sets their rows to zero.

    Over elements that domains share. Changes `moment` of an element.
    """
    return StepEntry("collect_moments", (step_blocks, lagged_stresses))


def find_stresses(moving: Moving, lagged_stresses: LaggedStresses) -> StepEntry:
    """Finds the stresses of a portion of elements, and bounds of their principal stresses; sets the moments to
    zero.

    Over elements, in portions. Reads `pose` of an element; changes `moment` of an element; writes `space`,
    `stress` of an element.
    """
    return StepEntry("find_stresses", (moving, lagged_stresses))


def find_stresses_of_block(moving: Moving, lagged_stresses: LaggedStresses) -> StepEntry:
    """Finds the stresses of the elements of a block, and bounds of their principal stresses; sets the moments to
    zero.

    Over elements of a block, then shared ones. Reads `pose` of an element; changes `moment` of an element;
    writes `space`, `stress` of an element.
    """
    return StepEntry("find_stresses_of_block", (moving, lagged_stresses))


def turn_stresses(moving: Moving, lagged_stresses: LaggedStresses) -> StepEntry:
    """Turns the stresses of a step ago with their elements.

    Over elements, in portions. Reads `pose`, `stress` of an element; writes `space` of an element.
    """
    return StepEntry("turn_stresses", (moving, lagged_stresses))
