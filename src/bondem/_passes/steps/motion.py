"""Passes that steps are composed of, of `core/passes/motion`; written by `python -m tests.core.passes`."""

from bondem._passes import StepEntry
from bondem._tables.step_tables import BodyForces, Dashpots, Moving, Resistance, Rows, StepCut, Timeline


def add_body_forces(moving: Moving, step_cut: StepCut, body_forces: BodyForces) -> StepEntry:
    """Adds body forces to the sums, and their work over the half of the step that ends.

    Over elements of a block, then shared ones. Reads `motion` of an element; changes `sums`, `work` of an
    element.
    """
    return StepEntry("add_body_forces", (moving, step_cut, body_forces))


def add_body_work(moving: Moving, body_forces: BodyForces) -> StepEntry:
    """Adds the work of body forces over the half of the step that begins, after the pass in which elements move or
    open a step.

    Over elements of a block, then shared ones. Reads `motion` of an element; changes `work` of an element.
    """
    return StepEntry("add_body_work", (moving, body_forces))


def add_dashpots(step_cut: StepCut, dashpots: Dashpots) -> StepEntry:
    """Adds the forces of dashpots to those of springs; the former are kept, because their power is found later.

    Over elements of a block, then shared ones. Reads `Dashpots.sums` of an element; changes `StepCut.sums` of
    an element.
    """
    return StepEntry("add_dashpots", (step_cut, dashpots))


def collect_dashpots(step_cut: StepCut, dashpots: Dashpots) -> StepEntry:
    """Adds loads of dashpots of other domains to the sums of shared elements, and sets their rows to zero.

    Over elements that domains share. Changes `Dashpots.sums` of an element.
    """
    return StepEntry("collect_dashpots", (step_cut, dashpots))


def collect_sums(step_cut: StepCut) -> StepEntry:
    """Adds loads of bonds of other domains to the sums of shared elements, and sets their rows to zero.

    Over elements that domains share. Changes `sums` of an element.
    """
    return StepEntry("collect_sums", (step_cut,))


def follow_body_forces(timeline: Timeline, body_forces: BodyForces) -> StepEntry:
    """Brings body forces to the time of the clock.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("follow_body_forces", (timeline, body_forces))


def move_elements(moving: Moving, step_cut: StepCut) -> StepEntry:
    """Closes the step, and opens the next, for elements that own no row of the boundary.

    Over elements of a block, then shared ones. Changes `acceleration`, `motion`, `pose`, `sums` of an element.
    """
    return StepEntry("move_elements", (moving, step_cut))


def move_resisted(moving: Moving, step_cut: StepCut, resistance: Resistance) -> StepEntry:
    """Closes the step, and opens the next, for damped elements that own no row of the boundary.

    Over elements of a block, then shared ones. Changes `acceleration`, `dashed`, `loss`, `motion`, `pose`,
    `sums` of an element.
    """
    return StepEntry("move_resisted", (moving, step_cut, resistance))


def move_resisted_rows(moving: Moving, step_cut: StepCut, rows: Rows, resistance: Resistance) -> StepEntry:
    """Closes the step, and opens the next, for damped elements that own rows of the boundary.

    Over elements of a block, then shared ones. Reads `force`, `full`, `half` of an element; changes
    `acceleration`, `dashed`, `loss`, `motion`, `pose`, `sums` of an element; writes `reaction` of an element.
    """
    return StepEntry("move_resisted_rows", (moving, step_cut, rows, resistance))


def move_rows(moving: Moving, step_cut: StepCut, rows: Rows) -> StepEntry:
    """Closes the step, and opens the next, for elements that own rows of the boundary.

    Over elements of a block, then shared ones. Reads `force`, `full`, `half` of an element; changes
    `acceleration`, `motion`, `pose`, `sums` of an element; writes `reaction` of an element.
    """
    return StepEntry("move_rows", (moving, step_cut, rows))


def open_body_work(moving: Moving, body_forces: BodyForces) -> StepEntry:
    """Adds the work of body forces over the half of the step that begins after a pause.

    Over elements, in portions. Reads `motion` of an element; changes `work` of an element.
    """
    return StepEntry("open_body_work", (moving, body_forces))


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
