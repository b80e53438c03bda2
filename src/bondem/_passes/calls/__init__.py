"""Passes that Python calls; written by `python -m tests.core.passes`: change the core instead."""

from bondem._passes.calls.assembly import *
from bondem._passes.calls.beams import *
from bondem._passes.calls.cells import *
from bondem._passes.calls.contacts import *
from bondem._passes.calls.cracks import *
from bondem._passes.calls.damage import *
from bondem._passes.calls.incremental import *
from bondem._passes.calls.non_local import *
from bondem._passes.calls.packing import *
from bondem._passes.calls.quasistatic import *
from bondem._passes.calls.statics import *
from bondem._passes.calls.steps import *
from bondem._passes.calls.surface import *
from bondem._passes.calls.tessellation import *
