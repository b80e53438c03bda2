"""Passes that steps are composed of; written by `python -m tests.core.passes`: change the core instead."""

from bondem._passes.steps.adhesion import *
from bondem._passes.steps.beam_failure import *
from bondem._passes.steps.beam_loads import *
from bondem._passes.steps.beam_report import *
from bondem._passes.steps.beam_softening import *
from bondem._passes.steps.body_forces import *
from bondem._passes.steps.cell_report import *
from bondem._passes.steps.cell_strains import *
from bondem._passes.steps.cell_stress import *
from bondem._passes.steps.contact_loads import *
from bondem._passes.steps.corrected_mass import *
from bondem._passes.steps.couples import *
from bondem._passes.steps.crack_lists import *
from bondem._passes.steps.crack_loads import *
from bondem._passes.steps.crack_states import *
from bondem._passes.steps.crack_strains import *
from bondem._passes.steps.dilatation import *
from bondem._passes.steps.dilatation_gradients import *
from bondem._passes.steps.element_stresses import *
from bondem._passes.steps.face_contacts import *
from bondem._passes.steps.facet_failure import *
from bondem._passes.steps.facet_loads import *
from bondem._passes.steps.facet_traction import *
from bondem._passes.steps.handover import *
from bondem._passes.steps.move import *
from bondem._passes.steps.non_local_bonds import *
from bondem._passes.steps.onset import *
from bondem._passes.steps.opening import *
from bondem._passes.steps.pair_failure import *
from bondem._passes.steps.postponement import *
from bondem._passes.steps.record import *
from bondem._passes.steps.rigid_walls import *
from bondem._passes.steps.rolling import *
from bondem._passes.steps.rows import *
from bondem._passes.steps.stored_beams import *
from bondem._passes.steps.strains import *
from bondem._passes.steps.stress_criteria import *
from bondem._passes.steps.stress_onset import *
from bondem._passes.steps.stress_state import *
from bondem._passes.steps.sums import *
from bondem._passes.steps.touch_moments import *
from bondem._passes.steps.travel import *
from bondem._passes.steps.wall_constraints import *
from bondem._passes.steps.yielding import *

#: What the passes of each kind run over.
KINDS = (
    "rows of a table, in the order of the table",
    "cracks or their cells, of which threads may share portions",
    "events of the step, such as failures, in their order",
    "single numbers, such as those of a record",
    "bonds of a block",
    "elements of a block, then shared ones",
    "elements that domains share",
    "elements, in portions",
    "bonds, in portions",
    "elements of a block, which it divides",
    "postponed elements of a block",
    "elements, one range per thread",
)
