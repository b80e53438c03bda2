"""Passes that steps are composed of, of `core/passes/incremental/stored_beams.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.incremental_tables import StoredLoads
from bondem._tables.step_tables import Beams, Ledger, Moving, StepBlocks


def add_stored_loads(moving: Moving, beams: Beams, stored_loads: StoredLoads, step_blocks: StepBlocks) -> StepEntry:
    """Integrates the stored loads of the beams of a block over the step, and adds them to the sums of their
    elements.

    Over bonds of a block. Reads `motion`, `pose` at both ends; adds `sums` to elements.
    """
    return StepEntry("add_stored_loads", (moving, beams, stored_loads, step_blocks))


def sum_stored_energies(moving: Moving, beams: Beams, stored_loads: StoredLoads, ledger: Ledger) -> StepEntry:
    """Sums normal, shear, bending and twisting energy of the beams of a portion, by their stored loads [J].

    Over bonds, in portions. Reads `pose` at both ends.
    """
    return StepEntry("sum_stored_energies", (moving, beams, stored_loads, ledger))
