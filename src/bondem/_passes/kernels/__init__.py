"""Passes over an index, for devices; written by `python -m tests.core.passes`: change the core instead."""

from bondem._passes.kernels.adhesion import *
from bondem._passes.kernels.beams import *
from bondem._passes.kernels.boundary import *
from bondem._passes.kernels.breakage import *
from bondem._passes.kernels.cells import *
from bondem._passes.kernels.contacts import *
from bondem._passes.kernels.crack_onset import *
from bondem._passes.kernels.crack_report import *
from bondem._passes.kernels.cracks import *
from bondem._passes.kernels.facet_breakage import *
from bondem._passes.kernels.motion import *
from bondem._passes.kernels.new_contacts import *
from bondem._passes.kernels.non_local_pairs import *
from bondem._passes.kernels.ranges import *
from bondem._passes.kernels.record import *
from bondem._passes.kernels.rolling import *
from bondem._passes.kernels.softening_beams import *
from bondem._passes.kernels.storing_beams import *
from bondem._passes.kernels.strains import *
from bondem._passes.kernels.stress_onset import *
from bondem._passes.kernels.yielding import *
