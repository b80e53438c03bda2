"""Passes that steps are composed of, of `core/passes/beams/beam_loads.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.beam_softening_tables import SofteningBounds
from bondem._tables.damage_tables import Candidates, FailureBounds
from bondem._tables.step_tables import Beams, Dashpots, Moving, StepBlocks, UniformBeams


def add_beam_loads(moving: Moving, beams: Beams, step_blocks: StepBlocks) -> StepEntry:
    """Adds forces and torques of the beams of a block to the sums of their elements.

    Over bonds of a block. Reads `pose` at both ends; adds `sums` to elements.
    """
    return StepEntry("add_beam_loads", (moving, beams, step_blocks))


def add_beam_loads_softening_by_mohr_coulomb(
    moving: Moving, beams: Beams, step_blocks: StepBlocks, softening_bounds: SofteningBounds, candidates:
    Candidates
) -> StepEntry:
    """Adds forces and torques of beams that may soften, with the pressure on softened beams.

    Over bonds of a block. Reads `motion`, `pose` at both ends; adds `sums` to elements.
    """
    return StepEntry("add_beam_loads_softening_by_mohr_coulomb", (
        moving, beams, step_blocks, softening_bounds, candidates
    ))


def add_beam_loads_softening_by_peripheral_stress(
    moving: Moving, beams: Beams, step_blocks: StepBlocks, softening_bounds: SofteningBounds, candidates:
    Candidates
) -> StepEntry:
    """Adds forces and torques of beams that may soften, with the pressure on softened beams.

    Over bonds of a block. Reads `motion`, `pose` at both ends; adds `sums` to elements.
    """
    return StepEntry("add_beam_loads_softening_by_peripheral_stress", (
        moving, beams, step_blocks, softening_bounds, candidates
    ))


def add_dashpot_loads(moving: Moving, beams: Beams, dashpots: Dashpots, step_blocks: StepBlocks) -> StepEntry:
    """Adds forces and torques of the dashpots of beams to sums of their own.

    Over bonds of a block. Reads `motion`, `pose` at both ends; adds `Dashpots.sums` to elements.
    """
    return StepEntry("add_dashpot_loads", (moving, beams, dashpots, step_blocks))


def add_marked_beam_loads(
    moving: Moving, beams: Beams, step_blocks: StepBlocks, failure_bounds: FailureBounds, candidates: Candidates
) -> StepEntry:
    """Adds forces and torques of the beams of a block, and marks beams near to failure.

    Over bonds of a block. Reads `pose` at both ends; adds `sums` to elements.
    """
    return StepEntry("add_marked_beam_loads", (moving, beams, step_blocks, failure_bounds, candidates))


def add_marked_uniform_beam_loads(
    moving: Moving, beams: Beams, uniform_beams: UniformBeams, step_blocks: StepBlocks, failure_bounds:
    FailureBounds, candidates: Candidates
) -> StepEntry:
    """Adds forces and torques of beams that differ in length only, and marks beams near to failure.

    Over bonds of a block. Reads `pose` at both ends; adds `sums` to elements.
    """
    return StepEntry("add_marked_uniform_beam_loads", (
        moving, beams, uniform_beams, step_blocks, failure_bounds, candidates
    ))


def add_uniform_beam_loads(
    moving: Moving, beams: Beams, uniform_beams: UniformBeams, step_blocks: StepBlocks
) -> StepEntry:
    """Adds forces and torques of beams that differ in length only.

    Over bonds of a block. Reads `pose` at both ends; adds `sums` to elements.
    """
    return StepEntry("add_uniform_beam_loads", (moving, beams, uniform_beams, step_blocks))


def add_uniform_beam_loads_softening_by_mohr_coulomb(
    moving: Moving, beams: Beams, uniform_beams: UniformBeams, step_blocks: StepBlocks, softening_bounds:
    SofteningBounds, candidates: Candidates
) -> StepEntry:
    """Adds forces and torques of beams that may soften and differ in length only, with the pressure on softened
    beams.

    Over bonds of a block. Reads `motion`, `pose` at both ends; adds `sums` to elements.
    """
    return StepEntry("add_uniform_beam_loads_softening_by_mohr_coulomb", (
        moving, beams, uniform_beams, step_blocks, softening_bounds, candidates
    ))


def add_uniform_beam_loads_softening_by_peripheral_stress(
    moving: Moving, beams: Beams, uniform_beams: UniformBeams, step_blocks: StepBlocks, softening_bounds:
    SofteningBounds, candidates: Candidates
) -> StepEntry:
    """Adds forces and torques of beams that may soften and differ in length only, with the pressure on softened
    beams.

    Over bonds of a block. Reads `motion`, `pose` at both ends; adds `sums` to elements.
    """
    return StepEntry("add_uniform_beam_loads_softening_by_peripheral_stress", (
        moving, beams, uniform_beams, step_blocks, softening_bounds, candidates
    ))


#: Passes `add_beam_loads_softening_by_…` by the name of their criterion.
ADD_BEAM_LOADS_SOFTENING_BY = {
    "mohr_coulomb": add_beam_loads_softening_by_mohr_coulomb,
    "peripheral_stress": add_beam_loads_softening_by_peripheral_stress,
}
#: Passes `add_uniform_beam_loads_softening_by_…` by the name of their criterion.
ADD_UNIFORM_BEAM_LOADS_SOFTENING_BY = {
    "mohr_coulomb": add_uniform_beam_loads_softening_by_mohr_coulomb,
    "peripheral_stress": add_uniform_beam_loads_softening_by_peripheral_stress,
}
