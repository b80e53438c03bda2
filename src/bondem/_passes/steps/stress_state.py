"""Passes that steps are composed of, of `core/passes/cracks/stress_state.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.cell_tables import FacetForces, FacetTractions, WallConstraints
from bondem._tables.crack_tables import CrackOnset, FacetStrengths, StressesOfCells
from bondem._tables.step_tables import Moving


def add_still_surface_stresses(
    moving: Moving, wall_constraints: WallConstraints, facet_tractions: FacetTractions, stresses_of_cells:
    StressesOfCells
) -> StepEntry:
    """Adds forces of walls and of loads on free facets to the stresses of surface cells, where no step is taken.

    Over rows of a table, in the order of the table. Reads `arm`, `load`, `pose` of an element; changes `tensor`
    of an element.
    """
    return StepEntry("add_still_surface_stresses", (moving, wall_constraints, facet_tractions, stresses_of_cells))


def add_surface_stresses(
    moving: Moving, wall_constraints: WallConstraints, facet_tractions: FacetTractions, stresses_of_cells:
    StressesOfCells
) -> StepEntry:
    """Adds forces of walls and of loads on free facets to the stresses of surface cells.

    Over rows of a table, in the order of the table. Reads `arm`, `load`, `pose` of an element; changes `tensor`
    of an element.
    """
    return StepEntry("add_surface_stresses", (moving, wall_constraints, facet_tractions, stresses_of_cells))


def find_cell_stresses(moving: Moving, facet_forces: FacetForces, stresses_of_cells: StressesOfCells) -> StepEntry:
    """Finds the mean stresses of cells from the forces of the last step on their facets and cracks.

    Over elements, in portions. Reads `carried`, `moment`, `pose` of an element; writes `tensor` of an element.
    """
    return StepEntry("find_cell_stresses", (moving, facet_forces, stresses_of_cells))


def find_still_stresses(moving: Moving, facet_forces: FacetForces, stresses_of_cells: StressesOfCells) -> StepEntry:
    """Finds the mean stresses of cells from present forces, where no step is taken.

    Over elements, in portions. Reads `carried`, `moment`, `pose` of an element; writes `tensor` of an element.
    """
    return StepEntry("find_still_stresses", (moving, facet_forces, stresses_of_cells))


def judge_cells(
    facet_strengths: FacetStrengths, stresses_of_cells: StressesOfCells, crack_onset: CrackOnset
) -> StepEntry:
    """Finds the cells whose facets may crack: those with cracks, and those whose stress may reach their strength.

    Over elements, in portions. Reads `cracked`, `tensor` of an element; writes `judged` of an element.
    """
    return StepEntry("judge_cells", (facet_strengths, stresses_of_cells, crack_onset))
