"""Passes that steps are composed of, of `core/passes/motion/body_forces.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.step_tables import BodyForces, Moving, StepBlocks, Timeline


def add_body_forces(moving: Moving, step_blocks: StepBlocks, body_forces: BodyForces) -> StepEntry:
    """Adds body forces to the sums, and their work over the half of the step that ends.

    Over elements of a block, then shared ones. Reads `motion` of an element; changes `sums`, `work` of an
    element.
    """
    return StepEntry("add_body_forces", (moving, step_blocks, body_forces))


def add_body_work(moving: Moving, body_forces: BodyForces) -> StepEntry:
    """Adds the work of body forces over the half of the step that begins, by its velocities; none at a pause.

    Over elements of a block, then shared ones. Reads `motion` of an element; changes `work` of an element.
    """
    return StepEntry("add_body_work", (moving, body_forces))


def follow_body_forces(timeline: Timeline, body_forces: BodyForces) -> StepEntry:
    """Sets the accelerations by body forces at the time of the clock.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("follow_body_forces", (timeline, body_forces))


def open_body_work(moving: Moving, body_forces: BodyForces) -> StepEntry:
    """Adds the work of body forces over the half of the step that begins after a pause.

    Over elements, in portions. Reads `motion` of an element; changes `work` of an element.
    """
    return StepEntry("open_body_work", (moving, body_forces))
