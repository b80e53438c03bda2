"""Passes that steps are composed of; written by `python -m tests.core.passes`: change the core instead."""

from bondem._passes.steps.beams import *
from bondem._passes.steps.boundary import *
from bondem._passes.steps.cells import *
from bondem._passes.steps.contacts import *
from bondem._passes.steps.cracks import *
from bondem._passes.steps.damage import *
from bondem._passes.steps.incremental import *
from bondem._passes.steps.motion import *
from bondem._passes.steps.non_local import *
from bondem._passes.steps.record import *

#: What the passes of each kind run over.
KINDS = (
    "rows of a table, in the order of the table",
    "cracks or their cells, of which threads may share portions",
    "what begins, changes or ends in the step, in order",
    "numbers that a body has once, such as those of a record",
    "bonds of a block",
    "elements of a block, then shared ones",
    "elements that domains share",
    "elements, in portions",
    "bonds, in portions",
    "elements of a block, which it divides",
    "postponed elements of a block",
    "elements, in a range a thread",
)
