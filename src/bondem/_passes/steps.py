"""Passes that steps are composed of; written by `python -m tests.core.passes`: change the core instead."""

from bondem._passes import StepEntry
from bondem._tables.beam_softening_tables import SofteningBeams, SofteningBounds
from bondem._tables.cell_tables import (
    CellDilatation,
    CellStrains,
    CorrectedMass,
    DilatationEnergy,
    DilatationGradients,
    ElasticFacets,
    FacetForces,
    FacetRelease,
    FacetsOfCells,
    FacetTractions,
    WallConstraints,
)
from bondem._tables.contact_tables import (
    AdheringPairs,
    ContactConstants,
    ContactEnergies,
    ContactPairs,
    ContactSums,
    FacePairs,
    NearPairs,
    RolledPairs,
    RolledWalls,
    Travel,
    WallContacts,
    WallMotions,
    Walls,
)
from bondem._tables.crack_tables import (
    CellSlack,
    CohesiveCracks,
    CrackEnergies,
    CrackLists,
    CrackOnset,
    FacetStrengths,
    PartedReach,
    StressesOfCells,
    YieldingCells,
)
from bondem._tables.damage_tables import (
    BeamIntegrity,
    Candidates,
    EventLog,
    FailureBounds,
    Postponed,
    Strengths,
    StressCandidates,
    StressFunction,
)
from bondem._tables.incremental_tables import StoredLoads
from bondem._tables.non_local_tables import NonLocalBonds, NonLocalWork
from bondem._tables.step_tables import (
    AlikeBeams,
    Beams,
    BodyForces,
    CoupleTable,
    Dashpots,
    Drives,
    Gauges,
    HistoryRows,
    LaggedStresses,
    Moving,
    Portions,
    Resistance,
    RowLoads,
    Rows,
    StepCut,
    Strain,
    Timeline,
)
from bondem._tables.stress_onset_tables import CandidateFacets

#: What the passes of each kind run over.
KINDS = (
    "rows of a table, in the order of the table",
    "cracks or their cells, of which threads may share portions",
    "what begins, changes or ends in the step, in order",
    "numbers that a body has once, such as those of a record",
    "bonds of a block",
    "elements of a block, then shared ones",
    "elements that domains share",
    "elements, in portions",
    "bonds, in portions",
    "elements of a block, which it divides",
    "postponed elements of a block",
    "elements, in a range a thread",
)


def accumulate_and_mark(
    moving: Moving, elastic_facets: ElasticFacets, cell_dilatation: CellDilatation, failure_bounds: FailureBounds,
    candidates: Candidates
) -> StepEntry:
    """Adds contributions of facets to V θ of their cells, and marks facets near to failure.

    Over bonds of a block.
    """
    return StepEntry("accumulate_and_mark", (moving, elastic_facets, cell_dilatation, failure_bounds, candidates))


def accumulate_dilatation(
    moving: Moving, elastic_facets: ElasticFacets, cell_dilatation: CellDilatation
) -> StepEntry:
    """Adds contributions of the facets of a block to V θ of their cells.

    Over bonds of a block.
    """
    return StepEntry("accumulate_dilatation", (moving, elastic_facets, cell_dilatation))


def accumulate_left_dilatation(
    moving: Moving, elastic_facets: ElasticFacets, cell_dilatation: CellDilatation
) -> StepEntry:
    """Adds contributions of facets to V θ of their cells in bodies with many broken facets.

    Over bonds of a block.
    """
    return StepEntry("accumulate_left_dilatation", (moving, elastic_facets, cell_dilatation))


def add_adhesion_loads(
    contact_pairs: ContactPairs, near_pairs: NearPairs, adhering_pairs: AdheringPairs, contact_sums: ContactSums
) -> StepEntry:
    """Adds adhesion to the elements of a range.

    Over elements, in a range a thread.
    """
    return StepEntry("add_adhesion_loads", (contact_pairs, near_pairs, adhering_pairs, contact_sums))


def add_alike_beam_loads(moving: Moving, beams: Beams, alike_beams: AlikeBeams, step_cut: StepCut) -> StepEntry:
    """Adds forces and torques of beams that differ in length only.

    Over bonds of a block.
    """
    return StepEntry("add_alike_beam_loads", (moving, beams, alike_beams, step_cut))


def add_alike_beam_loads_softening_by_mohr_coulomb(
    moving: Moving, beams: Beams, alike_beams: AlikeBeams, step_cut: StepCut, softening_bounds: SofteningBounds,
    candidates: Candidates
) -> StepEntry:
    """Adds forces and torques of beams that may soften and differ in length only, with the pressure on softened
    ones.

    Over bonds of a block.
    """
    return StepEntry("add_alike_beam_loads_softening_by_mohr_coulomb", (
        moving, beams, alike_beams, step_cut, softening_bounds, candidates
    ))


def add_alike_beam_loads_softening_by_peripheral_stress(
    moving: Moving, beams: Beams, alike_beams: AlikeBeams, step_cut: StepCut, softening_bounds: SofteningBounds,
    candidates: Candidates
) -> StepEntry:
    """Adds forces and torques of beams that may soften and differ in length only, with the pressure on softened
    ones.

    Over bonds of a block.
    """
    return StepEntry("add_alike_beam_loads_softening_by_peripheral_stress", (
        moving, beams, alike_beams, step_cut, softening_bounds, candidates
    ))


def add_and_keep_facet_loads(
    moving: Moving, elastic_facets: ElasticFacets, facet_forces: FacetForces, step_cut: StepCut
) -> StepEntry:
    """Adds and stores the forces of the facets of a block, and adds up the moments V σ of their cells.

    Over bonds of a block.
    """
    return StepEntry("add_and_keep_facet_loads", (moving, elastic_facets, facet_forces, step_cut))


def add_beam_loads(moving: Moving, beams: Beams, step_cut: StepCut) -> StepEntry:
    """Adds forces and torques of the beams of a block to the sums of their elements.

    Over bonds of a block.
    """
    return StepEntry("add_beam_loads", (moving, beams, step_cut))


def add_beam_loads_softening_by_mohr_coulomb(
    moving: Moving, beams: Beams, step_cut: StepCut, softening_bounds: SofteningBounds, candidates: Candidates
) -> StepEntry:
    """Adds forces and torques of beams that may soften, with the pressure on softened ones.

    Over bonds of a block.
    """
    return StepEntry("add_beam_loads_softening_by_mohr_coulomb", (
        moving, beams, step_cut, softening_bounds, candidates
    ))


def add_beam_loads_softening_by_peripheral_stress(
    moving: Moving, beams: Beams, step_cut: StepCut, softening_bounds: SofteningBounds, candidates: Candidates
) -> StepEntry:
    """Adds forces and torques of beams that may soften, with the pressure on softened ones.

    Over bonds of a block.
    """
    return StepEntry("add_beam_loads_softening_by_peripheral_stress", (
        moving, beams, step_cut, softening_bounds, candidates
    ))


def add_begun_contacts(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, lagged_stresses:
    LaggedStresses, event_log: EventLog
) -> StepEntry:
    """Adds new contacts to the stresses of the ends of bonds that have failed in this step, after these contacts
    have begun.

    Over what begins, changes or ends in the step, in order.
    """
    return StepEntry("add_begun_contacts", (moving, contact_constants, contact_pairs, lagged_stresses, event_log))


def add_body_forces(moving: Moving, step_cut: StepCut, body_forces: BodyForces) -> StepEntry:
    """Adds body forces to the sums, and their work over the half of the step that ends.

    Over elements of a block, then shared ones.
    """
    return StepEntry("add_body_forces", (moving, step_cut, body_forces))


def add_body_work(moving: Moving, body_forces: BodyForces) -> StepEntry:
    """Adds the work of body forces over the half of the step that begins, after the pass in which elements move or
    open a step.

    Over elements of a block, then shared ones.
    """
    return StepEntry("add_body_work", (moving, body_forces))


def add_cell_energies(
    moving: Moving, wall_constraints: WallConstraints, dilatation_energy: DilatationEnergy, portions: Portions
) -> StepEntry:
    """Adds the energy of dilatation, and that of half facets at walls, to the normal energy of the first portion
    of facets.

    Over numbers that a body has once, such as those of a record.
    """
    return StepEntry("add_cell_energies", (moving, wall_constraints, dilatation_energy, portions))


