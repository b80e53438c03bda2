"""Passes that steps are composed of, of `core/passes/cells/cell_report.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.cell_tables import CellDilatation, DilatationEnergy, ElasticFacets, WallConstraints
from bondem._tables.step_tables import Moving, Portions


def add_cell_energies(
    moving: Moving, wall_constraints: WallConstraints, dilatation_energy: DilatationEnergy, portions: Portions
) -> StepEntry:
    """Adds the energy of dilatation, and that of half facets at walls, to the normal energy of the first portion
    of facets.

    Over numbers that a body has once, such as those of a record.
    """
    return StepEntry("add_cell_energies", (moving, wall_constraints, dilatation_energy, portions))


def check_facets(moving: Moving, elastic_facets: ElasticFacets, portions: Portions) -> StepEntry:
    """Counts unbroken facets of a portion that are turned beyond the range of their energy, and beyond its end.

    Over bonds, in portions. Reads `pose` at both ends.
    """
    return StepEntry("check_facets", (moving, elastic_facets, portions))


def sum_dilatation_energies(cell_dilatation: CellDilatation, dilatation_energy: DilatationEnergy) -> StepEntry:
    """Sums the energy of dilatation of a portion of cells, whose V θ is complete and is set to zero [J].

    Over elements, in portions. Writes `swelling` of an element.
    """
    return StepEntry("sum_dilatation_energies", (cell_dilatation, dilatation_energy))


def sum_facet_energies(moving: Moving, elastic_facets: ElasticFacets, portions: Portions) -> StepEntry:
    """Sums normal, shear, bending and twisting energy of the facets of a portion, without dilatation [J].

    Over bonds, in portions. Reads `pose` at both ends.
    """
    return StepEntry("sum_facet_energies", (moving, elastic_facets, portions))
