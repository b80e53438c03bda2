"""Passes that steps are composed of, of `core/passes/motion/sums.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.step_tables import Dashpots, StepBlocks


def add_dashpots(step_blocks: StepBlocks, dashpots: Dashpots) -> StepEntry:
    """Adds the forces of dashpots to those of springs; the former are kept, because their power is found later.

    Over elements of a block, then shared ones. Reads `Dashpots.sums` of an element; changes `StepBlocks.sums`
    of an element.
    """
    return StepEntry("add_dashpots", (step_blocks, dashpots))


def collect_dashpots(step_blocks: StepBlocks, dashpots: Dashpots) -> StepEntry:
    """Adds loads of dashpots of other domains to the sums of shared elements, and sets their rows to zero.

    Over elements that domains share. Changes `Dashpots.sums` of an element.
    """
    return StepEntry("collect_dashpots", (step_blocks, dashpots))


def collect_sums(step_blocks: StepBlocks) -> StepEntry:
    """Adds loads of bonds of other domains to the sums of shared elements, and sets their rows to zero.

    Over elements that domains share. Changes `sums` of an element.
    """
    return StepEntry("collect_sums", (step_blocks,))