def add_contact_loads(moving: Moving, step_cut: StepCut, contact_sums: ContactSums) -> StepEntry:
    """Adds forces and losses of contacts to those of the elements, and sets the former to zero.

    Over elements of a block, then shared ones.
    """
    return StepEntry("add_contact_loads", (moving, step_cut, contact_sums))


def add_crack_energies(
    moving: Moving, wall_constraints: WallConstraints, crack_energies: CrackEnergies, portions: Portions
) -> StepEntry:
    """Adds the energies of cracks and walls to those of the first portion of facets.

    Over numbers that a body has once, such as those of a record.
    """
    return StepEntry("add_crack_energies", (moving, wall_constraints, crack_energies, portions))


def add_crack_loads(moving: Moving, crack_lists: CrackLists, step_cut: StepCut) -> StepEntry:
    """Adds the forces of cracks that are treated one by one to the sums of their cells.

    Over elements of a block, then shared ones.
    """
    return StepEntry("add_crack_loads", (moving, crack_lists, step_cut))


def add_dashpot_loads(moving: Moving, beams: Beams, dashpots: Dashpots, step_cut: StepCut) -> StepEntry:
    """Adds forces and torques of the dashpots of beams to sums of their own.

    Over bonds of a block.
    """
    return StepEntry("add_dashpot_loads", (moving, beams, dashpots, step_cut))


def add_dashpots(step_cut: StepCut, dashpots: Dashpots) -> StepEntry:
    """Adds the forces of dashpots to those of springs; the former are kept, because their power is found later.

    Over elements of a block, then shared ones.
    """
    return StepEntry("add_dashpots", (step_cut, dashpots))


def add_face_loads(contact_pairs: ContactPairs, face_pairs: FacePairs, contact_sums: ContactSums) -> StepEntry:
    """Adds forces of faces to the elements of a range.

    Over elements, in a range a thread.
    """
    return StepEntry("add_face_loads", (contact_pairs, face_pairs, contact_sums))


def add_facet_loads(moving: Moving, elastic_facets: ElasticFacets, step_cut: StepCut) -> StepEntry:
    """Adds forces and torques of the facets of a block to the sums of their cells, whose stresses are known.

    Over bonds of a block.
    """
    return StepEntry("add_facet_loads", (moving, elastic_facets, step_cut))


def add_gradient_energies(dilatation_gradients: DilatationGradients, portions: Portions) -> StepEntry:
    """Adds the energies of gradients to those of the facets.

    Over numbers that a body has once, such as those of a record.
    """
    return StepEntry("add_gradient_energies", (dilatation_gradients, portions))


def add_inertia_forces(corrected_mass: CorrectedMass, step_cut: StepCut) -> StepEntry:
    """Adds the forces of the correction to the sums of the elements.

    Over elements of a block, then shared ones.
    """
    return StepEntry("add_inertia_forces", (corrected_mass, step_cut))


def add_lasting_loads(
    moving: Moving, beams: Beams, non_local_bonds: NonLocalBonds, lagged_stresses: LaggedStresses, step_cut:
    StepCut
) -> StepEntry:
    """Finds and adds forces and torques of bonds that cannot fail, without keeping them.

    Over bonds of a block.
    """
    return StepEntry("add_lasting_loads", (moving, beams, non_local_bonds, lagged_stresses, step_cut))


def add_layer_torques(dilatation_gradients: DilatationGradients, step_cut: StepCut) -> StepEntry:
    """Adds the torques of bent layers to the sums of the cells.

    Over elements of a block, then shared ones.
    """
    return StepEntry("add_layer_torques", (dilatation_gradients, step_cut))


def add_marked_alike_beam_loads(
    moving: Moving, beams: Beams, alike_beams: AlikeBeams, step_cut: StepCut, failure_bounds: FailureBounds,
    candidates: Candidates
) -> StepEntry:
    """Adds forces and torques of beams that differ in length only, and marks beams near to failure.

    Over bonds of a block.
    """
    return StepEntry("add_marked_alike_beam_loads", (
        moving, beams, alike_beams, step_cut, failure_bounds, candidates
    ))


def add_marked_beam_loads(
    moving: Moving, beams: Beams, step_cut: StepCut, failure_bounds: FailureBounds, candidates: Candidates
) -> StepEntry:
    """Adds forces and torques of the beams of a block, and marks beams near to failure.

    Over bonds of a block.
    """
    return StepEntry("add_marked_beam_loads", (moving, beams, step_cut, failure_bounds, candidates))


def add_non_local_loads(non_local_bonds: NonLocalBonds, step_cut: StepCut) -> StepEntry:
    """Adds forces and torques of the bonds to the sums of the elements, in the order of the bonds.

    Over bonds of a block.
    """
    return StepEntry("add_non_local_loads", (non_local_bonds, step_cut))


def add_pair_loads(
    contact_constants: ContactConstants, contact_pairs: ContactPairs, near_pairs: NearPairs, contact_sums:
    ContactSums
) -> StepEntry:
    """Adds forces of pairs to the elements of a range, in the order of the pairs.

    Over elements, in a range a thread.
    """
    return StepEntry("add_pair_loads", (contact_constants, contact_pairs, near_pairs, contact_sums))


def add_pair_moments(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, near_pairs: NearPairs,
    lagged_stresses: LaggedStresses
) -> StepEntry:
    """Adds contacts of pairs to the stresses of the elements of a range, in the order of the pairs.

    Over elements, in a range a thread.
    """
    return StepEntry("add_pair_moments", (moving, contact_constants, contact_pairs, near_pairs, lagged_stresses))


def add_rolling_loads(
    contact_pairs: ContactPairs, near_pairs: NearPairs, rolled_pairs: RolledPairs, contact_sums: ContactSums
) -> StepEntry:
    """Adds moments of resistance to rolling to the elements of a range.

    Over elements, in a range a thread.
    """
    return StepEntry("add_rolling_loads", (contact_pairs, near_pairs, rolled_pairs, contact_sums))


def add_still_surface_stresses(
    moving: Moving, wall_constraints: WallConstraints, facet_tractions: FacetTractions, stresses_of_cells:
    StressesOfCells
) -> StepEntry:
    """Adds forces of walls and of loads on free facets to stresses of surface cells that were found without a
    step.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("add_still_surface_stresses", (moving, wall_constraints, facet_tractions, stresses_of_cells))


def add_stored_loads(moving: Moving, beams: Beams, stored_loads: StoredLoads, step_cut: StepCut) -> StepEntry:
    """Integrates the stored forces and moments of the beams of a block over the step, and adds them to the sums of
    their elements.

    Over bonds of a block.
    """
    return StepEntry("add_stored_loads", (moving, beams, stored_loads, step_cut))


def add_strain_work(
    moving: Moving, cell_strains: CellStrains, wall_constraints: WallConstraints, rows: Rows
) -> StepEntry:
    """Adds the work of strains that have changed, when the forces after that are known.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("add_strain_work", (moving, cell_strains, wall_constraints, rows))


def add_stress_differences(
    moving: Moving, cell_dilatation: CellDilatation, dilatation_gradients: DilatationGradients
) -> StepEntry:
    """Adds the forces of the springs between cells to their stresses.

    Over elements, in portions.
    """
    return StepEntry("add_stress_differences", (moving, cell_dilatation, dilatation_gradients))


def add_surface_stresses(
    moving: Moving, wall_constraints: WallConstraints, facet_tractions: FacetTractions, stresses_of_cells:
    StressesOfCells
) -> StepEntry:
    """Adds forces of walls and of loads on free facets to the stresses of surface cells.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("add_surface_stresses", (moving, wall_constraints, facet_tractions, stresses_of_cells))


def add_traction_work(moving: Moving, facet_tractions: FacetTractions, rows: Rows) -> StepEntry:
    """Adds half the work of tractions that change: once by the stresses before, and once by those after.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("add_traction_work", (moving, facet_tractions, rows))


def add_wall_dilatation(
    moving: Moving, wall_constraints: WallConstraints, cell_dilatation: CellDilatation
) -> StepEntry:
    """Adds contributions of walls to V θ of their cells.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("add_wall_dilatation", (moving, wall_constraints, cell_dilatation))


def add_wall_loads(rows: Rows, step_cut: StepCut) -> StepEntry:
    """Adds the forces of walls to the sums of their cells.

    Over elements of a block, then shared ones.
    """
    return StepEntry("add_wall_loads", (rows, step_cut))


def add_wall_moments(
    moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts, walls: Walls,
    lagged_stresses: LaggedStresses
) -> StepEntry:
    """Adds contacts with walls to the stresses of the elements of a portion.

    Over elements, in portions.
    """
    return StepEntry("add_wall_moments", (moving, contact_constants, wall_contacts, walls, lagged_stresses))


def add_yielding_work(
    facet_tractions: FacetTractions, stresses_of_cells: StressesOfCells, yielding_cells: YieldingCells, rows: Rows
) -> StepEntry:
    """Adds the work of loads on free facets that move as their cells yield.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("add_yielding_work", (facet_tractions, stresses_of_cells, yielding_cells, rows))


