"""Passes that steps are composed of, of `core/passes/non_local/non_local_bonds.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.non_local_tables import NonLocalBonds
from bondem._tables.step_tables import Beams, LaggedStresses, Ledger, Moving, StepBlocks


def add_lasting_loads(
    moving: Moving, beams: Beams, non_local_bonds: NonLocalBonds, lagged_stresses: LaggedStresses, step_blocks:
    StepBlocks
) -> StepEntry:
    """Finds and adds forces and torques of bonds that cannot fail, without keeping them.

    Over bonds of a block. Reads `pose`, `space` at both ends; adds `moment`, `sums` to elements.
    """
    return StepEntry("add_lasting_loads", (moving, beams, non_local_bonds, lagged_stresses, step_blocks))


def add_non_local_loads(non_local_bonds: NonLocalBonds, step_blocks: StepBlocks) -> StepEntry:
    """Adds forces and torques of the bonds to the sums of the elements, in the order of the bonds.

    Over bonds of a block. Adds `sums` to elements.
    """
    return StepEntry("add_non_local_loads", (non_local_bonds, step_blocks))


def find_non_local_forces(
    moving: Moving, beams: Beams, non_local_bonds: NonLocalBonds, lagged_stresses: LaggedStresses
) -> StepEntry:
    """Finds forces and torques of the bonds of a block, integrates their stored values over the step, and adds
    their moments to the stresses of their elements.

    Over bonds of a block. Reads `pose`, `space` at both ends; adds `moment` to elements.
    """
    return StepEntry("find_non_local_forces", (moving, beams, non_local_bonds, lagged_stresses))


def sum_non_local_energies(moving: Moving, beams: Beams, non_local_bonds: NonLocalBonds, ledger: Ledger) -> StepEntry:
    """Sums normal and shear energy of the springs of a portion of bonds, and the work of their extra forces [J].

    Over bonds, in portions. Reads `pose` at both ends.
    """
    return StepEntry("sum_non_local_energies", (moving, beams, non_local_bonds, ledger))
