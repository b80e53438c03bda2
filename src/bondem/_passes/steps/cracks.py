"""Passes that steps are composed of, of `core/passes/cracks`; written by `python -m tests.core.passes`."""

from bondem._passes import StepEntry
from bondem._tables.cell_tables import (
    CellDilatation,
    CellStrains,
    ElasticFacets,
    FacetForces,
    FacetsOfCells,
    FacetTractions,
    WallConstraints,
)
from bondem._tables.crack_tables import (
    CellSlack,
    CohesiveCracks,
    CrackEnergies,
    CrackLists,
    CrackOnset,
    FacetStrengths,
    StressesOfCells,
    YieldingCells,
)
from bondem._tables.damage_tables import EventLog, StressFunction
from bondem._tables.step_tables import HistoryRows, Moving, Portions, Rows, StepCut
from bondem._tables.stress_onset_tables import CandidateFacets


def add_crack_energies(
    moving: Moving, wall_constraints: WallConstraints, crack_energies: CrackEnergies, portions: Portions
) -> StepEntry:
    """Adds the energies of cracks and walls to those of the first portion of facets.

    Over numbers that a body has once, such as those of a record.
    """
    return StepEntry("add_crack_energies", (moving, wall_constraints, crack_energies, portions))


def add_crack_loads(moving: Moving, crack_lists: CrackLists, step_cut: StepCut) -> StepEntry:
    """Adds the forces of cracks that are treated one by one to the sums of their cells.

    Over elements of a block, then shared ones. Reads `sum` of an element; changes `loss`, `sums` of an element.
    """
    return StepEntry("add_crack_loads", (moving, crack_lists, step_cut))


def add_still_surface_stresses(
    moving: Moving, wall_constraints: WallConstraints, facet_tractions: FacetTractions, stresses_of_cells:
    StressesOfCells
) -> StepEntry:
    """Adds forces of walls and of loads on free facets to stresses of surface cells that were found without a
    step.

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


def add_yielding_work(
    facet_tractions: FacetTractions, stresses_of_cells: StressesOfCells, yielding_cells: YieldingCells, rows: Rows
) -> StepEntry:
    """Adds the work of loads on free facets that move as their cells yield.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("add_yielding_work", (facet_tractions, stresses_of_cells, yielding_cells, rows))


def begin_bases(moving: Moving, cell_dilatation: CellDilatation, crack_lists: CrackLists) -> StepEntry:
    """Stores V θ of cells without their cracks.

    Over elements, in portions. Reads `pose.stress`, `weight` of an element; writes `base` of an element.
    """
    return StepEntry("begin_bases", (moving, cell_dilatation, crack_lists))


def begin_crack_powers(
    moving: Moving, cell_strains: CellStrains, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks
) -> StepEntry:
    """Sets ∂U/∂factor of the stress-free strains by the forces that cracks have, where the time of the clock was
    not reached by a step.

    Over cracks or their cells, of which threads may share portions. Reads `pose` at both ends.
    """
    return StepEntry("begin_crack_powers", (moving, cell_strains, elastic_facets, cohesive_cracks))


def begin_cracks(
    elastic_facets: ElasticFacets, facet_forces: FacetForces, facet_strengths: FacetStrengths, crack_onset:
    CrackOnset, cohesive_cracks: CohesiveCracks
) -> StepEntry:
    """Begins the cracks of facets that are marked.

    Over what begins, changes or ends in the step, in order. Adds `cracked` to elements.
    """
    return StepEntry("begin_cracks", (elastic_facets, facet_forces, facet_strengths, crack_onset, cohesive_cracks))


