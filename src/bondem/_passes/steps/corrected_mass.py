"""Passes that steps are composed of, of `core/passes/cells/corrected_mass.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.cell_tables import CorrectedMass, ElasticFacets, WallConstraints
from bondem._tables.step_tables import Ledger, Moving, Rows, StepBlocks


def add_inertia_forces(corrected_mass: CorrectedMass, step_blocks: StepBlocks) -> StepEntry:
    """Adds the forces of the correction to the sums of the elements.

    Over elements of a block, then shared ones. Reads `force` of an element; changes `sums` of an element.
    """
    return StepEntry("add_inertia_forces", (corrected_mass, step_blocks))


def find_accelerations(
    moving: Moving, rows: Rows, step_blocks: StepBlocks, corrected_mass: CorrectedMass
) -> StepEntry:
    """Computes the accelerations of the elements by their loads alone.

    Over elements of a block, then shared ones. Reads `Rows.force`, `motion`, `sums` of an element; writes
    `CorrectedMass.acceleration` of an element.
    """
    return StepEntry("find_accelerations", (moving, rows, step_blocks, corrected_mass))


def find_dilatation_inertia(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, corrected_mass:
    CorrectedMass
) -> StepEntry:
    """Computes ρ β θ̈ of the cells by the accelerations of the elements.

    Over elements, in portions. Reads `arm` of an element; reads `CorrectedMass.acceleration`, `pose` at both
    ends; adds `inertia` to elements.
    """
    return StepEntry("find_dilatation_inertia", (moving, elastic_facets, wall_constraints, corrected_mass))


def find_inertia_forces(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, corrected_mass:
    CorrectedMass
) -> StepEntry:
    """Computes the forces of the correction on the elements.

    Over elements, in portions. Reads `arm` of an element; reads `inertia`, `pose` at both ends; adds `force` to
    elements.
    """
    return StepEntry("find_inertia_forces", (moving, elastic_facets, wall_constraints, corrected_mass))


def subtract_dilatation_energies(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, corrected_mass:
    CorrectedMass, ledger: Ledger
) -> StepEntry:
    """Subtracts the correction of the mass from the kinetic energies of a portion of cells.

    Over elements, in portions.
    """
    return StepEntry("subtract_dilatation_energies", (
        moving, elastic_facets, wall_constraints, corrected_mass, ledger
    ))
