"""Passes that steps are composed of, of `core/passes/damage/postponement.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.damage_tables import Candidates, EventLog, Postponed
from bondem._tables.step_tables import Dashpots, HistoryRows, Rows, StepBlocks


def keep_dashpots(dashpots: Dashpots, postponed: Postponed) -> StepEntry:
    """Keeps the sums of the dashpots of postponed elements.

    Over postponed elements of a block. Reads `flag` of an element; changes `sums` of an element.
    """
    return StepEntry("keep_dashpots", (dashpots, postponed))


def keep_sums(step_blocks: StepBlocks, postponed: Postponed) -> StepEntry:
    """Copies the sums of postponed elements, which are kept until failed bonds are removed.

    Over postponed elements of a block. Reads `flag`, `sums` of an element; changes `sum` of an element.
    """
    return StepEntry("keep_sums", (step_blocks, postponed))


def list_postponed(rows: Rows, candidates: Candidates, postponed: Postponed) -> StepEntry:
    """Lists all postponed elements, those with rows of the boundary last, and ends the failures of the step.

    Over elements of a block, which it divides. Writes `flag` of an element.
    """
    return StepEntry("list_postponed", (rows, candidates, postponed))


def postpone_elements(step_blocks: StepBlocks, candidates: Candidates, postponed: Postponed) -> StepEntry:
    """Divides the elements of a block, or shared ones, into those that continue and those that are postponed.

    Over elements of a block, which it divides.
    """
    return StepEntry("postpone_elements", (step_blocks, candidates, postponed))


def write_released(event_log: EventLog, history_rows: HistoryRows) -> StepEntry:
    """Writes the energy released into a record.

    Over single numbers, such as those of a record.
    """
    return StepEntry("write_released", (event_log, history_rows))
