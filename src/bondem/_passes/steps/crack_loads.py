"""Passes that steps are composed of, of `core/passes/cracks/crack_loads.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.cell_tables import CellDilatation, ElasticFacets
from bondem._tables.crack_tables import CohesiveCracks, CrackLists, FacetStrengths, StressesOfCells, YieldingCells
from bondem._tables.damage_tables import EventLog
from bondem._tables.step_tables import HistoryRows, Ledger, Moving, StepBlocks


def add_crack_loads(moving: Moving, crack_lists: CrackLists, step_blocks: StepBlocks) -> StepEntry:
    """Adds the forces of active cracks to the sums of their cells.

    Over elements of a block, then shared ones. Reads `sum` of an element; changes `loss`, `sums` of an element.
    """
    return StepEntry("add_crack_loads", (moving, crack_lists, step_blocks))


def load_cracks(
    moving: Moving, elastic_facets: ElasticFacets, facet_strengths: FacetStrengths, stresses_of_cells:
    StressesOfCells, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Computes forces, torques and dissipation of the active cracks.

    Over cracks or their cells, of which threads may share portions. Reads `tensor` of an element; reads `pose`,
    `pose.stress` at both ends; adds `half` to elements.
    """
    return StepEntry("load_cracks", (
        moving, elastic_facets, facet_strengths, stresses_of_cells, cohesive_cracks, crack_lists
    ))


def log_cracks(
    moving: Moving, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists,
    event_log: EventLog
) -> StepEntry:
    """Adds up the dissipation of cracks, and logs cracks that have lost all integrity in this step.

    Over events of the step, such as failures, in their order. Reads `pose` at both ends.
    """
    return StepEntry("log_cracks", (moving, elastic_facets, cohesive_cracks, crack_lists, event_log))


def sum_crack_energies(
    moving: Moving, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks, ledger: Ledger
) -> StepEntry:
    """Sums the energies of the active cracks [J].

    Over cracks or their cells, of which threads may share portions. Reads `pose`, `pose.stress` at both ends.
    """
    return StepEntry("sum_crack_energies", (moving, elastic_facets, cohesive_cracks, ledger))


def sum_heat(stresses_of_cells: StressesOfCells, yielding_cells: YieldingCells, ledger: Ledger) -> StepEntry:
    """Sums the energy that the cells of a portion have dissipated by yielding [J].

    Over elements, in portions.
    """
    return StepEntry("sum_heat", (stresses_of_cells, yielding_cells, ledger))


def sum_stressed_dilatation(moving: Moving, cell_dilatation: CellDilatation, ledger: Ledger) -> StepEntry:
    """Sums the energy of dilatation of a portion of cells by their stresses [J].

    Over elements, in portions.
    """
    return StepEntry("sum_stressed_dilatation", (moving, cell_dilatation, ledger))


def write_crushing_of_facets(
    facet_strengths: FacetStrengths, cohesive_cracks: CohesiveCracks, event_log: EventLog, history_rows:
    HistoryRows
) -> StepEntry:
    """Writes the energy that facets have released beyond their fracture energy in this run [J].

    Over cracks or their cells, of which threads may share portions.
    """
    return StepEntry("write_crushing_of_facets", (facet_strengths, cohesive_cracks, event_log, history_rows))