def adhere_at_walls(
    moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts, walls: Walls, contact_sums:
    ContactSums
) -> StepEntry:
    """Finds the adhesion of a portion of elements at walls.

    Over elements, in portions.
    """
    return StepEntry("adhere_at_walls", (moving, contact_constants, wall_contacts, walls, contact_sums))


def adhere_pairs(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, near_pairs: NearPairs,
    adhering_pairs: AdheringPairs
) -> StepEntry:
    """Finds the adhesion of the near pairs of a portion of elements.

    Over elements, in portions.
    """
    return StepEntry("adhere_pairs", (moving, contact_constants, contact_pairs, near_pairs, adhering_pairs))


def apply_walls(moving: Moving, wall_constraints: WallConstraints, rows: Rows) -> StepEntry:
    """Sets the forces of walls on the rows of their cells, whose stresses are known, and adds the work of walls
    that move: the trapezoid of the force over the displacement.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("apply_walls", (moving, wall_constraints, rows))


def begin_bases(moving: Moving, cell_dilatation: CellDilatation, crack_lists: CrackLists) -> StepEntry:
    """Stores V θ of cells without their cracks.

    Over elements, in portions.
    """
    return StepEntry("begin_bases", (moving, cell_dilatation, crack_lists))


def begin_contacts(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, near_pairs: NearPairs,
    event_log: EventLog, postponed: Postponed
) -> StepEntry:
    """Begins contact where beams have broken in this step, on the sums that are kept for their ends.

    Over what begins, changes or ends in the step, in order.
    """
    return StepEntry("begin_contacts", (moving, contact_constants, contact_pairs, near_pairs, event_log, postponed))


def begin_crack_powers(
    moving: Moving, cell_strains: CellStrains, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks
) -> StepEntry:
    """Sets ∂U/∂factor of the stress-free strains by the forces that cracks have, where the time of the clock was
    not reached by a step.

    Over cracks or their cells, of which threads may share portions.
    """
    return StepEntry("begin_crack_powers", (moving, cell_strains, elastic_facets, cohesive_cracks))


def begin_cracks(
    elastic_facets: ElasticFacets, facet_forces: FacetForces, facet_strengths: FacetStrengths, crack_onset:
    CrackOnset, cohesive_cracks: CohesiveCracks
) -> StepEntry:
    """Begins the cracks of facets that are marked.

    Over what begins, changes or ends in the step, in order.
    """
    return StepEntry("begin_cracks", (elastic_facets, facet_forces, facet_strengths, crack_onset, cohesive_cracks))


def begin_face_contacts(
    moving: Moving, contact_pairs: ContactPairs, near_pairs: NearPairs, face_pairs: FacePairs, crack_lists:
    CrackLists, event_log: EventLog
) -> StepEntry:
    """Begins the contact of faces that part in this step.

    Over what begins, changes or ends in the step, in order.
    """
    return StepEntry("begin_face_contacts", (moving, contact_pairs, near_pairs, face_pairs, crack_lists, event_log))


def begin_softened_contacts(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, near_pairs: NearPairs,
    event_log: EventLog, contact_sums: ContactSums
) -> StepEntry:
    """Begins contact where softening beams have broken at the beginning of this step.

    Over what begins, changes or ends in the step, in order.
    """
    return StepEntry("begin_softened_contacts", (
        moving, contact_constants, contact_pairs, near_pairs, event_log, contact_sums
    ))


def begin_softening(
    candidates: Candidates, softening_bounds: SofteningBounds, softening_beams: SofteningBeams, event_log:
    EventLog
) -> StepEntry:
    """Writes the rows of beams that have begun to soften in this step, and adds up their dissipation.

    Over what begins, changes or ends in the step, in order.
    """
    return StepEntry("begin_softening", (candidates, softening_bounds, softening_beams, event_log))


def begin_strain_work(
    moving: Moving, cell_strains: CellStrains, elastic_facets: ElasticFacets, wall_constraints: WallConstraints
) -> StepEntry:
    """Finds ∂U/∂factor by the stresses in the poses, where the time of the clock was not reached by a step.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("begin_strain_work", (moving, cell_strains, elastic_facets, wall_constraints))


def bend_layers(
    moving: Moving, wall_constraints: WallConstraints, dilatation_gradients: DilatationGradients
) -> StepEntry:
    """Computes how layers one cell thick are bent at each cell.

    Over elements, in portions.
    """
    return StepEntry("bend_layers", (moving, wall_constraints, dilatation_gradients))


def break_beams(
    moving: Moving, beams: Beams, beam_integrity: BeamIntegrity, candidates: Candidates, postponed: Postponed,
    event_log: EventLog
) -> StepEntry:
    """Removes the beams that fail.

    Over what begins, changes or ends in the step, in order.
    """
    return StepEntry("break_beams", (moving, beams, beam_integrity, candidates, postponed, event_log))


def break_facets(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, facet_release: FacetRelease,
    candidates: Candidates, event_log: EventLog
) -> StepEntry:
    """Removes the facets that fail, and brings the stresses of their cells up to date.

    Over what begins, changes or ends in the step, in order.
    """
    return StepEntry("break_facets", (moving, elastic_facets, wall_constraints, facet_release, candidates, event_log))


def break_pairs(
    moving: Moving, beams: Beams, non_local_bonds: NonLocalBonds, candidates: Candidates, postponed: Postponed,
    event_log: EventLog
) -> StepEntry:
    """Removes the bonds that fail: their force from the kept sums, and the energy of their springs.

    Over what begins, changes or ends in the step, in order.
    """
    return StepEntry("break_pairs", (moving, beams, non_local_bonds, candidates, postponed, event_log))


