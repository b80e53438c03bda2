"""Passes that steps are composed of, of `core/passes/cells/cell_report.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.cell_tables import CellDilatation, ElasticFacets, WallConstraints
from bondem._tables.step_tables import Ledger, Moving


def check_facets(moving: Moving, elastic_facets: ElasticFacets, ledger: Ledger) -> StepEntry:
    """Counts unbroken facets of a portion beyond safe angles (c1 or c2 < 0.7, w² < 0.75) and valid ones (0, 0.25);
    c, w as in `laws/beam.hpp`.

    Over bonds, in portions. Reads `pose` at both ends.
    """
    return StepEntry("check_facets", (moving, elastic_facets, ledger))


def sum_dilatation_energies(cell_dilatation: CellDilatation, ledger: Ledger) -> StepEntry:
    """Sums the energy of dilatation of a portion of cells, whose V θ is complete and is set to zero [J].

    Over elements, in portions. Writes `swelling` of an element.
    """
    return StepEntry("sum_dilatation_energies", (cell_dilatation, ledger))


def sum_energies_of_supports(moving: Moving, wall_constraints: WallConstraints, ledger: Ledger) -> StepEntry:
    """Sums the energies of half facets at walls.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("sum_energies_of_supports", (moving, wall_constraints, ledger))


def sum_facet_energies(moving: Moving, elastic_facets: ElasticFacets, ledger: Ledger) -> StepEntry:
    """Sums normal, shear, bending and twisting energy of the facets of a portion, without dilatation [J].

    Over bonds, in portions. Reads `pose` at both ends.
    """
    return StepEntry("sum_facet_energies", (moving, elastic_facets, ledger))
