"""Passes over an index, for devices, of `core/gpu/cracks.hpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Kernel
from bondem._tables.cell_tables import CellDilatation, CellStrains, ElasticFacets, FacetForces
from bondem._tables.crack_tables import CellSlack, CohesiveCracks, CrackLists, FacetStrengths, StressesOfCells
from bondem._tables.damage_tables import EventLog
from bondem._tables.device_tables import BondsOfElements, DeviceSpan, FallenCracks
from bondem._tables.step_tables import Moving, StepBlocks


def add_crack_load(
    device_span: DeviceSpan, moving: Moving, crack_lists: CrackLists, step_blocks: StepBlocks
) -> Kernel:
    """Adds the forces of active cracks to the sums of their cells.

    Over one index.
    """
    return Kernel("add_crack_load", (device_span, moving, crack_lists, step_blocks))


def begin_all_levers(elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks) -> Kernel:
    """Launched for `link_cracks`: prepares the cracks of a state at the start of a run: constants, weights of
    cells, lists, and forces of cracks.

    Over one index.
    """
    return Kernel("begin_all_levers", (elastic_facets, cohesive_cracks))


def begin_base(
    device_span: DeviceSpan, moving: Moving, cell_dilatation: CellDilatation, crack_lists: CrackLists
) -> Kernel:
    """Stores V θ of cells without their active cracks, from their stresses and weights.

    Over one index.
    """
    return Kernel("begin_base", (device_span, moving, cell_dilatation, crack_lists))


def carry_cell(
    stresses_of_cells: StressesOfCells, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> Kernel:
    """Launched for `carry_cracks`: sums b⊗f of the cracks of each cell from their forces of the last step, and
    finds its leading crack.

    Over one index.
    """
    return Kernel("carry_cell", (stresses_of_cells, cohesive_cracks, crack_lists))


def follow_lever(cell_strains: CellStrains, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks) -> Kernel:
    """Copies the levers of a facet that strains of cells have changed."""
    return Kernel("follow_lever", (cell_strains, elastic_facets, cohesive_cracks))


def leave_crack(elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists) -> Kernel:
    """Launched for `leave_cracks`: ends the active status of cracks that `soften_cracks` has found to rest, or
    `measure_cracks` to part.

    Over one index.
    """
    return Kernel("leave_crack", (elastic_facets, cohesive_cracks, crack_lists))


def link_halves(
    cohesive_cracks: CohesiveCracks, crack_lists: CrackLists, bonds_of_elements: BondsOfElements
) -> Kernel:
    """Pass of one index, defined in `core/gpu/cracks.hpp`."""
    return Kernel("link_halves", (cohesive_cracks, crack_lists, bonds_of_elements))


def load_crack(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, facet_strengths: FacetStrengths,
    stresses_of_cells: StressesOfCells, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists, fallen_cracks:
    FallenCracks
) -> Kernel:
    """Computes forces, torques and dissipation of the active cracks.

    Over one index.
    """
    return Kernel("load_crack", (
        device_span, moving, elastic_facets, facet_strengths, stresses_of_cells, cohesive_cracks, crack_lists,
        fallen_cracks
    ))


def log_all_cracks(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks,
    crack_lists: CrackLists, event_log: EventLog, fallen_cracks: FallenCracks
) -> Kernel:
    """Adds the dissipation of cracks to the released energy, and logs cracks without integrity in the order of
    facets.
    """
    return Kernel("log_all_cracks", (
        device_span, moving, elastic_facets, cohesive_cracks, crack_lists, event_log, fallen_cracks
    ))


def measure_crack(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, cell_slack: CellSlack,
    stresses_of_cells: StressesOfCells, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> Kernel:
    """Finds faces and halves of the active cracks, axes of cracks before any loss of integrity, and cracks that
    part.

    Over one index.
    """
    return Kernel("measure_crack", (
        device_span, moving, elastic_facets, cell_slack, stresses_of_cells, cohesive_cracks, crack_lists
    ))


def part_crack(
    moving: Moving, elastic_facets: ElasticFacets, cell_slack: CellSlack, cohesive_cracks: CohesiveCracks,
    crack_lists: CrackLists
) -> Kernel:
    """Adds the energy lost by a crack that parts, without the cracks that leave before it on the CPU: unbroken
    ones, and broken ones of a lower number.
    """
    return Kernel("part_crack", (moving, elastic_facets, cell_slack, cohesive_cracks, crack_lists))


def relax_cell(moving: Moving, cell_dilatation: CellDilatation, crack_lists: CrackLists) -> Kernel:
    """Finds the stresses of all cells with active cracks.

    Over one index.
    """
    return Kernel("relax_cell", (moving, cell_dilatation, crack_lists))


def relax_outdated_cell(
    moving: Moving, cell_dilatation: CellDilatation, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> Kernel:
    """Finds the stresses of cells with active cracks again where they are out of date, and their leading cracks.

    Over one index.
    """
    return Kernel("relax_outdated_cell", (moving, cell_dilatation, cohesive_cracks, crack_lists))


def restore_crack(
    elastic_facets: ElasticFacets, facet_forces: FacetForces, facet_strengths: FacetStrengths, cohesive_cracks:
    CohesiveCracks
) -> Kernel:
    """Launched for `link_cracks`: prepares the cracks of a state at the start of a run: constants, weights of
    cells, lists, and forces of cracks.

    Over one index.
    """
    return Kernel("restore_crack", (elastic_facets, facet_forces, facet_strengths, cohesive_cracks))


def slide_crack_of(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks,
    crack_lists: CrackLists
) -> Kernel:
    """Applies the slip of both cells to the faces of cracks.

    Over one index.
    """
    return Kernel("slide_crack_of", (device_span, moving, elastic_facets, cohesive_cracks, crack_lists))


def soften_crack(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, facet_strengths: FacetStrengths,
    stresses_of_cells: StressesOfCells, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> Kernel:
    """Lowers the integrities of cracks, and finds cracks that become resting.

    Over one index.
    """
    return Kernel("soften_crack", (
        device_span, moving, elastic_facets, facet_strengths, stresses_of_cells, cohesive_cracks, crack_lists
    ))


def sum_cracks_of_cell(
    stresses_of_cells: StressesOfCells, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> Kernel:
    """Sums the forces of the cracks of each cell, and finds the slip of their faces under these forces.

    Over one index.
    """
    return Kernel("sum_cracks_of_cell", (stresses_of_cells, cohesive_cracks, crack_lists))


def take_leaving(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, cell_dilatation: CellDilatation,
    cell_slack: CellSlack, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> Kernel:
    """Launched for `leave_cracks`: ends the active status of cracks that `soften_cracks` has found to rest, or
    `measure_cracks` to part.

    Over one index.
    """
    return Kernel("take_leaving", (
        device_span, moving, elastic_facets, cell_dilatation, cell_slack, cohesive_cracks, crack_lists
    ))


def take_woken(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, cell_dilatation: CellDilatation,
    cell_slack: CellSlack, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> Kernel:
    """Launched for `wake_cracks`: makes resting cracks active if they are about to soften or close; parts those
    whose faces have turned away.

    Over one index.
    """
    return Kernel("take_woken", (
        device_span, moving, elastic_facets, cell_dilatation, cell_slack, cohesive_cracks, crack_lists
    ))


def wake_crack(
    moving: Moving, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> Kernel:
    """Launched for `wake_cracks`: makes resting cracks active if they are about to soften or close; parts those
    whose faces have turned away.

    Over one index.
    """
    return Kernel("wake_crack", (moving, elastic_facets, cohesive_cracks, crack_lists))


def watch_resting_crack(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, facet_strengths: FacetStrengths,
    cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> Kernel:
    """Finds the resting cracks that are about to soften or close.

    Over one index.
    """
    return Kernel("watch_resting_crack", (
        device_span, moving, elastic_facets, facet_strengths, cohesive_cracks, crack_lists
    ))


def weigh_cell(cell_dilatation: CellDilatation, cell_slack: CellSlack, cohesive_cracks: CohesiveCracks) -> Kernel:
    """Computes the weights of the cells of all cracks at the start of a run.

    Over one index.
    """
    return Kernel("weigh_cell", (cell_dilatation, cell_slack, cohesive_cracks))