def carry_cracks(
    stresses_of_cells: StressesOfCells, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Sums b⊗f of the cracks of each cell from their forces of the last step.

    Over cracks or their cells, of which threads may share portions.
    """
    return StepEntry("carry_cracks", (stresses_of_cells, cohesive_cracks, crack_lists))


def check_beams(moving: Moving, beams: Beams, portions: Portions) -> StepEntry:
    """Counts unbroken beams of a portion that are turned beyond the range of their energy, and beyond its end.

    Over bonds, in portions.
    """
    return StepEntry("check_beams", (moving, beams, portions))


def check_facets(moving: Moving, beams: Beams, elastic_facets: ElasticFacets, portions: Portions) -> StepEntry:
    """Counts unbroken facets of a portion that are turned beyond the range of their energy, and beyond its end.

    Over bonds, in portions.
    """
    return StepEntry("check_facets", (moving, beams, elastic_facets, portions))


def check_travel(travel: Travel, walls: Walls, portions: Portions) -> StepEntry:
    """Finds whether the list may miss a contact by now, also where a centre is not a number.

    Over numbers that a body has once, such as those of a record.
    """
    return StepEntry("check_travel", (travel, walls, portions))


def clear_row_forces(rows: Rows) -> StepEntry:
    """Sets the forces of all rows to zero, before loads are added.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("clear_row_forces", (rows,))


def collect_dashpots(step_cut: StepCut, dashpots: Dashpots) -> StepEntry:
    """Adds loads of dashpots of other domains to the sums of shared elements, and sets their rows to zero.

    Over elements that domains share.
    """
    return StepEntry("collect_dashpots", (step_cut, dashpots))


def collect_dilatation(step_cut: StepCut, cell_dilatation: CellDilatation) -> StepEntry:
    """Adds contributions of facets of other domains to V θ of shared cells, and sets their rows to zero.

    Over elements that domains share.
    """
    return StepEntry("collect_dilatation", (step_cut, cell_dilatation))


def collect_facet_moments(step_cut: StepCut, facet_forces: FacetForces) -> StepEntry:
    """Adds moments of facets of other domains to the sums of shared cells, and sets their rows to zero.

    Over elements that domains share.
    """
    return StepEntry("collect_facet_moments", (step_cut, facet_forces))


def collect_moments(step_cut: StepCut, lagged_stresses: LaggedStresses) -> StepEntry:
    """Adds moments of bonds of other domains to the stresses of shared elements, and sets their rows to zero.

    Over elements that domains share.
    """
    return StepEntry("collect_moments", (step_cut, lagged_stresses))


def collect_sums(step_cut: StepCut) -> StepEntry:
    """Adds loads of bonds of other domains to the sums of shared elements, and sets their rows to zero.

    Over elements that domains share.
    """
    return StepEntry("collect_sums", (step_cut,))


def count_wall_work(walls: Walls, portions: Portions) -> StepEntry:
    """Finds the work supplied by walls, for the guard of the energy.

    Over numbers that a body has once, such as those of a record.
    """
    return StepEntry("count_wall_work", (walls, portions))


def find_accelerations(moving: Moving, rows: Rows, step_cut: StepCut, corrected_mass: CorrectedMass) -> StepEntry:
    """Computes the accelerations of the elements by their loads alone.

    Over elements of a block, then shared ones.
    """
    return StepEntry("find_accelerations", (moving, rows, step_cut, corrected_mass))


def find_cell_stresses(moving: Moving, facet_forces: FacetForces, stresses_of_cells: StressesOfCells) -> StepEntry:
    """Finds the mean stresses of cells from the forces of the last step on their facets and cracks.

    Over elements, in portions.
    """
    return StepEntry("find_cell_stresses", (moving, facet_forces, stresses_of_cells))


def find_dilatation_inertia(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, corrected_mass:
    CorrectedMass
) -> StepEntry:
    """Computes ρ β θ̈ of the cells by the accelerations of the elements.

    Over elements, in portions.
    """
    return StepEntry("find_dilatation_inertia", (moving, elastic_facets, wall_constraints, corrected_mass))


def find_inertia_forces(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, corrected_mass:
    CorrectedMass
) -> StepEntry:
    """Computes the forces of the correction on the elements.

    Over elements, in portions.
    """
    return StepEntry("find_inertia_forces", (moving, elastic_facets, wall_constraints, corrected_mass))


def find_non_local_forces(
    moving: Moving, beams: Beams, non_local_bonds: NonLocalBonds, lagged_stresses: LaggedStresses
) -> StepEntry:
    """Finds forces and torques of the bonds of a block, integrates their stored values over the step, and adds
    their moments to the stresses of their elements.

    Over bonds of a block.
    """
    return StepEntry("find_non_local_forces", (moving, beams, non_local_bonds, lagged_stresses))


def find_still_stresses(moving: Moving, facet_forces: FacetForces, stresses_of_cells: StressesOfCells) -> StepEntry:
    """Finds the mean stresses of cells from present forces that were found without a step.

    Over elements, in portions.
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

    Over bonds, in portions.
    """
    return StepEntry("find_stress_candidates", (
        moving, elastic_facets, facet_forces, stresses_of_cells, crack_onset, candidate_facets
    ))


def find_stresses(moving: Moving, lagged_stresses: LaggedStresses) -> StepEntry:
    """Finds the stresses of a portion of elements, and bounds of their principal stresses; sets the moments to
    zero.

    Over elements, in portions.
    """
    return StepEntry("find_stresses", (moving, lagged_stresses))


def find_stresses_of_block(moving: Moving, lagged_stresses: LaggedStresses) -> StepEntry:
    """Finds the stresses of the elements of a block, and bounds of their principal stresses; sets the moments to
    zero.

    Over elements of a block, then shared ones.
    """
    return StepEntry("find_stresses_of_block", (moving, lagged_stresses))


def follow_body_forces(timeline: Timeline, body_forces: BodyForces) -> StepEntry:
    """Brings body forces to the time of the clock.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("follow_body_forces", (timeline, body_forces))


def follow_cell_strains(
    timeline: Timeline, cell_strains: CellStrains, elastic_facets: ElasticFacets, wall_constraints:
    WallConstraints
) -> StepEntry:
    """Sets stress-free strains, and with them the levers of facets and walls, to the time of the clock.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("follow_cell_strains", (timeline, cell_strains, elastic_facets, wall_constraints))


def follow_couples(timeline: Timeline, couple_table: CoupleTable, moving: Moving, rows: Rows) -> StepEntry:
    """Adds moments on regions as forces and torques of their elements.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("follow_couples", (timeline, couple_table, moving, rows))


def follow_drives(timeline: Timeline, drives: Drives, rows: Rows) -> StepEntry:
    """Sets prescribed velocities at the time of the clock, and over the step that begins there.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("follow_drives", (timeline, drives, rows))


def follow_levers(
    cell_strains: CellStrains, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks
) -> StepEntry:
    """Copies levers of facets that strains of cells have changed.

    Over cracks or their cells, of which threads may share portions.
    """
    return StepEntry("follow_levers", (cell_strains, elastic_facets, cohesive_cracks))


def follow_loads(timeline: Timeline, row_loads: RowLoads, moving: Moving, rows: Rows) -> StepEntry:
    """Adds forces and torques of loads to their rows, turned with the element if they follow it.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("follow_loads", (timeline, row_loads, moving, rows))


def follow_strains(timeline: Timeline, strain: Strain, moving: Moving, beams: Beams, rows: Rows) -> StepEntry:
    """Sets rest lengths L (1 + ε*), and adds the work of the strains.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("follow_strains", (timeline, strain, moving, beams, rows))


def follow_tractions(
    timeline: Timeline, facet_tractions: FacetTractions, cell_dilatation: CellDilatation
) -> StepEntry:
    """Brings tractions to the time of the clock.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("follow_tractions", (timeline, facet_tractions, cell_dilatation))


def follow_walls(moving: Moving, wall_constraints: WallConstraints, rows: Rows) -> StepEntry:
    """Brings walls to the time of the clock; at a time that no step has reached, their forces are updated as well.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("follow_walls", (moving, wall_constraints, rows))


def index_candidates_by_cone(stress_candidates: StressCandidates, stress_function: StressFunction) -> StepEntry:
    """Finds the index of each candidate by a criterion on its stress.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("index_candidates_by_cone", (stress_candidates, stress_function))


def index_candidates_by_function(stress_candidates: StressCandidates, stress_function: StressFunction) -> StepEntry:
    """Finds the index of each candidate by a criterion on its stress.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("index_candidates_by_function", (stress_candidates, stress_function))


def index_candidates_by_mean_stress(
    stress_candidates: StressCandidates, stress_function: StressFunction
) -> StepEntry:
    """Finds the index of each candidate by a criterion on its stress.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("index_candidates_by_mean_stress", (stress_candidates, stress_function))


def judge_beams_by_ellipse(
    moving: Moving, beams: Beams, strengths: Strengths, candidates: Candidates, postponed: Postponed
) -> StepEntry:
    """Evaluates marked beams of a block by a criterion, and postpones the elements of failed ones.

    Over bonds of a block.
    """
    return StepEntry("judge_beams_by_ellipse", (moving, beams, strengths, candidates, postponed))


def judge_beams_by_linear_sum(
    moving: Moving, beams: Beams, strengths: Strengths, candidates: Candidates, postponed: Postponed
) -> StepEntry:
    """Evaluates marked beams of a block by a criterion, and postpones the elements of failed ones.

    Over bonds of a block.
    """
    return StepEntry("judge_beams_by_linear_sum", (moving, beams, strengths, candidates, postponed))


def judge_beams_by_mohr_coulomb(
    moving: Moving, beams: Beams, strengths: Strengths, candidates: Candidates, postponed: Postponed
) -> StepEntry:
    """Evaluates marked beams of a block by a criterion, and postpones the elements of failed ones.

    Over bonds of a block.
    """
    return StepEntry("judge_beams_by_mohr_coulomb", (moving, beams, strengths, candidates, postponed))


def judge_beams_by_peripheral_stress(
    moving: Moving, beams: Beams, strengths: Strengths, candidates: Candidates, postponed: Postponed
) -> StepEntry:
    """Evaluates marked beams of a block by a criterion, and postpones the elements of failed ones.

    Over bonds of a block.
    """
    return StepEntry("judge_beams_by_peripheral_stress", (moving, beams, strengths, candidates, postponed))


def judge_cells(
    facet_strengths: FacetStrengths, stresses_of_cells: StressesOfCells, crack_onset: CrackOnset
) -> StepEntry:
    """Finds the cells whose facets may crack: those with cracks, and those whose stress may reach their strength.

    Over elements, in portions.
    """
    return StepEntry("judge_cells", (facet_strengths, stresses_of_cells, crack_onset))


def judge_cells_by_cone(
    stresses_of_cells: StressesOfCells, stress_function: StressFunction, candidate_facets: CandidateFacets,
    crack_onset: CrackOnset
) -> StepEntry:
    """Finds the cells whose facets are evaluated: those whose stress may reach the criterion.

    Over elements, in portions.
    """
    return StepEntry("judge_cells_by_cone", (stresses_of_cells, stress_function, candidate_facets, crack_onset))


def judge_cells_by_mean_stress(
    stresses_of_cells: StressesOfCells, stress_function: StressFunction, candidate_facets: CandidateFacets,
    crack_onset: CrackOnset
) -> StepEntry:
    """Finds the cells whose facets are evaluated: those whose stress may reach the criterion.

    Over elements, in portions.
    """
    return StepEntry("judge_cells_by_mean_stress", (
        stresses_of_cells, stress_function, candidate_facets, crack_onset
    ))


def judge_cells_by_size(
    stresses_of_cells: StressesOfCells, candidate_facets: CandidateFacets, crack_onset: CrackOnset
) -> StepEntry:
    """Finds the cells whose facets are evaluated: those whose stress is large enough for the criterion of a user.

    Over elements, in portions.
    """
    return StepEntry("judge_cells_by_size", (stresses_of_cells, candidate_facets, crack_onset))


def judge_energy(rows: Rows, portions: Portions) -> StepEntry:
    """Finds whether a number is not finite, or the motion has more energy than can have come in.

    Over numbers that a body has once, such as those of a record.
    """
    return StepEntry("judge_energy", (rows, portions))


def judge_facets_by_mohr_coulomb(
    moving: Moving, elastic_facets: ElasticFacets, facet_release: FacetRelease, strengths: Strengths, candidates:
    Candidates, postponed: Postponed
) -> StepEntry:
    """Evaluates marked facets by a criterion at the present stresses, and postpones cells that lose facets and
    their neighbours.

    Over what begins, changes or ends in the step, in order.
    """
    return StepEntry("judge_facets_by_mohr_coulomb", (
        moving, elastic_facets, facet_release, strengths, candidates, postponed
    ))


def judge_pairs(
    beams: Beams, lagged_stresses: LaggedStresses, strengths: Strengths, candidates: Candidates, postponed:
    Postponed
) -> StepEntry:
    """Evaluates marked bonds of a block, and postpones the elements of failed ones.

    Over bonds of a block.
    """
    return StepEntry("judge_pairs", (beams, lagged_stresses, strengths, candidates, postponed))


def keep_dashpots(dashpots: Dashpots, postponed: Postponed) -> StepEntry:
    """Keeps the sums of the dashpots of postponed elements.

    Over postponed elements of a block.
    """
    return StepEntry("keep_dashpots", (dashpots, postponed))


def keep_measures(near_pairs: NearPairs, travel: Travel) -> StepEntry:
    """Stores distances that were measured in a step.

    Over numbers that a body has once, such as those of a record.
    """
    return StepEntry("keep_measures", (near_pairs, travel))


def keep_sums(step_cut: StepCut, postponed: Postponed) -> StepEntry:
    """Keeps the sums of postponed elements.

    Over postponed elements of a block.
    """
    return StepEntry("keep_sums", (step_cut, postponed))


def leave_cracks(
    moving: Moving, elastic_facets: ElasticFacets, cell_dilatation: CellDilatation, cell_slack: CellSlack,
    cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Puts cracks to rest, or parts their faces, as `soften_cracks` has found.

    Over cracks or their cells, of which threads may share portions.
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

    Over cracks or their cells, of which threads may share portions.
    """
    return StepEntry("link_cracks", (elastic_facets, facet_forces, facet_strengths, cohesive_cracks, crack_lists))


def list_cracks(elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists) -> StepEntry:
    """Renews lists of cracks that are out of date.

    Over cracks or their cells, of which threads may share portions.
    """
    return StepEntry("list_cracks", (elastic_facets, cohesive_cracks, crack_lists))


def list_postponed(rows: Rows, candidates: Candidates, postponed: Postponed) -> StepEntry:
    """Lists all postponed elements, those with rows of the boundary last, and ends the failures of the step.

    Over elements of a block, which it divides.
    """
    return StepEntry("list_postponed", (rows, candidates, postponed))


def load_cracks(
    moving: Moving, elastic_facets: ElasticFacets, facet_strengths: FacetStrengths, stresses_of_cells:
    StressesOfCells, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Computes forces, torques and dissipation of the cracks that are treated one by one.

    Over cracks or their cells, of which threads may share portions.
    """
    return StepEntry("load_cracks", (
        moving, elastic_facets, facet_strengths, stresses_of_cells, cohesive_cracks, crack_lists
    ))


def load_walls(wall_contacts: WallContacts, wall_motions: WallMotions, walls: Walls) -> StepEntry:
    """Sums the forces of elements on walls, adds their work, and closes the step of free walls.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("load_walls", (wall_contacts, wall_motions, walls))


def log_cracks(
    moving: Moving, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists,
    event_log: EventLog
) -> StepEntry:
    """Adds up the dissipation of cracks, and logs cracks without integrity.

    Over what begins, changes or ends in the step, in order.
    """
    return StepEntry("log_cracks", (moving, elastic_facets, cohesive_cracks, crack_lists, event_log))


def log_softened_beams(
    moving: Moving, beams: Beams, softening_beams: SofteningBeams, event_log: EventLog
) -> StepEntry:
    """Adds up the dissipation of all portions, and logs broken beams.

    Over what begins, changes or ends in the step, in order.
    """
    return StepEntry("log_softened_beams", (moving, beams, softening_beams, event_log))


def mark_cracking_facets(
    moving: Moving, elastic_facets: ElasticFacets, facet_forces: FacetForces, facet_strengths: FacetStrengths,
    stresses_of_cells: StressesOfCells, crack_onset: CrackOnset
) -> StepEntry:
    """Marks facets of the material that begin to crack.

    Over bonds, in portions.
    """
    return StepEntry("mark_cracking_facets", (
        moving, elastic_facets, facet_forces, facet_strengths, stresses_of_cells, crack_onset
    ))


def mark_cracking_planes(
    moving: Moving, elastic_facets: ElasticFacets, facet_forces: FacetForces, facet_strengths: FacetStrengths,
    crack_onset: CrackOnset
) -> StepEntry:
    """Marks facets of planes, such as joints, that begin to crack.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("mark_cracking_planes", (moving, elastic_facets, facet_forces, facet_strengths, crack_onset))


def mark_failing_facets(
    moving: Moving, elastic_facets: ElasticFacets, facet_forces: FacetForces, stresses_of_cells: StressesOfCells,
    crack_onset: CrackOnset, candidate_facets: CandidateFacets
) -> StepEntry:
    """Marks candidates that fail, and leaves these with the mean stress of their cells, of which the index gives
    their strength.

    Over what begins, changes or ends in the step, in order.
    """
    return StepEntry("mark_failing_facets", (
        moving, elastic_facets, facet_forces, stresses_of_cells, crack_onset, candidate_facets
    ))


def mark_pairs(
    beams: Beams, lagged_stresses: LaggedStresses, strengths: Strengths, candidates: Candidates
) -> StepEntry:
    """Marks the bonds of a block that reach their criterion by bounds of the principal stresses of both elements.

    Over bonds of a block.
    """
    return StepEntry("mark_pairs", (beams, lagged_stresses, strengths, candidates))


def measure_cracks(
    moving: Moving, elastic_facets: ElasticFacets, cell_slack: CellSlack, stresses_of_cells: StressesOfCells,
    cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Finds faces and halves of the cracks that are treated one by one, and axes of cracks before any loss of
    integrity.

    Over cracks or their cells, of which threads may share portions.
    """
    return StepEntry("measure_cracks", (
        moving, elastic_facets, cell_slack, stresses_of_cells, cohesive_cracks, crack_lists
    ))


def measure_travel(moving: Moving, travel: Travel) -> StepEntry:
    """Finds the distances of the elements of a portion from their places at the last measurement.

    Over elements, in portions.
    """
    return StepEntry("measure_travel", (moving, travel))


def measure_wall_overlaps(
    moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts, walls: Walls, near_pairs:
    NearPairs, travel: Travel
) -> StepEntry:
    """Keeps the deepest overlap of the elements of a portion with a wall, over the radius, if distances are
    measured in this step.

    Over elements, in portions.
    """
    return StepEntry("measure_wall_overlaps", (moving, contact_constants, wall_contacts, walls, near_pairs, travel))


def move_elements(moving: Moving, step_cut: StepCut) -> StepEntry:
    """Closes the step, and opens the next, for elements that own no row of the boundary.

    Over elements of a block, then shared ones.
    """
    return StepEntry("move_elements", (moving, step_cut))


def move_resisted(moving: Moving, step_cut: StepCut, resistance: Resistance) -> StepEntry:
    """Closes the step, and opens the next, for damped elements that own no row of the boundary.

    Over elements of a block, then shared ones.
    """
    return StepEntry("move_resisted", (moving, step_cut, resistance))


def move_resisted_rows(moving: Moving, step_cut: StepCut, rows: Rows, resistance: Resistance) -> StepEntry:
    """Closes the step, and opens the next, for damped elements that own rows of the boundary.

    Over elements of a block, then shared ones.
    """
    return StepEntry("move_resisted_rows", (moving, step_cut, rows, resistance))


def move_rows(moving: Moving, step_cut: StepCut, rows: Rows) -> StepEntry:
    """Closes the step, and opens the next, for elements that own rows of the boundary.

    Over elements of a block, then shared ones.
    """
    return StepEntry("move_rows", (moving, step_cut, rows))


def move_walls(wall_motions: WallMotions, walls: Walls) -> StepEntry:
    """Moves walls to the end of the step that begins at the time of the clock.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("move_walls", (wall_motions, walls))


def open_body_work(moving: Moving, body_forces: BodyForces) -> StepEntry:
    """Adds the work of body forces over the half of the step that begins after a pause.

    Over elements, in portions.
    """
    return StepEntry("open_body_work", (moving, body_forces))


def open_elements(moving: Moving) -> StepEntry:
    """Opens a step after a pause for all elements, none of which owns a row of the boundary.

    Over elements, in portions.
    """
    return StepEntry("open_elements", (moving,))


def open_elements_and_rows(moving: Moving, rows: Rows) -> StepEntry:
    """Opens a step after a pause for all elements, some of which own rows of the boundary.

    Over elements, in portions.
    """
    return StepEntry("open_elements_and_rows", (moving, rows))


def postpone_elements(step_cut: StepCut, candidates: Candidates, postponed: Postponed) -> StepEntry:
    """Divides the elements of a block, or shared ones, into those that continue and those that are postponed.

    Over elements of a block, which it divides.
    """
    return StepEntry("postpone_elements", (step_cut, candidates, postponed))


def press_pairs(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, near_pairs: NearPairs,
    travel: Travel
) -> StepEntry:
    """Finds forces and memory of the pairs of a portion of elements; renews the list of near pairs where elements
    have moved too far.

    Over elements, in portions.
    """
    return StepEntry("press_pairs", (moving, contact_constants, contact_pairs, near_pairs, travel))


def press_pairs_and_faces(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, near_pairs: NearPairs,
    travel: Travel, face_pairs: FacePairs
) -> StepEntry:
    """Finds forces and memory of the pairs of a portion of cells with cracks, which touch by faces too.

    Over elements, in portions.
    """
    return StepEntry("press_pairs_and_faces", (
        moving, contact_constants, contact_pairs, near_pairs, travel, face_pairs
    ))


def press_walls(
    moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts, walls: Walls, contact_sums:
    ContactSums
) -> StepEntry:
    """Adds forces of walls to the elements of a portion, and keeps their memory.

    Over elements, in portions.
    """
    return StepEntry("press_walls", (moving, contact_constants, wall_contacts, walls, contact_sums))


def read_gauges(moving: Moving, rows: Rows, gauges: Gauges, history_rows: HistoryRows) -> StepEntry:
    """Writes three components of each gauge of elements.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("read_gauges", (moving, rows, gauges, history_rows))


def relax_cracked_cells(moving: Moving, cell_dilatation: CellDilatation, crack_lists: CrackLists) -> StepEntry:
    """Finds the stresses of all cells with cracks that are treated one by one.

    Over cracks or their cells, of which threads may share portions.
    """
    return StepEntry("relax_cracked_cells", (moving, cell_dilatation, crack_lists))


def relax_stale_cells(moving: Moving, cell_dilatation: CellDilatation, crack_lists: CrackLists) -> StepEntry:
    """Finds the stresses of cells with cracks that are out of date.

    Over cracks or their cells, of which threads may share portions.
    """
    return StepEntry("relax_stale_cells", (moving, cell_dilatation, crack_lists))


def release_pressure(event_log: EventLog, softening_bounds: SofteningBounds) -> StepEntry:
    """Ends the pressure on softening beams that have broken at the beginning of this step.

    Over what begins, changes or ends in the step, in order.
    """
    return StepEntry("release_pressure", (event_log, softening_bounds))


def relieve_pairs(
    moving: Moving, beams: Beams, non_local_bonds: NonLocalBonds, lagged_stresses: LaggedStresses, beam_integrity:
    BeamIntegrity, candidates: Candidates
) -> StepEntry:
    """Subtracts the force of failed bonds from the stresses of their elements, and sets their integrity to 0;
    after `break_pairs`.

    Over what begins, changes or ends in the step, in order.
    """
    return StepEntry("relieve_pairs", (moving, beams, non_local_bonds, lagged_stresses, beam_integrity, candidates))


def renew_wall_rows(wall_constraints: WallConstraints, rows: Rows, candidates: Candidates) -> StepEntry:
    """Updates the forces of walls on the rows of their cells.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("renew_wall_rows", (wall_constraints, rows, candidates))


def reopen_elements(moving: Moving) -> StepEntry:
    """Opens a step for elements of a list that own no row of the boundary.

    Over elements of a block, then shared ones.
    """
    return StepEntry("reopen_elements", (moving,))


def reopen_rows(moving: Moving, rows: Rows) -> StepEntry:
    """Opens a step for elements of a list that own rows of the boundary.

    Over elements of a block, then shared ones.
    """
    return StepEntry("reopen_rows", (moving, rows))


def restore_facets(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, facet_release: FacetRelease,
    candidates: Candidates, postponed: Postponed
) -> StepEntry:
    """Adds the loads of the remaining facets and of walls to the kept sums.

    Over what begins, changes or ends in the step, in order.
    """
    return StepEntry("restore_facets", (
        moving, elastic_facets, wall_constraints, facet_release, candidates, postponed
    ))


def roll_at_walls(
    moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts, walls: Walls, rolled_walls:
    RolledWalls, contact_sums: ContactSums
) -> StepEntry:
    """Finds moments of resistance to rolling of a portion of elements at walls.

    Over elements, in portions.
    """
    return StepEntry("roll_at_walls", (moving, contact_constants, wall_contacts, walls, rolled_walls, contact_sums))


def roll_pairs(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, near_pairs: NearPairs,
    rolled_pairs: RolledPairs
) -> StepEntry:
    """Finds moments and memory of the pairs of a portion of elements that touch and may roll.

    Over elements, in portions.
    """
    return StepEntry("roll_pairs", (moving, contact_constants, contact_pairs, near_pairs, rolled_pairs))


def slide_cracks(
    moving: Moving, elastic_facets: ElasticFacets, stresses_of_cells: StressesOfCells, cohesive_cracks:
    CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Sums the forces of the cracks of each cell, and lets their faces slip by them.

    Over cracks or their cells, of which threads may share portions.
    """
    return StepEntry("slide_cracks", (moving, elastic_facets, stresses_of_cells, cohesive_cracks, crack_lists))


def soften_beams(
    moving: Moving, beams: Beams, softening_bounds: SofteningBounds, softening_beams: SofteningBeams
) -> StepEntry:
    """Lowers the integrity of beams of a portion that soften, before the forces.

    Over bonds, in portions.
    """
    return StepEntry("soften_beams", (moving, beams, softening_bounds, softening_beams))


def soften_cracks(
    moving: Moving, elastic_facets: ElasticFacets, facet_strengths: FacetStrengths, stresses_of_cells:
    StressesOfCells, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Lowers the integrities of cracks, and finds those that go to rest.

    Over cracks or their cells, of which threads may share portions.
    """
    return StepEntry("soften_cracks", (
        moving, elastic_facets, facet_strengths, stresses_of_cells, cohesive_cracks, crack_lists
    ))


def stress_cells(moving: Moving, cell_dilatation: CellDilatation) -> StepEntry:
    """Sets the stresses of cells by their complete V θ, which is set to zero.

    Over elements of a block, then shared ones.
    """
    return StepEntry("stress_cells", (moving, cell_dilatation))


def stretch_all_cells(
    elastic_facets: ElasticFacets, facets_of_cells: FacetsOfCells, yielding_cells: YieldingCells
) -> StepEntry:
    """Stretches levers of all facets with the plastic deformation of their cells, as a run begins.

    Over elements, in portions.
    """
    return StepEntry("stretch_all_cells", (elastic_facets, facets_of_cells, yielding_cells))


def stretch_anew(
    cell_strains: CellStrains, elastic_facets: ElasticFacets, facets_of_cells: FacetsOfCells, wall_constraints:
    WallConstraints, yielding_cells: YieldingCells
) -> StepEntry:
    """Stretches levers with the plastic deformation of their cells, where stress-free strains have set them anew.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("stretch_anew", (
        cell_strains, elastic_facets, facets_of_cells, wall_constraints, yielding_cells
    ))


def stretch_cells(
    elastic_facets: ElasticFacets, facets_of_cells: FacetsOfCells, yielding_cells: YieldingCells
) -> StepEntry:
    """Stretches levers of facets with the plastic deformation of their cells, where it has grown.

    Over elements, in portions.
    """
    return StepEntry("stretch_cells", (elastic_facets, facets_of_cells, yielding_cells))


def stretch_walls_and_cracks(
    elastic_facets: ElasticFacets, wall_constraints: WallConstraints, yielding_cells: YieldingCells,
    cohesive_cracks: CohesiveCracks
) -> StepEntry:
    """Stretches levers of walls and cracks with the plastic deformation of their cells, where it has grown.

    Over cracks or their cells, of which threads may share portions.
    """
    return StepEntry("stretch_walls_and_cracks", (elastic_facets, wall_constraints, yielding_cells, cohesive_cracks))


def subtract_dilatation_energies(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, corrected_mass:
    CorrectedMass, portions: Portions
) -> StepEntry:
    """Subtracts the correction of the mass from the kinetic energies of cells.

    Over elements, in portions.
    """
    return StepEntry("subtract_dilatation_energies", (
        moving, elastic_facets, wall_constraints, corrected_mass, portions
    ))


def sum_adhesion_at_walls(
    moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts, walls: Walls,
    contact_energies: ContactEnergies
) -> StepEntry:
    """Adds the energy of adhesion at walls of a portion of elements, below 0 [J].

    Over elements, in portions.
    """
    return StepEntry("sum_adhesion_at_walls", (moving, contact_constants, wall_contacts, walls, contact_energies))


def sum_adhesion_energies(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, contact_energies:
    ContactEnergies
) -> StepEntry:
    """Adds the energy of adhesion of the pairs of a portion, below 0 [J].

    Over elements, in portions.
    """
    return StepEntry("sum_adhesion_energies", (moving, contact_constants, contact_pairs, contact_energies))


def sum_beam_energies(moving: Moving, beams: Beams, portions: Portions) -> StepEntry:
    """Sums normal, shear, bending and twisting energy of a portion [J].

    Over bonds, in portions.
    """
    return StepEntry("sum_beam_energies", (moving, beams, portions))


def sum_crack_energies(
    moving: Moving, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks, crack_energies: CrackEnergies
) -> StepEntry:
    """Sums the energies of the cracks that are treated one by one [J].

    Over cracks or their cells, of which threads may share portions.
    """
    return StepEntry("sum_crack_energies", (moving, elastic_facets, cohesive_cracks, crack_energies))


def sum_crack_powers(
    moving: Moving, cell_strains: CellStrains, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks
) -> StepEntry:
    """Sets ∂U/∂factor of the stress-free strains at cracks that are treated one by one, where it is needed.

    Over cracks or their cells, of which threads may share portions.
    """
    return StepEntry("sum_crack_powers", (moving, cell_strains, elastic_facets, cohesive_cracks))


def sum_dilatation_energies(cell_dilatation: CellDilatation, dilatation_energy: DilatationEnergy) -> StepEntry:
    """Sums the energy of dilatation of a portion of cells, whose V θ is complete and is set to zero [J].

    Over elements, in portions.
    """
    return StepEntry("sum_dilatation_energies", (cell_dilatation, dilatation_energy))


def sum_element_energies(moving: Moving, portions: Portions) -> StepEntry:
    """Sums kinetic energies and losses of a portion [J].

    Over elements, in portions.
    """
    return StepEntry("sum_element_energies", (moving, portions))


def sum_face_energies(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, face_pairs: FacePairs,
    contact_energies: ContactEnergies
) -> StepEntry:
    """Adds the elastic energy of the pairs of a portion that touch by faces [J].

    Over elements, in portions.
    """
    return StepEntry("sum_face_energies", (moving, contact_constants, contact_pairs, face_pairs, contact_energies))


def sum_facet_energies(moving: Moving, elastic_facets: ElasticFacets, portions: Portions) -> StepEntry:
    """Sums normal, shear, bending and twisting energy of the facets of a portion, without dilatation [J].

    Over bonds, in portions.
    """
    return StepEntry("sum_facet_energies", (moving, elastic_facets, portions))


def sum_gradient_energies(
    moving: Moving, cell_dilatation: CellDilatation, wall_constraints: WallConstraints, dilatation_gradients:
    DilatationGradients
) -> StepEntry:
    """Sums the energies of gradients in portions of cells, for the dilatation that facets have added up.

    Over elements, in portions.
    """
    return StepEntry("sum_gradient_energies", (moving, cell_dilatation, wall_constraints, dilatation_gradients))


def sum_heat(
    stresses_of_cells: StressesOfCells, yielding_cells: YieldingCells, crack_energies: CrackEnergies
) -> StepEntry:
    """Sums the energy that the cells of a portion have dissipated by yielding [J].

    Over elements, in portions.
    """
    return StepEntry("sum_heat", (stresses_of_cells, yielding_cells, crack_energies))


def sum_moments(
    moving: Moving, elastic_facets: ElasticFacets, facets_of_cells: FacetsOfCells, facet_forces: FacetForces
) -> StepEntry:
    """Finds V σ of cells from stored forces at the start of a run, with the bits of the sums of a step.

    Over elements, in portions.
    """
    return StepEntry("sum_moments", (moving, elastic_facets, facets_of_cells, facet_forces))


def sum_non_local_energies(
    moving: Moving, beams: Beams, non_local_bonds: NonLocalBonds, portions: Portions, non_local_work: NonLocalWork
) -> StepEntry:
    """Sums normal and shear energy of the springs of a portion, and the work of extra forces [J].

    Over bonds, in portions.
    """
    return StepEntry("sum_non_local_energies", (moving, beams, non_local_bonds, portions, non_local_work))


def sum_pair_energies(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, contact_energies:
    ContactEnergies
) -> StepEntry:
    """Sums the elastic energy of the pairs of a portion [J].

    Over elements, in portions.
    """
    return StepEntry("sum_pair_energies", (moving, contact_constants, contact_pairs, contact_energies))


def sum_pressed_energies(
    moving: Moving, beams: Beams, softening_bounds: SofteningBounds, portions: Portions
) -> StepEntry:
    """Adds the energy of the pressure on softened beams of a portion to their normal energy.

    Over bonds, in portions.
    """
    return StepEntry("sum_pressed_energies", (moving, beams, softening_bounds, portions))


def sum_rolling_at_walls(
    contact_constants: ContactConstants, wall_contacts: WallContacts, rolled_walls: RolledWalls, contact_energies:
    ContactEnergies
) -> StepEntry:
    """Adds the energy that springs of rolling store at walls, of a portion of elements [J].

    Over elements, in portions.
    """
    return StepEntry("sum_rolling_at_walls", (contact_constants, wall_contacts, rolled_walls, contact_energies))


def sum_rolling_energies(
    contact_constants: ContactConstants, contact_pairs: ContactPairs, rolled_pairs: RolledPairs, contact_energies:
    ContactEnergies
) -> StepEntry:
    """Adds the energy that springs of rolling store in the pairs of a portion [J].

    Over elements, in portions.
    """
    return StepEntry("sum_rolling_energies", (contact_constants, contact_pairs, rolled_pairs, contact_energies))


def sum_stored_energies(moving: Moving, beams: Beams, stored_loads: StoredLoads, portions: Portions) -> StepEntry:
    """Sums normal, shear, bending and twisting energy of a portion [J].

    Over bonds, in portions.
    """
    return StepEntry("sum_stored_energies", (moving, beams, stored_loads, portions))


def sum_strain_powers(moving: Moving, cell_strains: CellStrains, elastic_facets: ElasticFacets) -> StepEntry:
    """Sums ∂U/∂factor of the facets of a portion, where it is needed.

    Over bonds, in portions.
    """
    return StepEntry("sum_strain_powers", (moving, cell_strains, elastic_facets))


def sum_stress_differences(moving: Moving, dilatation_gradients: DilatationGradients) -> StepEntry:
    """Sums the differences between the stresses of each cell and those of its neighbours.

    Over elements, in portions.
    """
    return StepEntry("sum_stress_differences", (moving, dilatation_gradients))


def sum_stressed_dilatation(
    moving: Moving, cell_dilatation: CellDilatation, crack_energies: CrackEnergies
) -> StepEntry:
    """Sums the energy of dilatation of a portion of cells by their stresses [J].

    Over elements, in portions.
    """
    return StepEntry("sum_stressed_dilatation", (moving, cell_dilatation, crack_energies))


def sum_wall_energies(
    moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts, walls: Walls,
    contact_energies: ContactEnergies
) -> StepEntry:
    """Adds the elastic energy of contacts of a portion with walls [J].

    Over elements, in portions.
    """
    return StepEntry("sum_wall_energies", (moving, contact_constants, wall_contacts, walls, contact_energies))


def take_moments(facet_forces: FacetForces) -> StepEntry:
    """Sets V σ and Σ `bending_square` of cells from their complete sums, which are set to zero.

    Over elements of a block, then shared ones.
    """
    return StepEntry("take_moments", (facet_forces,))


def touch_parted_faces(
    moving: Moving, contact_pairs: ContactPairs, near_pairs: NearPairs, cohesive_cracks: CohesiveCracks,
    crack_lists: CrackLists, parted_reach: PartedReach
) -> StepEntry:
    """Makes pairs of the cells whose faces have parted in this step.

    Over what begins, changes or ends in the step, in order.
    """
    return StepEntry("touch_parted_faces", (
        moving, contact_pairs, near_pairs, cohesive_cracks, crack_lists, parted_reach
    ))


def turn_stresses(moving: Moving, lagged_stresses: LaggedStresses) -> StepEntry:
    """Turns the stresses of a step ago with their elements.

    Over elements, in portions.
    """
    return StepEntry("turn_stresses", (moving, lagged_stresses))


def twist_layers(
    moving: Moving, wall_constraints: WallConstraints, dilatation_gradients: DilatationGradients
) -> StepEntry:
    """Computes the torques of bent layers on each cell.

    Over elements, in portions.
    """
    return StepEntry("twist_layers", (moving, wall_constraints, dilatation_gradients))


def wake_cracks(
    moving: Moving, elastic_facets: ElasticFacets, cell_dilatation: CellDilatation, cell_slack: CellSlack,
    cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Treats resting cracks one by one again that are about to soften or close.

    Over cracks or their cells, of which threads may share portions.
    """
    return StepEntry("wake_cracks", (
        moving, elastic_facets, cell_dilatation, cell_slack, cohesive_cracks, crack_lists
    ))


def watch_resting_cracks(
    moving: Moving, elastic_facets: ElasticFacets, facet_strengths: FacetStrengths, cohesive_cracks:
    CohesiveCracks, crack_lists: CrackLists
) -> StepEntry:
    """Finds the resting cracks that are about to soften or close.

    Over cracks or their cells, of which threads may share portions.
    """
    return StepEntry("watch_resting_cracks", (moving, elastic_facets, facet_strengths, cohesive_cracks, crack_lists))


def weigh_cracked_cells(
    elastic_facets: ElasticFacets, cell_dilatation: CellDilatation, cell_slack: CellSlack, cohesive_cracks:
    CohesiveCracks
) -> StepEntry:
    """Computes the weights of the cells of all cracks at the start of a run.

    Over cracks or their cells, of which threads may share portions.
    """
    return StepEntry("weigh_cracked_cells", (elastic_facets, cell_dilatation, cell_slack, cohesive_cracks))


def withdraw_dashpots(
    moving: Moving, beams: Beams, dashpots: Dashpots, candidates: Candidates, postponed: Postponed
) -> StepEntry:
    """Subtracts dashpots of failed beams from the kept sums of their ends, before the beams are removed.

    Over what begins, changes or ends in the step, in order.
    """
    return StepEntry("withdraw_dashpots", (moving, beams, dashpots, candidates, postponed))


def withdraw_facets(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, facet_release: FacetRelease,
    candidates: Candidates, postponed: Postponed
) -> StepEntry:
    """Lists the cells whose loads change, and subtracts the loads of their facets and walls from the kept sums.

    Over what begins, changes or ends in the step, in order.
    """
    return StepEntry("withdraw_facets", (
        moving, elastic_facets, wall_constraints, facet_release, candidates, postponed
    ))


def write_contact_energy(contact_energies: ContactEnergies, history_rows: HistoryRows) -> StepEntry:
    """Adds the energy of contacts to a record.

    Over numbers that a body has once, such as those of a record.
    """
    return StepEntry("write_contact_energy", (contact_energies, history_rows))


def write_crushing_of_beams(
    softening_bounds: SofteningBounds, softening_beams: SofteningBeams, event_log: EventLog, history_rows:
    HistoryRows
) -> StepEntry:
    """Writes the energy that beams have released beyond their fracture energy.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("write_crushing_of_beams", (softening_bounds, softening_beams, event_log, history_rows))


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


def write_ledger(rows: Rows, portions: Portions, history_rows: HistoryRows) -> StepEntry:
    """Writes time and the entries of the energy balance.

    Over numbers that a body has once, such as those of a record.
    """
    return StepEntry("write_ledger", (rows, portions, history_rows))


def write_non_local_work(non_local_work: NonLocalWork, history_rows: HistoryRows) -> StepEntry:
    """Writes the work of the extra forces of bonds to the energy balance.

    Over numbers that a body has once, such as those of a record.
    """
    return StepEntry("write_non_local_work", (non_local_work, history_rows))


def write_released(event_log: EventLog, history_rows: HistoryRows) -> StepEntry:
    """Writes the energy released into a record.

    Over numbers that a body has once, such as those of a record.
    """
    return StepEntry("write_released", (event_log, history_rows))


def write_walls(walls: Walls, gauges: Gauges, history_rows: HistoryRows) -> StepEntry:
    """Adds the work of walls to a record, and writes gauges of walls.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("write_walls", (walls, gauges, history_rows))


def yield_cells(
    moving: Moving, facet_strengths: FacetStrengths, stresses_of_cells: StressesOfCells, yielding_cells:
    YieldingCells, crack_onset: CrackOnset
) -> StepEntry:
    """Lets the cells of a portion yield whose stress reaches their yield surface.

    Over elements, in portions.
    """
    return StepEntry("yield_cells", (moving, facet_strengths, stresses_of_cells, yielding_cells, crack_onset))


#: Passes `add_alike_beam_loads_softening_by_…` by the name of their criterion.
ADD_ALIKE_BEAM_LOADS_SOFTENING_BY = {
    "mohr_coulomb": add_alike_beam_loads_softening_by_mohr_coulomb,
    "peripheral_stress": add_alike_beam_loads_softening_by_peripheral_stress,
}
#: Passes `add_beam_loads_softening_by_…` by the name of their criterion.
ADD_BEAM_LOADS_SOFTENING_BY = {
    "mohr_coulomb": add_beam_loads_softening_by_mohr_coulomb,
    "peripheral_stress": add_beam_loads_softening_by_peripheral_stress,
}
#: Passes `index_candidates_by_…` by the name of their criterion.
INDEX_CANDIDATES_BY = {
    "cone": index_candidates_by_cone,
    "function": index_candidates_by_function,
    "mean_stress": index_candidates_by_mean_stress,
}
#: Passes `judge_beams_by_…` by the name of their criterion.
JUDGE_BEAMS_BY = {
    "ellipse": judge_beams_by_ellipse,
    "linear_sum": judge_beams_by_linear_sum,
    "mohr_coulomb": judge_beams_by_mohr_coulomb,
    "peripheral_stress": judge_beams_by_peripheral_stress,
}
#: Passes `judge_facets_by_…` by the name of their criterion.
JUDGE_FACETS_BY = {
    "mohr_coulomb": judge_facets_by_mohr_coulomb,
}