def carry_cracks(
    stresses_of_cells: StressesOfCells, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Sums b⊗f of the cracks of each cell from their forces of the last step.

    Over cracks or their cells, of which threads may share portions. Adds `carried` to elements.
    """
    return StepEntry("carry_cracks", (stresses_of_cells, cohesive_cracks, crack_lists))


def find_cell_stresses(moving: Moving, facet_forces: FacetForces, stresses_of_cells: StressesOfCells) -> StepEntry:
    """Finds the mean stresses of cells from the forces of the last step on their facets and cracks.

    Over elements, in portions. Reads `carried`, `moment`, `pose` of an element; writes `tensor` of an element.
    """
    return StepEntry("find_cell_stresses", (moving, facet_forces, stresses_of_cells))


def find_still_stresses(moving: Moving, facet_forces: FacetForces, stresses_of_cells: StressesOfCells) -> StepEntry:
    """Finds the mean stresses of cells from present forces that were found without a step.

    Over elements, in portions. Reads `carried`, `moment`, `pose` of an element; writes `tensor` of an element.
    """
    return StepEntry("find_still_stresses", (moving, facet_forces, stresses_of_cells))


def find_strengths_along(candidate_facets: CandidateFacets) -> StepEntry:
    """Keeps the strengths of facets that begin to crack.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("find_strengths_along", (candidate_facets,))


def find_stress_candidates(
    moving: Moving, elastic_facets: ElasticFacets, facet_forces: FacetForces, stresses_of_cells: StressesOfCells,
    crack_onset: CrackOnset, candidate_facets: CandidateFacets
) -> StepEntry:
    """Writes the stresses of facets in tension, as candidates of a portion; marks facets of cells without
    cohesion.

    Over bonds, in portions. Reads `judged`, `pose`, `tensor` at both ends.
    """
    return StepEntry("find_stress_candidates", (
        moving, elastic_facets, facet_forces, stresses_of_cells, crack_onset, candidate_facets
    ))


def follow_levers(
    cell_strains: CellStrains, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks
) -> StepEntry:
    """Copies levers of facets that strains of cells have changed.

    Over cracks or their cells, of which threads may share portions.
    """
    return StepEntry("follow_levers", (cell_strains, elastic_facets, cohesive_cracks))


def judge_cells(
    facet_strengths: FacetStrengths, stresses_of_cells: StressesOfCells, crack_onset: CrackOnset
) -> StepEntry:
    """Finds the cells whose facets may crack: those with cracks, and those whose stress may reach their strength.

    Over elements, in portions. Reads `cracked`, `tensor` of an element; writes `judged` of an element.
    """
    return StepEntry("judge_cells", (facet_strengths, stresses_of_cells, crack_onset))


def judge_cells_by_cone(
    stresses_of_cells: StressesOfCells, stress_function: StressFunction, candidate_facets: CandidateFacets,
    crack_onset: CrackOnset
) -> StepEntry:
    """Finds the cells whose facets are evaluated: those whose stress may reach the criterion.

    Over elements, in portions. Reads `cracked`, `tensor` of an element; writes `judged` of an element.
    """
    return StepEntry("judge_cells_by_cone", (stresses_of_cells, stress_function, candidate_facets, crack_onset))


def judge_cells_by_mean_stress(
    stresses_of_cells: StressesOfCells, stress_function: StressFunction, candidate_facets: CandidateFacets,
    crack_onset: CrackOnset
) -> StepEntry:
    """Finds the cells whose facets are evaluated: those whose stress may reach the criterion.

    Over elements, in portions. Reads `cracked`, `tensor` of an element; writes `judged` of an element.
    """
    return StepEntry("judge_cells_by_mean_stress", (
        stresses_of_cells, stress_function, candidate_facets, crack_onset
    ))


def judge_cells_by_size(
    stresses_of_cells: StressesOfCells, candidate_facets: CandidateFacets, crack_onset: CrackOnset
) -> StepEntry:
    """Finds the cells whose facets are evaluated: those whose stress is large enough for the criterion of a user.

    Over elements, in portions. Reads `cracked`, `tensor` of an element; writes `judged` of an element.
    """
    return StepEntry("judge_cells_by_size", (stresses_of_cells, candidate_facets, crack_onset))


def leave_cracks(
    moving: Moving, elastic_facets: ElasticFacets, cell_dilatation: CellDilatation, cell_slack: CellSlack,
    cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Puts cracks to rest, or parts their faces, as `soften_cracks` has found.

    Over cracks or their cells, of which threads may share portions. Reads `CellDilatation.weight`, `half`,
    `pose`, `pose.stress` at both ends; adds `CellDilatation.weight`, `base`, `half`, `stale` to elements.
    """
    return StepEntry("leave_cracks", (
        moving, elastic_facets, cell_dilatation, cell_slack, cohesive_cracks, crack_lists
    ))


def link_cracks(
    elastic_facets: ElasticFacets, facet_forces: FacetForces, facet_strengths: FacetStrengths, cohesive_cracks:
    CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Prepares the cracks of a state at the start of a run: constants, weights of cells, lists, and forces of
    cracks.

    Over cracks or their cells, of which threads may share portions. Adds `half`, `slip` to elements.
    """
    return StepEntry("link_cracks", (elastic_facets, facet_forces, facet_strengths, cohesive_cracks, crack_lists))


def list_cracks(elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists) -> StepEntry:
    """Renews lists of cracks that are out of date.

    Over cracks or their cells, of which threads may share portions.
    """
    return StepEntry("list_cracks", (elastic_facets, cohesive_cracks, crack_lists))


def load_cracks(
    moving: Moving, elastic_facets: ElasticFacets, facet_strengths: FacetStrengths, stresses_of_cells:
    StressesOfCells, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Computes forces, torques and dissipation of the cracks that are treated one by one.

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
    """Adds up the dissipation of cracks, and logs cracks without integrity.

    Over what begins, changes or ends in the step, in order. Reads `pose` at both ends.
    """
    return StepEntry("log_cracks", (moving, elastic_facets, cohesive_cracks, crack_lists, event_log))


def mark_cracking_facets(
    moving: Moving, elastic_facets: ElasticFacets, facet_forces: FacetForces, facet_strengths: FacetStrengths,
    stresses_of_cells: StressesOfCells, crack_onset: CrackOnset
) -> StepEntry:
    """Marks facets of the material that begin to crack.

    Over bonds, in portions. Reads `judged`, `pose`, `tensor` at both ends.
    """
    return StepEntry("mark_cracking_facets", (
        moving, elastic_facets, facet_forces, facet_strengths, stresses_of_cells, crack_onset
    ))


def mark_cracking_planes(
    moving: Moving, elastic_facets: ElasticFacets, facet_forces: FacetForces, facet_strengths: FacetStrengths,
    crack_onset: CrackOnset
) -> StepEntry:
    """Marks facets of planes, such as joints, that begin to crack.

    Over rows of a table, in the order of the table. Reads `pose` at both ends.
    """
    return StepEntry("mark_cracking_planes", (moving, elastic_facets, facet_forces, facet_strengths, crack_onset))


def mark_failing_facets(
    moving: Moving, elastic_facets: ElasticFacets, facet_forces: FacetForces, stresses_of_cells: StressesOfCells,
    crack_onset: CrackOnset, candidate_facets: CandidateFacets
) -> StepEntry:
    """Marks candidates that fail, and leaves these with the mean stress of their cells, of which the index gives
    their strength.

    Over what begins, changes or ends in the step, in order. Reads `pose`, `tensor` at both ends.
    """
    return StepEntry("mark_failing_facets", (
        moving, elastic_facets, facet_forces, stresses_of_cells, crack_onset, candidate_facets
    ))


def measure_cracks(
    moving: Moving, elastic_facets: ElasticFacets, cell_slack: CellSlack, stresses_of_cells: StressesOfCells,
    cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Finds faces and halves of the cracks that are treated one by one, and axes of cracks before any loss of
    integrity.

    Over cracks or their cells, of which threads may share portions. Reads `pose`, `tensor` at both ends and at
    their neighbours; adds `half` to elements.
    """
    return StepEntry("measure_cracks", (
        moving, elastic_facets, cell_slack, stresses_of_cells, cohesive_cracks, crack_lists
    ))


def relax_cracked_cells(moving: Moving, cell_dilatation: CellDilatation, crack_lists: CrackLists) -> StepEntry:
    """Finds the stresses of all cells with cracks that are treated one by one.

    Over cracks or their cells, of which threads may share portions. Reads `base`, `half`, `weight` of an
    element; adds `pose.stress` to elements.
    """
    return StepEntry("relax_cracked_cells", (moving, cell_dilatation, crack_lists))


def relax_stale_cells(moving: Moving, cell_dilatation: CellDilatation, crack_lists: CrackLists) -> StepEntry:
    """Finds the stresses of cells with cracks that are out of date.

    Over cracks or their cells, of which threads may share portions. Reads `base`, `half`, `weight` of an
    element; adds `pose.stress`, `stale` to elements.
    """
    return StepEntry("relax_stale_cells", (moving, cell_dilatation, crack_lists))


def slide_cracks(
    moving: Moving, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Lets the faces of cracks slip with their two cells.

    Over cracks or their cells, of which threads may share portions. Reads `pose`, `slip` at both ends.
    """
    return StepEntry("slide_cracks", (moving, elastic_facets, cohesive_cracks, crack_lists))


def soften_cracks(
    moving: Moving, elastic_facets: ElasticFacets, facet_strengths: FacetStrengths, stresses_of_cells:
    StressesOfCells, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Lowers the integrities of cracks, and finds those that go to rest.

    Over cracks or their cells, of which threads may share portions. Reads `pose`, `pose.stress`, `tensor` at
    both ends; adds `half` to elements.
    """
    return StepEntry("soften_cracks", (
        moving, elastic_facets, facet_strengths, stresses_of_cells, cohesive_cracks, crack_lists
    ))


def stretch_all_cells(
    elastic_facets: ElasticFacets, facets_of_cells: FacetsOfCells, yielding_cells: YieldingCells
) -> StepEntry:
    """Stretches levers of all facets with the plastic deformation of their cells, as a run begins.

    Over elements, in portions. Reads `plastic` at both ends; changes `slipped` of an element.
    """
    return StepEntry("stretch_all_cells", (elastic_facets, facets_of_cells, yielding_cells))


def stretch_anew(
    cell_strains: CellStrains, elastic_facets: ElasticFacets, facets_of_cells: FacetsOfCells, wall_constraints:
    WallConstraints, yielding_cells: YieldingCells
) -> StepEntry:
    """Stretches levers with the plastic deformation of their cells, where stress-free strains have set them anew.

    Over rows of a table, in the order of the table. Reads `plastic` at both ends; changes `arm`, `slipped` of
    an element; writes `base_wall` of an element.
    """
    return StepEntry("stretch_anew", (
        cell_strains, elastic_facets, facets_of_cells, wall_constraints, yielding_cells
    ))


def stretch_cells(
    elastic_facets: ElasticFacets, facets_of_cells: FacetsOfCells, yielding_cells: YieldingCells
) -> StepEntry:
    """Stretches levers of facets with the plastic deformation of their cells, where it has grown.

    Over elements, in portions. Reads `plastic` at both ends; changes `slipped` of an element.
    """
    return StepEntry("stretch_cells", (elastic_facets, facets_of_cells, yielding_cells))


def stretch_walls_and_cracks(
    elastic_facets: ElasticFacets, wall_constraints: WallConstraints, yielding_cells: YieldingCells,
    cohesive_cracks: CohesiveCracks
) -> StepEntry:
    """Stretches levers of walls and cracks with the plastic deformation of their cells, where it has grown.

    Over cracks or their cells, of which threads may share portions. Reads `base_wall` of an element; reads
    `plastic` at both ends; adds `arm` to elements.
    """
    return StepEntry("stretch_walls_and_cracks", (elastic_facets, wall_constraints, yielding_cells, cohesive_cracks))


def sum_crack_energies(
    moving: Moving, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks, crack_energies: CrackEnergies
) -> StepEntry:
    """Sums the energies of the cracks that are treated one by one [J].

    Over cracks or their cells, of which threads may share portions. Reads `pose`, `pose.stress` at both ends.
    """
    return StepEntry("sum_crack_energies", (moving, elastic_facets, cohesive_cracks, crack_energies))


def sum_crack_powers(
    moving: Moving, cell_strains: CellStrains, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks
) -> StepEntry:
    """Sets ∂U/∂factor of the stress-free strains at cracks that are treated one by one, where it is needed.

    Over cracks or their cells, of which threads may share portions. Reads `pose` at both ends.
    """
    return StepEntry("sum_crack_powers", (moving, cell_strains, elastic_facets, cohesive_cracks))


def sum_cracks(
    stresses_of_cells: StressesOfCells, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Sums the forces of the cracks of each cell, and finds how far their faces slip by them.

    Over cracks or their cells, of which threads may share portions. Reads `half` of an element; adds `carried`,
    `slip`, `sum` to elements.
    """
    return StepEntry("sum_cracks", (stresses_of_cells, cohesive_cracks, crack_lists))


def sum_heat(
    stresses_of_cells: StressesOfCells, yielding_cells: YieldingCells, crack_energies: CrackEnergies
) -> StepEntry:
    """Sums the energy that the cells of a portion have dissipated by yielding [J].

    Over elements, in portions.
    """
    return StepEntry("sum_heat", (stresses_of_cells, yielding_cells, crack_energies))


def sum_stressed_dilatation(
    moving: Moving, cell_dilatation: CellDilatation, crack_energies: CrackEnergies
) -> StepEntry:
    """Sums the energy of dilatation of a portion of cells by their stresses [J].

    Over elements, in portions.
    """
    return StepEntry("sum_stressed_dilatation", (moving, cell_dilatation, crack_energies))


def wake_cracks(
    moving: Moving, elastic_facets: ElasticFacets, cell_dilatation: CellDilatation, cell_slack: CellSlack,
    cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Treats resting cracks one by one again that are about to soften or close.

    Over cracks or their cells, of which threads may share portions. Reads `pose` at both ends; adds
    `CellDilatation.weight`, `base`, `half`, `stale` to elements.
    """
    return StepEntry("wake_cracks", (
        moving, elastic_facets, cell_dilatation, cell_slack, cohesive_cracks, crack_lists
    ))


def watch_resting_cracks(
    moving: Moving, elastic_facets: ElasticFacets, facet_strengths: FacetStrengths, cohesive_cracks:
    CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Finds the resting cracks that are about to soften or close.

    Over cracks or their cells, of which threads may share portions. Reads `pose`, `pose.stress` at both ends.
    """
    return StepEntry("watch_resting_cracks", (moving, elastic_facets, facet_strengths, cohesive_cracks, crack_lists))


def weigh_cracked_cells(
    elastic_facets: ElasticFacets, cell_dilatation: CellDilatation, cell_slack: CellSlack, cohesive_cracks:
    CohesiveCracks
) -> StepEntry:
    """Computes the weights of the cells of all cracks at the start of a run.

    Over cracks or their cells, of which threads may share portions. Adds `CellDilatation.weight` to elements.
    """
    return StepEntry("weigh_cracked_cells", (elastic_facets, cell_dilatation, cell_slack, cohesive_cracks))


def write_crushing_of_facets(
    facet_strengths: FacetStrengths, cohesive_cracks: CohesiveCracks, event_log: EventLog, history_rows:
    HistoryRows
) -> StepEntry:
    """Writes the energy that facets have released beyond their fracture energy.

    Over cracks or their cells, of which threads may share portions.
    """
    return StepEntry("write_crushing_of_facets", (facet_strengths, cohesive_cracks, event_log, history_rows))


def write_heat(crack_energies: CrackEnergies, history_rows: HistoryRows) -> StepEntry:
    """Writes the heat of yielding into a record.

    Over numbers that a body has once, such as those of a record.
    """
    return StepEntry("write_heat", (crack_energies, history_rows))


def yield_cells(
    moving: Moving, facet_strengths: FacetStrengths, stresses_of_cells: StressesOfCells, yielding_cells:
    YieldingCells, crack_onset: CrackOnset
) -> StepEntry:
    """Lets the cells of a portion yield whose stress reaches their yield surface.

    Over elements, in portions. Reads `pose`, `tensor` of an element; reads `slipped` at both ends; adds `held`,
    `plastic` to elements; writes `judged` of an element.
    """
    return StepEntry("yield_cells", (moving, facet_strengths, stresses_of_cells, yielding_cells, crack_onset))
