"""Passes over an index, for devices; written by `python -m tests.core.passes`: change the core instead."""

from bondem._passes import Kernel
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
from bondem._tables.device_tables import (
    BegunFaces,
    BondMarks,
    BondsOfElements,
    CrackPortions,
    CrushingPortions,
    DeviceSpan,
    EarlierPairs,
    FacetArms,
    FoldedPortions,
    GaugeParts,
    LoadsOfBonds,
    LossesOfCracks,
    RowOrder,
    SofteningLosses,
    StrainPortions,
    Tick,
    WallEnergy,
    WorkPortions,
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
    StepScheme,
    Strain,
    Timeline,
)
from bondem._tables.stress_onset_tables import CandidateFacets


def add_adhesion_of_element(
    contact_pairs: ContactPairs, earlier_pairs: EarlierPairs, adhering_pairs: AdheringPairs, contact_sums:
    ContactSums
) -> Kernel:
    """Adds adhesion to the elements of a range.

    Over one index, in `core/gpu/adhesion.hpp`.
    """
    return Kernel("add_adhesion_of_element", (contact_pairs, earlier_pairs, adhering_pairs, contact_sums))


def add_all_begun_contacts(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs,
    lagged_stresses: LaggedStresses, event_log: EventLog
) -> Kernel:
    """Adds new contacts to the stresses of the ends of bonds that have failed in this step, after these contacts
    have begun.

    Over one index, in `core/gpu/non_local_pairs.hpp`.
    """
    return Kernel("add_all_begun_contacts", (
        device_span, moving, contact_constants, contact_pairs, lagged_stresses, event_log
    ))


def add_begun_contacts_of_element(
    bonds_of_elements: BondsOfElements, bond_marks: BondMarks, contact_constants: ContactConstants, contact_pairs:
    ContactPairs, near_pairs: NearPairs, event_log: EventLog, postponed: Postponed
) -> Kernel:
    """Launched for `begin_contacts`: begins contact where beams have broken in this step, on the sums that are
    kept for their ends.

    Over one index, in `core/gpu/begun_contacts.hpp`.
    """
    return Kernel("add_begun_contacts_of_element", (
        bonds_of_elements, bond_marks, contact_constants, contact_pairs, near_pairs, event_log, postponed
    ))


def add_body_force(device_span: DeviceSpan, moving: Moving, step_cut: StepCut, body_forces: BodyForces) -> Kernel:
    """Adds body forces to the sums, and their work over the half of the step that ends.

    Over one index, in `core/gpu/motion.hpp`.
    """
    return Kernel("add_body_force", (device_span, moving, step_cut, body_forces))


def add_contact_load(device_span: DeviceSpan, moving: Moving, step_cut: StepCut, contact_sums: ContactSums) -> Kernel:
    """Adds forces and losses of contacts to those of the elements, and sets the former to zero.

    Over one index, in `core/gpu/contacts.hpp`.
    """
    return Kernel("add_contact_load", (device_span, moving, step_cut, contact_sums))


def add_crack_load(device_span: DeviceSpan, moving: Moving, crack_lists: CrackLists, step_cut: StepCut) -> Kernel:
    """Adds the forces of cracks that are treated one by one to the sums of their cells.

    Over one index, in `core/gpu/cracks.hpp`.
    """
    return Kernel("add_crack_load", (device_span, moving, crack_lists, step_cut))


def add_crack_powers(cell_strains: CellStrains, strain_portions: StrainPortions) -> Kernel:
    """Adds up the portions of strain g."""
    return Kernel("add_crack_powers", (cell_strains, strain_portions))


def add_energies(dilatation_energy: DilatationEnergy, wall_energy: WallEnergy, portions: Portions) -> Kernel:
    """Launched for `add_cell_energies`: adds the energy of dilatation, and that of half facets at walls, to the
    normal energy of the first portion of facets.

    Over one index, in `core/gpu/cells.hpp`.
    """
    return Kernel("add_energies", (dilatation_energy, wall_energy, portions))


def add_energies_of_cracks(
    wall_energy: WallEnergy, crack_energies: CrackEnergies, crack_portions: CrackPortions, portions: Portions
) -> Kernel:
    """Launched for `add_crack_energies`: adds the energies of cracks and walls to those of the first portion of
    facets.

    Over one index, in `core/gpu/crack_report.hpp`.
    """
    return Kernel("add_energies_of_cracks", (wall_energy, crack_energies, crack_portions, portions))


def add_faces_of_element(contact_pairs: ContactPairs, face_pairs: FacePairs, contact_sums: ContactSums) -> Kernel:
    """Adds forces of faces on element p: of pairs whose later element it is, then of pairs whose earlier element
    it is.
    """
    return Kernel("add_faces_of_element", (contact_pairs, face_pairs, contact_sums))


def add_gradient_energy(dilatation_gradients: DilatationGradients, portions: Portions) -> Kernel:
    """Adds the energies of gradients to those of the facets.

    Over one index, in `core/gpu/cells.hpp`.
    """
    return Kernel("add_gradient_energy", (dilatation_gradients, portions))


def add_inertia_force_of(corrected_mass: CorrectedMass, step_cut: StepCut) -> Kernel:
    """Adds the forces of the correction to the sums of the elements.

    Over one index, in `core/gpu/cells.hpp`.
    """
    return Kernel("add_inertia_force_of", (corrected_mass, step_cut))


def add_layer_torque(dilatation_gradients: DilatationGradients, step_cut: StepCut) -> Kernel:
    """Adds the torques of bent layers to the sums of the cells.

    Over one index, in `core/gpu/cells.hpp`.
    """
    return Kernel("add_layer_torque", (dilatation_gradients, step_cut))


def add_pair_moments_of_element(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, earlier_pairs: EarlierPairs,
    near_pairs: NearPairs, lagged_stresses: LaggedStresses
) -> Kernel:
    """Adds what pairs do to the stress of element p: those whose later element it is, then those whose earlier
    one.
    """
    return Kernel("add_pair_moments_of_element", (
        moving, contact_constants, contact_pairs, earlier_pairs, near_pairs, lagged_stresses
    ))


def add_pairs_of_element(
    contact_constants: ContactConstants, contact_pairs: ContactPairs, earlier_pairs: EarlierPairs, near_pairs:
    NearPairs, contact_sums: ContactSums
) -> Kernel:
    """Adds forces of pairs on element p in their order: as the later element of a pair, then as the earlier one."""
    return Kernel("add_pairs_of_element", (contact_constants, contact_pairs, earlier_pairs, near_pairs, contact_sums))


def add_rolling_of_element(
    contact_pairs: ContactPairs, earlier_pairs: EarlierPairs, rolled_pairs: RolledPairs, contact_sums: ContactSums
) -> Kernel:
    """Adds moments of resistance to rolling to the elements of a range.

    Over one index, in `core/gpu/rolling.hpp`.
    """
    return Kernel("add_rolling_of_element", (contact_pairs, earlier_pairs, rolled_pairs, contact_sums))


def add_still_surface_stress(
    device_span: DeviceSpan, moving: Moving, wall_constraints: WallConstraints, row_order: RowOrder,
    facet_tractions: FacetTractions, stresses_of_cells: StressesOfCells
) -> Kernel:
    """Adds forces of walls and of loads on free facets to stresses of surface cells that were found without a
    step.

    Over one index, in `core/gpu/crack_onset.hpp`.
    """
    return Kernel("add_still_surface_stress", (
        device_span, moving, wall_constraints, row_order, facet_tractions, stresses_of_cells
    ))


def add_stress_difference(
    moving: Moving, cell_dilatation: CellDilatation, dilatation_gradients: DilatationGradients
) -> Kernel:
    """Adds the forces of the springs between cells to their stresses.

    Over one index, in `core/gpu/cells.hpp`.
    """
    return Kernel("add_stress_difference", (moving, cell_dilatation, dilatation_gradients))


def add_surface_stress(
    device_span: DeviceSpan, moving: Moving, wall_constraints: WallConstraints, row_order: RowOrder,
    facet_tractions: FacetTractions, stresses_of_cells: StressesOfCells
) -> Kernel:
    """Adds forces of walls and of loads on free facets to the stresses of surface cells.

    Over one index, in `core/gpu/crack_onset.hpp`.
    """
    return Kernel("add_surface_stress", (
        device_span, moving, wall_constraints, row_order, facet_tractions, stresses_of_cells
    ))


def add_traction_work_of_row(
    moving: Moving, step_cut: StepCut, facet_tractions: FacetTractions, rows: Rows
) -> Kernel:
    """Number h of the elements that own rows, as cells with tractions do."""
    return Kernel("add_traction_work_of_row", (moving, step_cut, facet_tractions, rows))


def add_wall_load(rows: Rows, step_cut: StepCut) -> Kernel:
    """Tractions of element number h of those that own rows of the boundary."""
    return Kernel("add_wall_load", (rows, step_cut))


def add_wall_moments_of_element(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts,
    walls: Walls, lagged_stresses: LaggedStresses
) -> Kernel:
    """Adds contacts with walls to the stresses of the elements of a portion.

    Over one index, in `core/gpu/non_local_pairs.hpp`.
    """
    return Kernel("add_wall_moments_of_element", (
        device_span, moving, contact_constants, wall_contacts, walls, lagged_stresses
    ))


def add_work_of_body(device_span: DeviceSpan, moving: Moving, step_cut: StepCut, body_forces: BodyForces) -> Kernel:
    """Adds the work of body forces over the half of the step that begins, after the pass in which elements move or
    open a step.

    Over one index, in `core/gpu/motion.hpp`.
    """
    return Kernel("add_work_of_body", (device_span, moving, step_cut, body_forces))


def add_work_of_cell_strains(
    device_span: DeviceSpan, moving: Moving, cell_strains: CellStrains, wall_constraints: WallConstraints, rows:
    Rows
) -> Kernel:
    """Adds the work of strains that have changed, when the forces after that are known.

    Over one index, in `core/gpu/strains.hpp`.
    """
    return Kernel("add_work_of_cell_strains", (device_span, moving, cell_strains, wall_constraints, rows))


def add_work_of_strains(
    device_span: DeviceSpan, strain: Strain, strain_portions: StrainPortions, rows: Rows
) -> Kernel:
    """Launched for `follow_strains`: sets rest lengths L (1 + ε*), and adds the work of the strains.

    Over one index, in `core/gpu/strains.hpp`.
    """
    return Kernel("add_work_of_strains", (device_span, strain, strain_portions, rows))


def add_yielding_work_of_row(
    device_span: DeviceSpan, step_cut: StepCut, facet_tractions: FacetTractions, stresses_of_cells:
    StressesOfCells, yielding_cells: YieldingCells, rows: Rows
) -> Kernel:
    """Number h of the elements that own rows, as cells with loads on free facets do."""
    return Kernel("add_yielding_work_of_row", (
        device_span, step_cut, facet_tractions, stresses_of_cells, yielding_cells, rows
    ))


def adhere_element_at_walls(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts,
    walls: Walls, contact_sums: ContactSums
) -> Kernel:
    """Finds the adhesion of a portion of elements at walls.

    Over one index, in `core/gpu/adhesion.hpp`.
    """
    return Kernel("adhere_element_at_walls", (
        device_span, moving, contact_constants, wall_contacts, walls, contact_sums
    ))


def adhere_one_pair(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, adhering_pairs:
    AdheringPairs
) -> Kernel:
    """Finds the adhesion of the near pairs of a portion of elements.

    Over one index, in `core/gpu/adhesion.hpp`.
    """
    return Kernel("adhere_one_pair", (moving, contact_constants, contact_pairs, adhering_pairs))


def apply_walls_of_row(moving: Moving, wall_constraints: WallConstraints, row_order: RowOrder, rows: Rows) -> Kernel:
    """Sets the forces of walls on the rows of their cells, whose stresses are known, and adds the work of walls
    that move: the trapezoid of the force over the displacement.

    Over one index, in `core/gpu/cells.hpp`.
    """
    return Kernel("apply_walls_of_row", (moving, wall_constraints, row_order, rows))


def begin_all_levers(elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks) -> Kernel:
    """Launched for `link_cracks`: prepares the cracks of a state at the start of a run: constants, weights of
    cells, lists, and forces of cracks.

    Over one index, in `core/gpu/cracks.hpp`.
    """
    return Kernel("begin_all_levers", (elastic_facets, cohesive_cracks))


def begin_all_softened_contacts(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs,
    near_pairs: NearPairs, event_log: EventLog, contact_sums: ContactSums
) -> Kernel:
    """Begins contact where softening beams have broken at the beginning of this step.

    Over one index, in `core/gpu/softening_beams.hpp`.
    """
    return Kernel("begin_all_softened_contacts", (
        device_span, moving, contact_constants, contact_pairs, near_pairs, event_log, contact_sums
    ))


def begin_all_softening(
    device_span: DeviceSpan, candidates: Candidates, softening_bounds: SofteningBounds, softening_beams:
    SofteningBeams, event_log: EventLog
) -> Kernel:
    """Writes the rows of beams that have begun to soften in this step, and adds up their dissipation.

    Over one index, in `core/gpu/softening_beams.hpp`.
    """
    return Kernel("begin_all_softening", (device_span, candidates, softening_bounds, softening_beams, event_log))


def begin_base(
    device_span: DeviceSpan, moving: Moving, cell_dilatation: CellDilatation, crack_lists: CrackLists
) -> Kernel:
    """Stores V θ of cells without their cracks.

    Over one index, in `core/gpu/cracks.hpp`.
    """
    return Kernel("begin_base", (device_span, moving, cell_dilatation, crack_lists))


def begin_beam_by_mohr_coulomb(
    device_span: DeviceSpan, moving: Moving, beams: Beams, loads_of_bonds: LoadsOfBonds, softening_bounds:
    SofteningBounds, bond_marks: BondMarks, candidates: Candidates
) -> Kernel:
    """Pass of one index, defined in `core/gpu/softening_beams.hpp`."""
    return Kernel("begin_beam_by_mohr_coulomb", (
        device_span, moving, beams, loads_of_bonds, softening_bounds, bond_marks, candidates
    ))


def begin_beam_by_peripheral_stress(
    device_span: DeviceSpan, moving: Moving, beams: Beams, loads_of_bonds: LoadsOfBonds, softening_bounds:
    SofteningBounds, bond_marks: BondMarks, candidates: Candidates
) -> Kernel:
    """Pass of one index, defined in `core/gpu/softening_beams.hpp`."""
    return Kernel("begin_beam_by_peripheral_stress", (
        device_span, moving, beams, loads_of_bonds, softening_bounds, bond_marks, candidates
    ))


def begin_cell_strains(
    device_span: DeviceSpan, moving: Moving, cell_strains: CellStrains, wall_constraints: WallConstraints
) -> Kernel:
    """Launched for `begin_strain_work`: finds ∂U/∂factor by the stresses in the poses, where the time of the clock
    was not reached by a step.

    Over one index, in `core/gpu/strains.hpp`.
    """
    return Kernel("begin_cell_strains", (device_span, moving, cell_strains, wall_constraints))


def begin_contact_of_event(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, near_pairs: NearPairs,
    event_log: EventLog
) -> Kernel:
    """Begins the contact of event number e of this step."""
    return Kernel("begin_contact_of_event", (moving, contact_constants, contact_pairs, near_pairs, event_log))


def begin_faces_of_pair(moving: Moving, contact_pairs: ContactPairs, face_pairs: FacePairs) -> Kernel:
    """Begins the contact of the faces of pair k that part in this step."""
    return Kernel("begin_faces_of_pair", (moving, contact_pairs, face_pairs))


def begin_marked_crack(
    device_span: DeviceSpan, elastic_facets: ElasticFacets, facet_forces: FacetForces, facet_strengths:
    FacetStrengths, crack_onset: CrackOnset, cohesive_cracks: CohesiveCracks
) -> Kernel:
    """Begins the cracks of facets that are marked.

    Over one index, in `core/gpu/crack_onset.hpp`.
    """
    return Kernel("begin_marked_crack", (
        device_span, elastic_facets, facet_forces, facet_strengths, crack_onset, cohesive_cracks
    ))


def begin_portion_of_crack_powers(
    device_span: DeviceSpan, moving: Moving, cell_strains: CellStrains, elastic_facets: ElasticFacets,
    cohesive_cracks: CohesiveCracks, strain_portions: StrainPortions
) -> Kernel:
    """Launched for `begin_crack_powers`: sets ∂U/∂factor of the stress-free strains by the forces that cracks
    have, where the time of the clock was not reached by a step.

    Over one index, in `core/gpu/yielding.hpp`.
    """
    return Kernel("begin_portion_of_crack_powers", (
        device_span, moving, cell_strains, elastic_facets, cohesive_cracks, strain_portions
    ))


def begin_walls_of_row(
    device_span: DeviceSpan, moving: Moving, wall_constraints: WallConstraints, row_order: RowOrder, rows: Rows
) -> Kernel:
    """Sets the forces of walls on row r anew where the time of the clock was not reached by a step."""
    return Kernel("begin_walls_of_row", (device_span, moving, wall_constraints, row_order, rows))


def bend_layer(
    moving: Moving, wall_constraints: WallConstraints, dilatation_gradients: DilatationGradients
) -> Kernel:
    """Computes how layers one cell thick are bent at each cell.

    Over one index, in `core/gpu/cells.hpp`.
    """
    return Kernel("bend_layer", (moving, wall_constraints, dilatation_gradients))


def carry_cell(
    stresses_of_cells: StressesOfCells, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> Kernel:
    """Launched for `carry_cracks`: sums b⊗f of the cracks of each cell from their forces of the last step.

    Over one index, in `core/gpu/cracks.hpp`.
    """
    return Kernel("carry_cell", (stresses_of_cells, cohesive_cracks, crack_lists))


def check_portion(device_span: DeviceSpan, moving: Moving, beams: Beams, portions: Portions) -> Kernel:
    """Counts unbroken beams of a portion that are turned beyond the range of their energy, and beyond its end.

    Over one index, in `core/gpu/beams.hpp`.
    """
    return Kernel("check_portion", (device_span, moving, beams, portions))


def check_portion_of_facets(
    device_span: DeviceSpan, moving: Moving, beams: Beams, elastic_facets: ElasticFacets, portions: Portions
) -> Kernel:
    """Counts unbroken facets of a portion that are turned beyond the range of their energy, and beyond its end.

    Over one index, in `core/gpu/cells.hpp`.
    """
    return Kernel("check_portion_of_facets", (device_span, moving, beams, elastic_facets, portions))


def check_travel_of_element(device_span: DeviceSpan, moving: Moving, travel: Travel) -> Kernel:
    """Finds the distances of the elements of a portion from their places at the last measurement.

    Over one index, in `core/gpu/contacts.hpp`.
    """
    return Kernel("check_travel_of_element", (device_span, moving, travel))


def check_travel_of_wall(device_span: DeviceSpan, travel: Travel, walls: Walls) -> Kernel:
    """Finds whether the list may miss a contact by now, also where a centre is not a number.

    Over one index, in `core/gpu/contacts.hpp`.
    """
    return Kernel("check_travel_of_wall", (device_span, travel, walls))


def clear_candidates(candidate_facets: CandidateFacets) -> Kernel:
    """Launched for `find_stress_candidates`: writes the stresses of facets in tension, as candidates of a portion;
    marks facets of cells without cohesion.

    Over one index, in `core/gpu/stress_onset.hpp`.
    """
    return Kernel("clear_candidates", (candidate_facets,))


def clear_row(rows: Rows) -> Kernel:
    """Sets the forces of all rows to zero, before loads are added.

    Over one index, in `core/gpu/boundary.hpp`.
    """
    return Kernel("clear_row", (rows,))


def count_failures(candidates: Candidates, event_log: EventLog) -> Kernel:
    """Counts the events of a step, and adds up their released energies."""
    return Kernel("count_failures", (candidates, event_log))


def count_record(device_span: DeviceSpan) -> Kernel:
    """The next record goes to the next row of the history."""
    return Kernel("count_record", (device_span,))


def dilate_facet(moving: Moving, elastic_facets: ElasticFacets, loads_of_bonds: LoadsOfBonds) -> Kernel:
    """Pass of one index, defined in `core/gpu/cells.hpp`."""
    return Kernel("dilate_facet", (moving, elastic_facets, loads_of_bonds))


def dilate_marked_facet(
    moving: Moving, elastic_facets: ElasticFacets, loads_of_bonds: LoadsOfBonds, failure_bounds: FailureBounds,
    bond_marks: BondMarks
) -> Kernel:
    """Marks facets by the stresses of the previous step, because stresses of this step need all facets."""
    return Kernel("dilate_marked_facet", (moving, elastic_facets, loads_of_bonds, failure_bounds, bond_marks))


def dilate_walls_of_row(
    moving: Moving, wall_constraints: WallConstraints, row_order: RowOrder, cell_dilatation: CellDilatation
) -> Kernel:
    """Adds contributions of walls to V θ of their cells.

    Over one index, in `core/gpu/cells.hpp`.
    """
    return Kernel("dilate_walls_of_row", (moving, wall_constraints, row_order, cell_dilatation))


def end_all_failures(candidates: Candidates) -> Kernel:
    """Pass of one index, defined in `core/gpu/breakage.hpp`."""
    return Kernel("end_all_failures", (candidates,))


def end_facets_of_cell(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, facet_release: FacetRelease,
    bond_marks: BondMarks, candidates: Candidates
) -> Kernel:
    """Sets weight and stress of a cell without its failed facets, and ends the failures of the step."""
    return Kernel("end_facets_of_cell", (
        moving, elastic_facets, wall_constraints, facet_release, bond_marks, candidates
    ))


def end_failing_pair(non_local_bonds: NonLocalBonds, beam_integrity: BeamIntegrity, candidates: Candidates) -> Kernel:
    """Launched for `relieve_pairs`: subtracts the force of failed bonds from the stresses of their elements, and
    sets their integrity to 0; after `break_pairs`.

    Over one index, in `core/gpu/non_local_pairs.hpp`.
    """
    return Kernel("end_failing_pair", (non_local_bonds, beam_integrity, candidates))


def end_portion_of_softening(
    softening_bounds: SofteningBounds, softening_beams: SofteningBeams, softening_losses: SofteningLosses
) -> Kernel:
    """Launched for `soften_beams`: lowers the integrity of beams of a portion that soften, before the forces.

    Over one index, in `core/gpu/softening_beams.hpp`.
    """
    return Kernel("end_portion_of_softening", (softening_bounds, softening_beams, softening_losses))


def find_acceleration_of(moving: Moving, rows: Rows, step_cut: StepCut, corrected_mass: CorrectedMass) -> Kernel:
    """Computes the accelerations of the elements by their loads alone.

    Over one index, in `core/gpu/cells.hpp`.
    """
    return Kernel("find_acceleration_of", (moving, rows, step_cut, corrected_mass))


def find_cell_stress(
    device_span: DeviceSpan, moving: Moving, facet_forces: FacetForces, stresses_of_cells: StressesOfCells
) -> Kernel:
    """Finds the mean stresses of cells from the forces of the last step on their facets and cracks.

    Over one index, in `core/gpu/crack_onset.hpp`.
    """
    return Kernel("find_cell_stress", (device_span, moving, facet_forces, stresses_of_cells))


def find_dilatation_inertia_of(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, corrected_mass:
    CorrectedMass
) -> Kernel:
    """Computes ρ β θ̈ of the cells by the accelerations of the elements.

    Over one index, in `core/gpu/cells.hpp`.
    """
    return Kernel("find_dilatation_inertia_of", (moving, elastic_facets, wall_constraints, corrected_mass))


def find_force_of_pair(
    device_span: DeviceSpan, moving: Moving, beams: Beams, non_local_bonds: NonLocalBonds, lagged_stresses:
    LaggedStresses, loads_of_bonds: LoadsOfBonds
) -> Kernel:
    """Pass of one index, defined in `core/gpu/non_local_pairs.hpp`."""
    return Kernel("find_force_of_pair", (
        device_span, moving, beams, non_local_bonds, lagged_stresses, loads_of_bonds
    ))


def find_inertia_force_of(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, corrected_mass:
    CorrectedMass
) -> Kernel:
    """Computes the forces of the correction on the elements.

    Over one index, in `core/gpu/cells.hpp`.
    """
    return Kernel("find_inertia_force_of", (moving, elastic_facets, wall_constraints, corrected_mass))


def find_still_stress(
    device_span: DeviceSpan, moving: Moving, facet_forces: FacetForces, stresses_of_cells: StressesOfCells
) -> Kernel:
    """Finds the mean stresses of cells from present forces that were found without a step.

    Over one index, in `core/gpu/crack_onset.hpp`.
    """
    return Kernel("find_still_stress", (device_span, moving, facet_forces, stresses_of_cells))


def find_strength_along(candidate_facets: CandidateFacets) -> Kernel:
    """Keeps the strengths of facets that begin to crack.

    Over one index, in `core/gpu/stress_onset.hpp`.
    """
    return Kernel("find_strength_along", (candidate_facets,))


def find_stress_candidate(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, facet_forces: FacetForces,
    stresses_of_cells: StressesOfCells, crack_onset: CrackOnset, candidate_facets: CandidateFacets
) -> Kernel:
    """Launched for `find_stress_candidates`: writes the stresses of facets in tension, as candidates of a portion;
    marks facets of cells without cohesion.

    Over one index, in `core/gpu/stress_onset.hpp`.
    """
    return Kernel("find_stress_candidate", (
        device_span, moving, elastic_facets, facet_forces, stresses_of_cells, crack_onset, candidate_facets
    ))


def find_stress_of_element(moving: Moving, lagged_stresses: LaggedStresses) -> Kernel:
    """Pass of one index, defined in `core/gpu/non_local_pairs.hpp`."""
    return Kernel("find_stress_of_element", (moving, lagged_stresses))


def fold_portions(portions: Portions, work_portions: WorkPortions, folded_portions: FoldedPortions) -> Kernel:
    """Column k % 13 of group k / 13."""
    return Kernel("fold_portions", (portions, work_portions, folded_portions))


def follow_all_couples(
    device_span: DeviceSpan, timeline: Timeline, couple_table: CoupleTable, moving: Moving, rows: Rows
) -> Kernel:
    """Adds moments on regions as forces and torques of their elements.

    Over one index, in `core/gpu/boundary.hpp`.
    """
    return Kernel("follow_all_couples", (device_span, timeline, couple_table, moving, rows))


def follow_body_group(device_span: DeviceSpan, timeline: Timeline, body_forces: BodyForces) -> Kernel:
    """Brings body forces to the time of the clock.

    Over one index, in `core/gpu/boundary.hpp`.
    """
    return Kernel("follow_body_group", (device_span, timeline, body_forces))


def follow_cell_factors(device_span: DeviceSpan, timeline: Timeline, cell_strains: CellStrains) -> Kernel:
    """Launched for `follow_cell_strains`: sets stress-free strains, and with them the levers of facets and walls,
    to the time of the clock.

    Over one index, in `core/gpu/strains.hpp`.
    """
    return Kernel("follow_cell_factors", (device_span, timeline, cell_strains))


def follow_drive(device_span: DeviceSpan, timeline: Timeline, drives: Drives, rows: Rows) -> Kernel:
    """Sets prescribed velocities at the time of the clock, and over the step that begins there.

    Over one index, in `core/gpu/boundary.hpp`.
    """
    return Kernel("follow_drive", (device_span, timeline, drives, rows))


def follow_lever(cell_strains: CellStrains, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks) -> Kernel:
    """Copies the levers of a facet that strains of cells have changed."""
    return Kernel("follow_lever", (cell_strains, elastic_facets, cohesive_cracks))


def follow_loads_of_row(
    device_span: DeviceSpan, timeline: Timeline, row_loads: RowLoads, row_order: RowOrder, moving: Moving, rows:
    Rows
) -> Kernel:
    """Adds forces and torques of loads to their rows, turned with the element if they follow it.

    Over one index, in `core/gpu/boundary.hpp`.
    """
    return Kernel("follow_loads_of_row", (device_span, timeline, row_loads, row_order, moving, rows))


def follow_strain_factors(
    device_span: DeviceSpan, timeline: Timeline, strain: Strain, strain_portions: StrainPortions
) -> Kernel:
    """Launched for `follow_strains`: sets rest lengths L (1 + ε*), and adds the work of the strains.

    Over one index, in `core/gpu/strains.hpp`.
    """
    return Kernel("follow_strain_factors", (device_span, timeline, strain, strain_portions))


def follow_traction(device_span: DeviceSpan, timeline: Timeline, facet_tractions: FacetTractions) -> Kernel:
    """Launched for `follow_tractions`: brings tractions to the time of the clock.

    Over one index, in `core/gpu/cells.hpp`.
    """
    return Kernel("follow_traction", (device_span, timeline, facet_tractions))


def gather_dashpots(
    step_cut: StepCut, bonds_of_elements: BondsOfElements, loads_of_bonds: LoadsOfBonds, dashpots: Dashpots
) -> Kernel:
    """Adds loads of dashpots of other domains to the sums of shared elements, and sets their rows to zero.

    Over one index, in `core/gpu/motion.hpp`.
    """
    return Kernel("gather_dashpots", (step_cut, bonds_of_elements, loads_of_bonds, dashpots))


def gather_dilatation(
    cell_dilatation: CellDilatation, bonds_of_elements: BondsOfElements, loads_of_bonds: LoadsOfBonds
) -> Kernel:
    """Adds contributions of facets of other domains to V θ of shared cells, and sets their rows to zero.

    Over one index, in `core/gpu/cells.hpp`.
    """
    return Kernel("gather_dilatation", (cell_dilatation, bonds_of_elements, loads_of_bonds))


def gather_facet_moments(
    facet_forces: FacetForces, bonds_of_elements: BondsOfElements, loads_of_bonds: LoadsOfBonds, facet_arms:
    FacetArms
) -> Kernel:
    """Sets V σ and Σ `bending_square` of cells from their complete sums, which are set to zero.

    Over one index, in `core/gpu/crack_onset.hpp`.
    """
    return Kernel("gather_facet_moments", (facet_forces, bonds_of_elements, loads_of_bonds, facet_arms))


def gather_loads(step_cut: StepCut, bonds_of_elements: BondsOfElements, loads_of_bonds: LoadsOfBonds) -> Kernel:
    """Adds up the loads of bonds of an element in memory, where further loads act on elements."""
    return Kernel("gather_loads", (step_cut, bonds_of_elements, loads_of_bonds))


def gather_moments(
    moving: Moving, non_local_bonds: NonLocalBonds, bonds_of_elements: BondsOfElements, lagged_stresses:
    LaggedStresses
) -> Kernel:
    """Pass of one index, defined in `core/gpu/non_local_pairs.hpp`."""
    return Kernel("gather_moments", (moving, non_local_bonds, bonds_of_elements, lagged_stresses))


def give_dilatation(
    device_span: DeviceSpan, facet_tractions: FacetTractions, cell_dilatation: CellDilatation
) -> Kernel:
    """Launched for `follow_tractions`: brings tractions to the time of the clock.

    Over one index, in `core/gpu/cells.hpp`.
    """
    return Kernel("give_dilatation", (device_span, facet_tractions, cell_dilatation))


def index_candidate_by_cone(stress_candidates: StressCandidates, stress_function: StressFunction) -> Kernel:
    """Pass of one index, defined in `core/gpu/stress_onset.hpp`."""
    return Kernel("index_candidate_by_cone", (stress_candidates, stress_function))


def index_candidate_by_mean_stress(stress_candidates: StressCandidates, stress_function: StressFunction) -> Kernel:
    """Pass of one index, defined in `core/gpu/stress_onset.hpp`."""
    return Kernel("index_candidate_by_mean_stress", (stress_candidates, stress_function))


def judge_beam_by_ellipse(
    device_span: DeviceSpan, moving: Moving, beams: Beams, strengths: Strengths, bond_marks: BondMarks,
    candidates: Candidates, postponed: Postponed
) -> Kernel:
    """Launched for `judge_beams`: evaluates marked beams of a block by a criterion, and postpones the elements of
    failed ones.

    Over one index, in `core/gpu/breakage.hpp`.
    """
    return Kernel("judge_beam_by_ellipse", (device_span, moving, beams, strengths, bond_marks, candidates, postponed))


def judge_beam_by_linear_sum(
    device_span: DeviceSpan, moving: Moving, beams: Beams, strengths: Strengths, bond_marks: BondMarks,
    candidates: Candidates, postponed: Postponed
) -> Kernel:
    """Launched for `judge_beams`: evaluates marked beams of a block by a criterion, and postpones the elements of
    failed ones.

    Over one index, in `core/gpu/breakage.hpp`.
    """
    return Kernel("judge_beam_by_linear_sum", (
        device_span, moving, beams, strengths, bond_marks, candidates, postponed
    ))


def judge_beam_by_mohr_coulomb(
    device_span: DeviceSpan, moving: Moving, beams: Beams, strengths: Strengths, bond_marks: BondMarks,
    candidates: Candidates, postponed: Postponed
) -> Kernel:
    """Launched for `judge_beams`: evaluates marked beams of a block by a criterion, and postpones the elements of
    failed ones.

    Over one index, in `core/gpu/breakage.hpp`.
    """
    return Kernel("judge_beam_by_mohr_coulomb", (
        device_span, moving, beams, strengths, bond_marks, candidates, postponed
    ))


def judge_beam_by_peripheral_stress(
    device_span: DeviceSpan, moving: Moving, beams: Beams, strengths: Strengths, bond_marks: BondMarks,
    candidates: Candidates, postponed: Postponed
) -> Kernel:
    """Launched for `judge_beams`: evaluates marked beams of a block by a criterion, and postpones the elements of
    failed ones.

    Over one index, in `core/gpu/breakage.hpp`.
    """
    return Kernel("judge_beam_by_peripheral_stress", (
        device_span, moving, beams, strengths, bond_marks, candidates, postponed
    ))


def judge_cell(
    device_span: DeviceSpan, facet_strengths: FacetStrengths, stresses_of_cells: StressesOfCells, crack_onset:
    CrackOnset
) -> Kernel:
    """Finds the cells whose facets may crack: those with cracks, and those whose stress may reach their strength.

    Over one index, in `core/gpu/crack_onset.hpp`.
    """
    return Kernel("judge_cell", (device_span, facet_strengths, stresses_of_cells, crack_onset))


def judge_cell_by_cone(
    device_span: DeviceSpan, stresses_of_cells: StressesOfCells, stress_function: StressFunction,
    candidate_facets: CandidateFacets, crack_onset: CrackOnset
) -> Kernel:
    """Pass of one index, defined in `core/gpu/stress_onset.hpp`."""
    return Kernel("judge_cell_by_cone", (
        device_span, stresses_of_cells, stress_function, candidate_facets, crack_onset
    ))


def judge_cell_by_mean_stress(
    device_span: DeviceSpan, stresses_of_cells: StressesOfCells, stress_function: StressFunction,
    candidate_facets: CandidateFacets, crack_onset: CrackOnset
) -> Kernel:
    """Pass of one index, defined in `core/gpu/stress_onset.hpp`."""
    return Kernel("judge_cell_by_mean_stress", (
        device_span, stresses_of_cells, stress_function, candidate_facets, crack_onset
    ))


def judge_cell_by_size(
    device_span: DeviceSpan, stresses_of_cells: StressesOfCells, candidate_facets: CandidateFacets, crack_onset:
    CrackOnset
) -> Kernel:
    """Finds the cells whose facets are evaluated: those whose stress is large enough for the criterion of a user.

    Over one index, in `core/gpu/stress_onset.hpp`.
    """
    return Kernel("judge_cell_by_size", (device_span, stresses_of_cells, candidate_facets, crack_onset))


def judge_facet_by_mohr_coulomb(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, strengths: Strengths, bond_marks:
    BondMarks, candidates: Candidates, postponed: Postponed
) -> Kernel:
    """Launched for `judge_facets`: evaluates marked facets by a criterion at the present stresses, and postpones
    cells that lose facets and their neighbours.

    Over one index, in `core/gpu/facet_breakage.hpp`.
    """
    return Kernel("judge_facet_by_mohr_coulomb", (
        device_span, moving, elastic_facets, strengths, bond_marks, candidates, postponed
    ))


def judge_pair(
    device_span: DeviceSpan, beams: Beams, lagged_stresses: LaggedStresses, strengths: Strengths, bond_marks:
    BondMarks, candidates: Candidates, postponed: Postponed
) -> Kernel:
    """Launched for `judge_pairs`: evaluates marked bonds of a block, and postpones the elements of failed ones.

    Over one index, in `core/gpu/non_local_pairs.hpp`.
    """
    return Kernel("judge_pair", (device_span, beams, lagged_stresses, strengths, bond_marks, candidates, postponed))


def keep_base_levers(
    cell_strains: CellStrains, elastic_facets: ElasticFacets, yielding_cells: YieldingCells
) -> Kernel:
    """Keeps the levers without plastic strain where strains have set them anew."""
    return Kernel("keep_base_levers", (cell_strains, elastic_facets, yielding_cells))


def keep_dashed_sum(step_cut: StepCut, dashpots: Dashpots, postponed: Postponed) -> Kernel:
    """Keeps the sums of the dashpots of postponed elements.

    Over one index, in `core/gpu/breakage.hpp`.
    """
    return Kernel("keep_dashed_sum", (step_cut, dashpots, postponed))


def keep_gathered_sum(
    step_cut: StepCut, bonds_of_elements: BondsOfElements, loads_of_bonds: LoadsOfBonds, postponed: Postponed
) -> Kernel:
    """Launched for `keep_sums`: keeps the sums of postponed elements.

    Over one index, in `core/gpu/breakage.hpp`.
    """
    return Kernel("keep_gathered_sum", (step_cut, bonds_of_elements, loads_of_bonds, postponed))


def keep_sum(step_cut: StepCut, postponed: Postponed) -> Kernel:
    """Launched for `keep_sums`: keeps the sums of postponed elements.

    Over one index, in `core/gpu/breakage.hpp`.
    """
    return Kernel("keep_sum", (step_cut, postponed))


def kick_free_wall(device_span: DeviceSpan, wall_motions: WallMotions, walls: Walls) -> Kernel:
    """Applies half a kick to free wall e, when the forces on the wall are known."""
    return Kernel("kick_free_wall", (device_span, wall_motions, walls))


def leave_crack(elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists) -> Kernel:
    """Launched for `leave_cracks`: puts cracks to rest, or parts their faces, as `soften_cracks` has found.

    Over one index, in `core/gpu/cracks.hpp`.
    """
    return Kernel("leave_crack", (elastic_facets, cohesive_cracks, crack_lists))


def link_halves(
    cohesive_cracks: CohesiveCracks, crack_lists: CrackLists, bonds_of_elements: BondsOfElements
) -> Kernel:
    """Pass of one index, defined in `core/gpu/cracks.hpp`."""
    return Kernel("link_halves", (cohesive_cracks, crack_lists, bonds_of_elements))


def load_alike_beam(moving: Moving, beams: Beams, alike_beams: AlikeBeams, loads_of_bonds: LoadsOfBonds) -> Kernel:
    """Adds forces and torques of beams that differ in length only.

    Over one index, in `core/gpu/beams.hpp`.
    """
    return Kernel("load_alike_beam", (moving, beams, alike_beams, loads_of_bonds))


def load_beam(moving: Moving, beams: Beams, loads_of_bonds: LoadsOfBonds) -> Kernel:
    """Adds forces and torques of the beams of a block to the sums of their elements.

    Over one index, in `core/gpu/beams.hpp`.
    """
    return Kernel("load_beam", (moving, beams, loads_of_bonds))


def load_crack(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, facet_strengths: FacetStrengths,
    stresses_of_cells: StressesOfCells, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists,
    losses_of_cracks: LossesOfCracks
) -> Kernel:
    """Computes forces, torques and dissipation of the cracks that are treated one by one.

    Over one index, in `core/gpu/cracks.hpp`.
    """
    return Kernel("load_crack", (
        device_span, moving, elastic_facets, facet_strengths, stresses_of_cells, cohesive_cracks, crack_lists,
        losses_of_cracks
    ))


def load_dashpot(moving: Moving, beams: Beams, dashpots: Dashpots, loads_of_bonds: LoadsOfBonds) -> Kernel:
    """Adds forces and torques of the dashpots of beams to sums of their own.

    Over one index, in `core/gpu/beams.hpp`.
    """
    return Kernel("load_dashpot", (moving, beams, dashpots, loads_of_bonds))


def load_facet(moving: Moving, elastic_facets: ElasticFacets, loads_of_bonds: LoadsOfBonds) -> Kernel:
    """Adds forces and torques of the facets of a block to the sums of their cells, whose stresses are known.

    Over one index, in `core/gpu/cells.hpp`.
    """
    return Kernel("load_facet", (moving, elastic_facets, loads_of_bonds))


def load_failing_dashpot(
    moving: Moving, beams: Beams, dashpots: Dashpots, candidates: Candidates, loads_of_bonds: LoadsOfBonds
) -> Kernel:
    """Launched for `withdraw_dashpots`: subtracts dashpots of failed beams from the kept sums of their ends,
    before the beams are removed.

    Over one index, in `core/gpu/breakage.hpp`.
    """
    return Kernel("load_failing_dashpot", (moving, beams, dashpots, candidates, loads_of_bonds))


def load_kept_facet(
    moving: Moving, elastic_facets: ElasticFacets, facet_forces: FacetForces, loads_of_bonds: LoadsOfBonds,
    facet_arms: FacetArms
) -> Kernel:
    """Adds and stores the forces of the facets of a block, and adds up the moments V σ of their cells.

    Over one index, in `core/gpu/crack_onset.hpp`.
    """
    return Kernel("load_kept_facet", (moving, elastic_facets, facet_forces, loads_of_bonds, facet_arms))


def load_marked_alike_beam(
    moving: Moving, beams: Beams, alike_beams: AlikeBeams, loads_of_bonds: LoadsOfBonds, failure_bounds:
    FailureBounds, bond_marks: BondMarks
) -> Kernel:
    """Adds forces and torques of beams that differ in length only, and marks beams near to failure.

    Over one index, in `core/gpu/breakage.hpp`.
    """
    return Kernel("load_marked_alike_beam", (moving, beams, alike_beams, loads_of_bonds, failure_bounds, bond_marks))


def load_marked_beam(
    moving: Moving, beams: Beams, loads_of_bonds: LoadsOfBonds, failure_bounds: FailureBounds, bond_marks:
    BondMarks
) -> Kernel:
    """Adds forces and torques of the beams of a block, and marks beams near to failure.

    Over one index, in `core/gpu/breakage.hpp`.
    """
    return Kernel("load_marked_beam", (moving, beams, loads_of_bonds, failure_bounds, bond_marks))


def load_softening_alike_beam(
    moving: Moving, beams: Beams, alike_beams: AlikeBeams, loads_of_bonds: LoadsOfBonds, softening_bounds:
    SofteningBounds, bond_marks: BondMarks
) -> Kernel:
    """Pass of one index, defined in `core/gpu/softening_beams.hpp`."""
    return Kernel("load_softening_alike_beam", (
        moving, beams, alike_beams, loads_of_bonds, softening_bounds, bond_marks
    ))


def load_softening_beam(
    moving: Moving, beams: Beams, loads_of_bonds: LoadsOfBonds, softening_bounds: SofteningBounds, bond_marks:
    BondMarks
) -> Kernel:
    """Pass of one index, defined in `core/gpu/softening_beams.hpp`."""
    return Kernel("load_softening_beam", (moving, beams, loads_of_bonds, softening_bounds, bond_marks))


def load_stored_beam(
    device_span: DeviceSpan, moving: Moving, beams: Beams, stored_loads: StoredLoads, loads_of_bonds: LoadsOfBonds
) -> Kernel:
    """Integrates the stored forces and moments of the beams of a block over the step, and adds them to the sums of
    their elements.

    Over one index, in `core/gpu/storing_beams.hpp`.
    """
    return Kernel("load_stored_beam", (device_span, moving, beams, stored_loads, loads_of_bonds))


def load_wall(device_span: DeviceSpan, wall_contacts: WallContacts, row_order: RowOrder, walls: Walls) -> Kernel:
    """Sums the forces of elements on wall w, and adds its work."""
    return Kernel("load_wall", (device_span, wall_contacts, row_order, walls))


def log_all_cracks(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks,
    event_log: EventLog, losses_of_cracks: LossesOfCracks
) -> Kernel:
    """Adds up what cracks have dissipated, and logs those that have no integrity left, by the numbers of their
    facets.
    """
    return Kernel("log_all_cracks", (
        device_span, moving, elastic_facets, cohesive_cracks, event_log, losses_of_cracks
    ))


def log_all_softened(
    device_span: DeviceSpan, moving: Moving, beams: Beams, softening_beams: SofteningBeams, event_log: EventLog
) -> Kernel:
    """Adds up the dissipation of all portions, and logs broken beams.

    Over one index, in `core/gpu/softening_beams.hpp`.
    """
    return Kernel("log_all_softened", (device_span, moving, beams, softening_beams, event_log))


def mark_facet(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, facet_forces: FacetForces,
    facet_strengths: FacetStrengths, stresses_of_cells: StressesOfCells, crack_onset: CrackOnset
) -> Kernel:
    """Marks facets of the material that begin to crack.

    Over one index, in `core/gpu/crack_onset.hpp`.
    """
    return Kernel("mark_facet", (
        device_span, moving, elastic_facets, facet_forces, facet_strengths, stresses_of_cells, crack_onset
    ))


def mark_failing_facet(
    moving: Moving, elastic_facets: ElasticFacets, facet_forces: FacetForces, stresses_of_cells: StressesOfCells,
    crack_onset: CrackOnset, candidate_facets: CandidateFacets
) -> Kernel:
    """Marks candidates that fail, and leaves these with the mean stress of their cells, of which the index gives
    their strength.

    Over one index, in `core/gpu/stress_onset.hpp`.
    """
    return Kernel("mark_failing_facet", (
        moving, elastic_facets, facet_forces, stresses_of_cells, crack_onset, candidate_facets
    ))


def mark_plane(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, facet_forces: FacetForces,
    facet_strengths: FacetStrengths, crack_onset: CrackOnset
) -> Kernel:
    """Evaluates facet number e of the material planes."""
    return Kernel("mark_plane", (device_span, moving, elastic_facets, facet_forces, facet_strengths, crack_onset))


def measure_crack(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, cell_slack: CellSlack,
    stresses_of_cells: StressesOfCells, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists,
    losses_of_cracks: LossesOfCracks
) -> Kernel:
    """Finds faces and halves of the cracks that are treated one by one, and axes of cracks before any loss of
    integrity.

    Over one index, in `core/gpu/cracks.hpp`.
    """
    return Kernel("measure_crack", (
        device_span, moving, elastic_facets, cell_slack, stresses_of_cells, cohesive_cracks, crack_lists,
        losses_of_cracks
    ))


def measure_overlaps(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs,
    wall_contacts: WallContacts, walls: Walls, travel: Travel
) -> Kernel:
    """The deepest overlap of the pairs and the contacts with walls of a portion of elements, over the smaller
    radius.
    """
    return Kernel("measure_overlaps", (
        device_span, moving, contact_constants, contact_pairs, wall_contacts, walls, travel
    ))


def move_all_walls(device_span: DeviceSpan, wall_motions: WallMotions, walls: Walls) -> Kernel:
    """Moves walls to the end of the step that begins at the time of the clock.

    Over one index, in `core/gpu/contacts.hpp`.
    """
    return Kernel("move_all_walls", (device_span, wall_motions, walls))


def move_gathered(
    device_span: DeviceSpan, moving: Moving, step_cut: StepCut, bonds_of_elements: BondsOfElements,
    loads_of_bonds: LoadsOfBonds
) -> Kernel:
    """Launched for `move_elements`: closes the step, and opens the next, for elements that own no row of the
    boundary.

    Over one index, in `core/gpu/motion.hpp`.
    """
    return Kernel("move_gathered", (device_span, moving, step_cut, bonds_of_elements, loads_of_bonds))


def move_gathered_resisted(
    device_span: DeviceSpan, moving: Moving, step_cut: StepCut, bonds_of_elements: BondsOfElements,
    loads_of_bonds: LoadsOfBonds, resistance: Resistance
) -> Kernel:
    """Launched for `move_resisted`: closes the step, and opens the next, for damped elements that own no row of
    the boundary.

    Over one index, in `core/gpu/motion.hpp`.
    """
    return Kernel("move_gathered_resisted", (
        device_span, moving, step_cut, bonds_of_elements, loads_of_bonds, resistance
    ))


def move_gathered_resisted_row(
    device_span: DeviceSpan, moving: Moving, step_cut: StepCut, rows: Rows, bonds_of_elements: BondsOfElements,
    loads_of_bonds: LoadsOfBonds, resistance: Resistance
) -> Kernel:
    """Launched for `move_resisted_rows`: closes the step, and opens the next, for damped elements that own rows of
    the boundary.

    Over one index, in `core/gpu/motion.hpp`.
    """
    return Kernel("move_gathered_resisted_row", (
        device_span, moving, step_cut, rows, bonds_of_elements, loads_of_bonds, resistance
    ))


def move_gathered_row(
    device_span: DeviceSpan, moving: Moving, step_cut: StepCut, rows: Rows, bonds_of_elements: BondsOfElements,
    loads_of_bonds: LoadsOfBonds
) -> Kernel:
    """Launched for `move_rows`: closes the step, and opens the next, for elements that own rows of the boundary.

    Over one index, in `core/gpu/motion.hpp`.
    """
    return Kernel("move_gathered_row", (device_span, moving, step_cut, rows, bonds_of_elements, loads_of_bonds))


def move_summed(device_span: DeviceSpan, moving: Moving, step_cut: StepCut) -> Kernel:
    """Launched for `move_elements`: closes the step, and opens the next, for elements that own no row of the
    boundary.

    Over one index, in `core/gpu/motion.hpp`.
    """
    return Kernel("move_summed", (device_span, moving, step_cut))


def move_summed_resisted(
    device_span: DeviceSpan, moving: Moving, step_cut: StepCut, resistance: Resistance
) -> Kernel:
    """Launched for `move_resisted`: closes the step, and opens the next, for damped elements that own no row of
    the boundary.

    Over one index, in `core/gpu/motion.hpp`.
    """
    return Kernel("move_summed_resisted", (device_span, moving, step_cut, resistance))


def move_summed_resisted_row(
    device_span: DeviceSpan, moving: Moving, step_cut: StepCut, rows: Rows, resistance: Resistance
) -> Kernel:
    """Launched for `move_resisted_rows`: closes the step, and opens the next, for damped elements that own rows of
    the boundary.

    Over one index, in `core/gpu/motion.hpp`.
    """
    return Kernel("move_summed_resisted_row", (device_span, moving, step_cut, rows, resistance))


def move_summed_row(device_span: DeviceSpan, moving: Moving, step_cut: StepCut, rows: Rows) -> Kernel:
    """Launched for `move_rows`: closes the step, and opens the next, for elements that own rows of the boundary.

    Over one index, in `core/gpu/motion.hpp`.
    """
    return Kernel("move_summed_row", (device_span, moving, step_cut, rows))


def open_element(device_span: DeviceSpan, moving: Moving) -> Kernel:
    """Opens a step after a pause for all elements, none of which owns a row of the boundary.

    Over one index, in `core/gpu/motion.hpp`.
    """
    return Kernel("open_element", (device_span, moving))


def open_element_or_row(device_span: DeviceSpan, moving: Moving, rows: Rows) -> Kernel:
    """Opens a step after a pause for all elements, some of which own rows of the boundary.

    Over one index, in `core/gpu/motion.hpp`.
    """
    return Kernel("open_element_or_row", (device_span, moving, rows))


def open_face(contact_pairs: ContactPairs, face_pairs: FacePairs, crack_lists: CrackLists) -> Kernel:
    """Marks the faces of facet k that part in this step, and their cells."""
    return Kernel("open_face", (contact_pairs, face_pairs, crack_lists))


def open_work_of_body(device_span: DeviceSpan, moving: Moving, body_forces: BodyForces) -> Kernel:
    """Adds the work of body forces over the half of the step that begins after a pause.

    Over one index, in `core/gpu/motion.hpp`.
    """
    return Kernel("open_work_of_body", (device_span, moving, body_forces))


def part_crack(
    moving: Moving, elastic_facets: ElasticFacets, cell_slack: CellSlack, cohesive_cracks: CohesiveCracks,
    crack_lists: CrackLists, losses_of_cracks: LossesOfCracks
) -> Kernel:
    """Energy of a crack that parts, in the state without the cracks that the CPU treats earlier: whole ones first,
    then broken ones by their numbers.
    """
    return Kernel("part_crack", (moving, elastic_facets, cell_slack, cohesive_cracks, crack_lists, losses_of_cracks))


def place_wall(device_span: DeviceSpan, wall_constraints: WallConstraints) -> Kernel:
    """Launched for `follow_walls`: brings walls to the time of the clock; at a time that no step has reached,
    their forces are updated as well.

    Over one index, in `core/gpu/cells.hpp`.
    """
    return Kernel("place_wall", (device_span, wall_constraints))


def postpone_neighbour(
    elastic_facets: ElasticFacets, facet_release: FacetRelease, candidates: Candidates, postponed: Postponed
) -> Kernel:
    """Launched for `judge_facets`: evaluates marked facets by a criterion at the present stresses, and postpones
    cells that lose facets and their neighbours.

    Over one index, in `core/gpu/facet_breakage.hpp`.
    """
    return Kernel("postpone_neighbour", (elastic_facets, facet_release, candidates, postponed))


def press_pair(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs,
    near_pairs: NearPairs
) -> Kernel:
    """Finds forces and memory of the pairs of a portion of elements; renews the list of near pairs where elements
    have moved too far.

    Over one index, in `core/gpu/contacts.hpp`.
    """
    return Kernel("press_pair", (device_span, moving, contact_constants, contact_pairs, near_pairs))


def press_pair_or_faces(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs,
    near_pairs: NearPairs, face_pairs: FacePairs
) -> Kernel:
    """Presses a pair of a body of cells with cracks, which touches by faces too."""
    return Kernel("press_pair_or_faces", (
        device_span, moving, contact_constants, contact_pairs, near_pairs, face_pairs
    ))


def press_walls_on_element(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts,
    walls: Walls, contact_sums: ContactSums
) -> Kernel:
    """Adds forces of walls to the elements of a portion, and keeps their memory.

    Over one index, in `core/gpu/contacts.hpp`.
    """
    return Kernel("press_walls_on_element", (
        device_span, moving, contact_constants, wall_contacts, walls, contact_sums
    ))


def rank_failing(bond_marks: BondMarks, candidates: Candidates) -> Kernel:
    """Moves bond number e of the unordered list of failed bonds to its place in the order of bonds."""
    return Kernel("rank_failing", (bond_marks, candidates))


def read_part_of_gauge(moving: Moving, rows: Rows, gauges: Gauges, gauge_parts: GaugeParts) -> Kernel:
    """Part k % each of the sum of gauge k / each."""
    return Kernel("read_part_of_gauge", (moving, rows, gauges, gauge_parts))


def relax_cell(moving: Moving, cell_dilatation: CellDilatation, crack_lists: CrackLists) -> Kernel:
    """Finds the stresses of all cells with cracks that are treated one by one.

    Over one index, in `core/gpu/cracks.hpp`.
    """
    return Kernel("relax_cell", (moving, cell_dilatation, crack_lists))


def relax_stale_cell(moving: Moving, cell_dilatation: CellDilatation, crack_lists: CrackLists) -> Kernel:
    """Finds the stresses of cells with cracks that are out of date.

    Over one index, in `core/gpu/cracks.hpp`.
    """
    return Kernel("relax_stale_cell", (moving, cell_dilatation, crack_lists))


def release_all_pressure(device_span: DeviceSpan, event_log: EventLog, softening_bounds: SofteningBounds) -> Kernel:
    """Ends the pressure on softening beams that have broken at the beginning of this step.

    Over one index, in `core/gpu/softening_beams.hpp`.
    """
    return Kernel("release_all_pressure", (device_span, event_log, softening_bounds))


def release_element(candidates: Candidates, postponed: Postponed) -> Kernel:
    """Pass of one index, defined in `core/gpu/breakage.hpp`."""
    return Kernel("release_element", (candidates, postponed))


def relieve_element(
    moving: Moving, non_local_bonds: NonLocalBonds, bonds_of_elements: BondsOfElements, bond_marks: BondMarks,
    lagged_stresses: LaggedStresses, candidates: Candidates
) -> Kernel:
    """Launched for `relieve_pairs`: subtracts the force of failed bonds from the stresses of their elements, and
    sets their integrity to 0; after `break_pairs`.

    Over one index, in `core/gpu/non_local_pairs.hpp`.
    """
    return Kernel("relieve_element", (
        moving, non_local_bonds, bonds_of_elements, bond_marks, lagged_stresses, candidates
    ))


def remove_failing_beam(
    device_span: DeviceSpan, moving: Moving, beams: Beams, beam_integrity: BeamIntegrity, candidates: Candidates,
    event_log: EventLog, loads_of_bonds: LoadsOfBonds
) -> Kernel:
    """Removes failed beam number e; its loads are then the loads that its ends lose."""
    return Kernel("remove_failing_beam", (
        device_span, moving, beams, beam_integrity, candidates, event_log, loads_of_bonds
    ))


def renew_wall_row(
    wall_constraints: WallConstraints, row_order: RowOrder, rows: Rows, candidates: Candidates
) -> Kernel:
    """Updates the forces of walls on the rows of their cells.

    Over one index, in `core/gpu/facet_breakage.hpp`.
    """
    return Kernel("renew_wall_row", (wall_constraints, row_order, rows, candidates))


def reopen_work_of_body(
    device_span: DeviceSpan, moving: Moving, body_forces: BodyForces, postponed: Postponed
) -> Kernel:
    """Pass of one index, defined in `core/gpu/breakage.hpp`."""
    return Kernel("reopen_work_of_body", (device_span, moving, body_forces, postponed))


def restore_crack(
    elastic_facets: ElasticFacets, facet_forces: FacetForces, facet_strengths: FacetStrengths, cohesive_cracks:
    CohesiveCracks
) -> Kernel:
    """Launched for `link_cracks`: prepares the cracks of a state at the start of a run: constants, weights of
    cells, lists, and forces of cracks.

    Over one index, in `core/gpu/cracks.hpp`.
    """
    return Kernel("restore_crack", (elastic_facets, facet_forces, facet_strengths, cohesive_cracks))


def restore_facets_of_cell(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, facet_release: FacetRelease,
    candidates: Candidates, postponed: Postponed
) -> Kernel:
    """Adds the loads of the remaining facets and of walls to the kept sums.

    Over one index, in `core/gpu/facet_breakage.hpp`.
    """
    return Kernel("restore_facets_of_cell", (
        moving, elastic_facets, wall_constraints, facet_release, candidates, postponed
    ))


def resume_free(device_span: DeviceSpan, moving: Moving, step_cut: StepCut, postponed: Postponed) -> Kernel:
    """Pass of one index, defined in `core/gpu/breakage.hpp`."""
    return Kernel("resume_free", (device_span, moving, step_cut, postponed))


def resume_resisted(
    device_span: DeviceSpan, moving: Moving, step_cut: StepCut, resistance: Resistance, postponed: Postponed
) -> Kernel:
    """Pass of one index, defined in `core/gpu/breakage.hpp`."""
    return Kernel("resume_resisted", (device_span, moving, step_cut, resistance, postponed))


def resume_resisted_row(
    device_span: DeviceSpan, moving: Moving, step_cut: StepCut, rows: Rows, resistance: Resistance, postponed:
    Postponed
) -> Kernel:
    """Pass of one index, defined in `core/gpu/breakage.hpp`."""
    return Kernel("resume_resisted_row", (device_span, moving, step_cut, rows, resistance, postponed))


def resume_row(
    device_span: DeviceSpan, moving: Moving, step_cut: StepCut, rows: Rows, postponed: Postponed
) -> Kernel:
    """Pass of one index, defined in `core/gpu/breakage.hpp`."""
    return Kernel("resume_row", (device_span, moving, step_cut, rows, postponed))


def roll_element_at_walls(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts,
    walls: Walls, rolled_walls: RolledWalls, contact_sums: ContactSums
) -> Kernel:
    """Finds moments of resistance to rolling of a portion of elements at walls.

    Over one index, in `core/gpu/rolling.hpp`.
    """
    return Kernel("roll_element_at_walls", (
        device_span, moving, contact_constants, wall_contacts, walls, rolled_walls, contact_sums
    ))


def roll_one_pair(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs,
    near_pairs: NearPairs, rolled_pairs: RolledPairs
) -> Kernel:
    """Finds moments and memory of the pairs of a portion of elements that touch and may roll.

    Over one index, in `core/gpu/rolling.hpp`.
    """
    return Kernel("roll_one_pair", (device_span, moving, contact_constants, contact_pairs, near_pairs, rolled_pairs))


def set_clock(device_span: DeviceSpan, step_scheme: StepScheme, tick: Tick) -> Kernel:
    """Sets the clock to a number of steps from the present one."""
    return Kernel("set_clock", (device_span, step_scheme, tick))


def set_stress(moving: Moving, cell_dilatation: CellDilatation) -> Kernel:
    """Sets the stresses of cells by their complete V θ, which is set to zero.

    Over one index, in `core/gpu/cells.hpp`.
    """
    return Kernel("set_stress", (moving, cell_dilatation))


def settle_face(face_pairs: FacePairs) -> Kernel:
    """Launched for `begin_face_contacts`: begins the contact of faces that part in this step.

    Over one index, in `core/gpu/begun_contacts.hpp`.
    """
    return Kernel("settle_face", (face_pairs,))


def settle_faces_of_cell(face_pairs: FacePairs) -> Kernel:
    """Launched for `begin_face_contacts`: begins the contact of faces that part in this step.

    Over one index, in `core/gpu/begun_contacts.hpp`.
    """
    return Kernel("settle_faces_of_cell", (face_pairs,))


def slide_crack_of(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks,
    crack_lists: CrackLists
) -> Kernel:
    """Launched for `slide_cracks`: sums the forces of the cracks of each cell, and lets their faces slip by them.

    Over one index, in `core/gpu/cracks.hpp`.
    """
    return Kernel("slide_crack_of", (device_span, moving, elastic_facets, cohesive_cracks, crack_lists))


def soften_crack(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, facet_strengths: FacetStrengths,
    stresses_of_cells: StressesOfCells, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> Kernel:
    """Lowers the integrities of cracks, and finds those that go to rest.

    Over one index, in `core/gpu/cracks.hpp`.
    """
    return Kernel("soften_crack", (
        device_span, moving, elastic_facets, facet_strengths, stresses_of_cells, cohesive_cracks, crack_lists
    ))


def soften_listed(
    device_span: DeviceSpan, moving: Moving, beams: Beams, softening_bounds: SofteningBounds, softening_beams:
    SofteningBeams, softening_losses: SofteningLosses
) -> Kernel:
    """The row at place e of the lists."""
    return Kernel("soften_listed", (device_span, moving, beams, softening_bounds, softening_beams, softening_losses))


def strain_portion(moving: Moving, strain: Strain, beams: Beams, strain_portions: StrainPortions) -> Kernel:
    """Launched for `follow_strains`: sets rest lengths L (1 + ε*), and adds the work of the strains.

    Over one index, in `core/gpu/strains.hpp`.
    """
    return Kernel("strain_portion", (moving, strain, beams, strain_portions))


def stretch_cell_anew(
    cell_strains: CellStrains, elastic_facets: ElasticFacets, facets_of_cells: FacetsOfCells, yielding_cells:
    YieldingCells
) -> Kernel:
    """Launched for `stretch_anew`: stretches levers with the plastic deformation of their cells, where stress-free
    strains have set them anew.

    Over one index, in `core/gpu/yielding.hpp`.
    """
    return Kernel("stretch_cell_anew", (cell_strains, elastic_facets, facets_of_cells, yielding_cells))


def stretch_crack_of_cells(
    device_span: DeviceSpan, elastic_facets: ElasticFacets, yielding_cells: YieldingCells, cohesive_cracks:
    CohesiveCracks
) -> Kernel:
    """Launched for `stretch_walls_and_cracks`: stretches levers of walls and cracks with the plastic deformation
    of their cells, where it has grown.

    Over one index, in `core/gpu/yielding.hpp`.
    """
    return Kernel("stretch_crack_of_cells", (device_span, elastic_facets, yielding_cells, cohesive_cracks))


def stretch_facet_of_step(cell_strains: CellStrains, elastic_facets: ElasticFacets) -> Kernel:
    """Launched for `follow_cell_strains`: sets stress-free strains, and with them the levers of facets and walls,
    to the time of the clock.

    Over one index, in `core/gpu/strains.hpp`.
    """
    return Kernel("stretch_facet_of_step", (cell_strains, elastic_facets))


def stretch_growing_cell(
    device_span: DeviceSpan, elastic_facets: ElasticFacets, facets_of_cells: FacetsOfCells, yielding_cells:
    YieldingCells
) -> Kernel:
    """Stretches levers of facets with the plastic deformation of their cells, where it has grown.

    Over one index, in `core/gpu/yielding.hpp`.
    """
    return Kernel("stretch_growing_cell", (device_span, elastic_facets, facets_of_cells, yielding_cells))


def stretch_wall_anew(
    cell_strains: CellStrains, wall_constraints: WallConstraints, yielding_cells: YieldingCells
) -> Kernel:
    """Launched for `stretch_anew`: stretches levers with the plastic deformation of their cells, where stress-free
    strains have set them anew.

    Over one index, in `core/gpu/yielding.hpp`.
    """
    return Kernel("stretch_wall_anew", (cell_strains, wall_constraints, yielding_cells))


def stretch_wall_of_cell(
    device_span: DeviceSpan, wall_constraints: WallConstraints, yielding_cells: YieldingCells
) -> Kernel:
    """Launched for `stretch_walls_and_cracks`: stretches levers of walls and cracks with the plastic deformation
    of their cells, where it has grown.

    Over one index, in `core/gpu/yielding.hpp`.
    """
    return Kernel("stretch_wall_of_cell", (device_span, wall_constraints, yielding_cells))


def stretch_wall_of_step(cell_strains: CellStrains, wall_constraints: WallConstraints) -> Kernel:
    """Launched for `follow_cell_strains`: sets stress-free strains, and with them the levers of facets and walls,
    to the time of the clock.

    Over one index, in `core/gpu/strains.hpp`.
    """
    return Kernel("stretch_wall_of_step", (cell_strains, wall_constraints))


def stretch_yielded_cell(
    elastic_facets: ElasticFacets, facets_of_cells: FacetsOfCells, yielding_cells: YieldingCells
) -> Kernel:
    """Stretches levers of all facets with the plastic deformation of their cells, as a run begins.

    Over one index, in `core/gpu/yielding.hpp`.
    """
    return Kernel("stretch_yielded_cell", (elastic_facets, facets_of_cells, yielding_cells))


def subtract_portion_of_dilatation(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints,
    corrected_mass: CorrectedMass, portions: Portions
) -> Kernel:
    """Subtracts the correction of the mass from the kinetic energies of cells.

    Over one index, in `core/gpu/cells.hpp`.
    """
    return Kernel("subtract_portion_of_dilatation", (
        device_span, moving, elastic_facets, wall_constraints, corrected_mass, portions
    ))


def sum_cracks_of_cell(
    stresses_of_cells: StressesOfCells, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> Kernel:
    """Launched for `slide_cracks`: sums the forces of the cracks of each cell, and lets their faces slip by them.

    Over one index, in `core/gpu/cracks.hpp`.
    """
    return Kernel("sum_cracks_of_cell", (stresses_of_cells, cohesive_cracks, crack_lists))


def sum_group_of_losses(losses_of_cracks: LossesOfCracks) -> Kernel:
    """Launched for `log_cracks`: adds up the dissipation of cracks, and logs cracks without integrity.

    Over one index, in `core/gpu/cracks.hpp`.
    """
    return Kernel("sum_group_of_losses", (losses_of_cracks,))


def sum_moments_of_cell(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, facets_of_cells: FacetsOfCells,
    facet_forces: FacetForces
) -> Kernel:
    """Finds V σ of cells from stored forces at the start of a run, with the bits of the sums of a step.

    Over one index, in `core/gpu/crack_onset.hpp`.
    """
    return Kernel("sum_moments_of_cell", (device_span, moving, elastic_facets, facets_of_cells, facet_forces))


def sum_portion_at_walls(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts,
    walls: Walls, contact_energies: ContactEnergies
) -> Kernel:
    """Adds the elastic energy of contacts of a portion with walls [J].

    Over one index, in `core/gpu/contacts.hpp`.
    """
    return Kernel("sum_portion_at_walls", (
        device_span, moving, contact_constants, wall_contacts, walls, contact_energies
    ))


def sum_portion_of_adhesion(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs,
    contact_energies: ContactEnergies
) -> Kernel:
    """Adds the energy of adhesion of the pairs of a portion, below 0 [J].

    Over one index, in `core/gpu/adhesion.hpp`.
    """
    return Kernel("sum_portion_of_adhesion", (
        device_span, moving, contact_constants, contact_pairs, contact_energies
    ))


def sum_portion_of_adhesion_at_walls(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, wall_contacts: WallContacts,
    walls: Walls, contact_energies: ContactEnergies
) -> Kernel:
    """Adds the energy of adhesion at walls of a portion of elements, below 0 [J].

    Over one index, in `core/gpu/adhesion.hpp`.
    """
    return Kernel("sum_portion_of_adhesion_at_walls", (
        device_span, moving, contact_constants, wall_contacts, walls, contact_energies
    ))


def sum_portion_of_beams(device_span: DeviceSpan, moving: Moving, beams: Beams, portions: Portions) -> Kernel:
    """Sums normal, shear, bending and twisting energy of a portion [J].

    Over one index, in `core/gpu/beams.hpp`.
    """
    return Kernel("sum_portion_of_beams", (device_span, moving, beams, portions))


def sum_portion_of_begun(
    device_span: DeviceSpan, contact_pairs: ContactPairs, face_pairs: FacePairs, begun_faces: BegunFaces
) -> Kernel:
    """Launched for `begin_face_contacts`: begins the contact of faces that part in this step.

    Over one index, in `core/gpu/begun_contacts.hpp`.
    """
    return Kernel("sum_portion_of_begun", (device_span, contact_pairs, face_pairs, begun_faces))


def sum_portion_of_cells(
    device_span: DeviceSpan, cell_dilatation: CellDilatation, dilatation_energy: DilatationEnergy
) -> Kernel:
    """Sums the energy of dilatation of a portion of cells, whose V θ is complete and is set to zero [J].

    Over one index, in `core/gpu/cells.hpp`.
    """
    return Kernel("sum_portion_of_cells", (device_span, cell_dilatation, dilatation_energy))


def sum_portion_of_crack_powers(
    device_span: DeviceSpan, moving: Moving, cell_strains: CellStrains, elastic_facets: ElasticFacets,
    cohesive_cracks: CohesiveCracks, strain_portions: StrainPortions
) -> Kernel:
    """Launched for `sum_crack_powers`: sets ∂U/∂factor of the stress-free strains at cracks that are treated one
    by one, where it is needed.

    Over one index, in `core/gpu/yielding.hpp`.
    """
    return Kernel("sum_portion_of_crack_powers", (
        device_span, moving, cell_strains, elastic_facets, cohesive_cracks, strain_portions
    ))


def sum_portion_of_cracks(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks,
    crack_portions: CrackPortions
) -> Kernel:
    """Sums the energies of the cracks that are treated one by one [J].

    Over one index, in `core/gpu/crack_report.hpp`.
    """
    return Kernel("sum_portion_of_cracks", (device_span, moving, elastic_facets, cohesive_cracks, crack_portions))


def sum_portion_of_crushing(
    device_span: DeviceSpan, facet_strengths: FacetStrengths, cohesive_cracks: CohesiveCracks, crushing_portions:
    CrushingPortions
) -> Kernel:
    """Launched for `write_crushing_of_facets`: writes the energy that facets have released beyond their fracture
    energy.

    Over one index, in `core/gpu/crack_report.hpp`.
    """
    return Kernel("sum_portion_of_crushing", (device_span, facet_strengths, cohesive_cracks, crushing_portions))


def sum_portion_of_elements(device_span: DeviceSpan, moving: Moving, portions: Portions) -> Kernel:
    """Sums kinetic energies and losses of a portion [J].

    Over one index, in `core/gpu/record.hpp`.
    """
    return Kernel("sum_portion_of_elements", (device_span, moving, portions))


def sum_portion_of_faces(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs,
    face_pairs: FacePairs, contact_energies: ContactEnergies
) -> Kernel:
    """Adds the elastic energy of the pairs of a portion that touch by faces [J].

    Over one index, in `core/gpu/contacts.hpp`.
    """
    return Kernel("sum_portion_of_faces", (
        device_span, moving, contact_constants, contact_pairs, face_pairs, contact_energies
    ))


def sum_portion_of_facets(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, portions: Portions
) -> Kernel:
    """Sums normal, shear, bending and twisting energy of the facets of a portion, without dilatation [J].

    Over one index, in `core/gpu/cells.hpp`.
    """
    return Kernel("sum_portion_of_facets", (device_span, moving, elastic_facets, portions))


def sum_portion_of_gradients(
    device_span: DeviceSpan, moving: Moving, cell_dilatation: CellDilatation, wall_constraints: WallConstraints,
    dilatation_gradients: DilatationGradients
) -> Kernel:
    """Sums the energies of gradients in portions of cells, for the dilatation that facets have added up.

    Over one index, in `core/gpu/cells.hpp`.
    """
    return Kernel("sum_portion_of_gradients", (
        device_span, moving, cell_dilatation, wall_constraints, dilatation_gradients
    ))


def sum_portion_of_heat(
    device_span: DeviceSpan, stresses_of_cells: StressesOfCells, yielding_cells: YieldingCells, crack_energies:
    CrackEnergies
) -> Kernel:
    """Sums the energy that the cells of a portion have dissipated by yielding [J].

    Over one index, in `core/gpu/yielding.hpp`.
    """
    return Kernel("sum_portion_of_heat", (device_span, stresses_of_cells, yielding_cells, crack_energies))


def sum_portion_of_losses(device_span: DeviceSpan, losses_of_cracks: LossesOfCracks) -> Kernel:
    """Launched for `log_cracks`: adds up the dissipation of cracks, and logs cracks without integrity.

    Over one index, in `core/gpu/cracks.hpp`.
    """
    return Kernel("sum_portion_of_losses", (device_span, losses_of_cracks))


def sum_portion_of_pairs(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs,
    contact_energies: ContactEnergies
) -> Kernel:
    """Sums the elastic energy of the pairs of a portion [J].

    Over one index, in `core/gpu/contacts.hpp`.
    """
    return Kernel("sum_portion_of_pairs", (device_span, moving, contact_constants, contact_pairs, contact_energies))


def sum_portion_of_pressure(
    device_span: DeviceSpan, moving: Moving, beams: Beams, softening_bounds: SofteningBounds, portions: Portions
) -> Kernel:
    """Adds the energy of the pressure on softened beams of a portion to their normal energy.

    Over one index, in `core/gpu/softening_beams.hpp`.
    """
    return Kernel("sum_portion_of_pressure", (device_span, moving, beams, softening_bounds, portions))


def sum_portion_of_rolling(
    device_span: DeviceSpan, contact_constants: ContactConstants, contact_pairs: ContactPairs, rolled_pairs:
    RolledPairs, contact_energies: ContactEnergies
) -> Kernel:
    """Adds the energy that springs of rolling store in the pairs of a portion [J].

    Over one index, in `core/gpu/rolling.hpp`.
    """
    return Kernel("sum_portion_of_rolling", (
        device_span, contact_constants, contact_pairs, rolled_pairs, contact_energies
    ))


def sum_portion_of_rolling_at_walls(
    device_span: DeviceSpan, contact_constants: ContactConstants, wall_contacts: WallContacts, rolled_walls:
    RolledWalls, contact_energies: ContactEnergies
) -> Kernel:
    """Adds the energy that springs of rolling store at walls, of a portion of elements [J].

    Over one index, in `core/gpu/rolling.hpp`.
    """
    return Kernel("sum_portion_of_rolling_at_walls", (
        device_span, contact_constants, wall_contacts, rolled_walls, contact_energies
    ))


def sum_portion_of_springs(
    device_span: DeviceSpan, moving: Moving, beams: Beams, non_local_bonds: NonLocalBonds, portions: Portions,
    non_local_work: NonLocalWork
) -> Kernel:
    """Sums normal and shear energy of the springs of a portion, and the work of extra forces [J].

    Over one index, in `core/gpu/non_local_pairs.hpp`.
    """
    return Kernel("sum_portion_of_springs", (device_span, moving, beams, non_local_bonds, portions, non_local_work))


def sum_portion_of_stored(
    device_span: DeviceSpan, moving: Moving, beams: Beams, stored_loads: StoredLoads, portions: Portions
) -> Kernel:
    """Sums normal, shear, bending and twisting energy of a portion [J].

    Over one index, in `core/gpu/storing_beams.hpp`.
    """
    return Kernel("sum_portion_of_stored", (device_span, moving, beams, stored_loads, portions))


def sum_portion_of_walls(moving: Moving, wall_constraints: WallConstraints, wall_energy: WallEnergy) -> Kernel:
    """Pass of one index, defined in `core/gpu/cells.hpp`."""
    return Kernel("sum_portion_of_walls", (moving, wall_constraints, wall_energy))


def sum_portion_of_works(rows: Rows, work_portions: WorkPortions) -> Kernel:
    """Pass of one index, defined in `core/gpu/record.hpp`."""
    return Kernel("sum_portion_of_works", (rows, work_portions))


def sum_strain_portion(
    device_span: DeviceSpan, moving: Moving, cell_strains: CellStrains, elastic_facets: ElasticFacets
) -> Kernel:
    """Pass of one index, defined in `core/gpu/strains.hpp`."""
    return Kernel("sum_strain_portion", (device_span, moving, cell_strains, elastic_facets))


def sum_stress_difference(moving: Moving, dilatation_gradients: DilatationGradients) -> Kernel:
    """Sums the differences between the stresses of each cell and those of its neighbours.

    Over one index, in `core/gpu/cells.hpp`.
    """
    return Kernel("sum_stress_difference", (moving, dilatation_gradients))


def sum_stressed_portion(
    device_span: DeviceSpan, moving: Moving, cell_dilatation: CellDilatation, crack_energies: CrackEnergies
) -> Kernel:
    """Sums the energy of dilatation of a portion of cells by their stresses [J].

    Over one index, in `core/gpu/crack_report.hpp`.
    """
    return Kernel("sum_stressed_portion", (device_span, moving, cell_dilatation, crack_energies))


def take_beams_off_element(
    bonds_of_elements: BondsOfElements, bond_marks: BondMarks, loads_of_bonds: LoadsOfBonds, candidates:
    Candidates, postponed: Postponed
) -> Kernel:
    """Launched for `break_beams`: removes the beams that fail.

    Over one index, in `core/gpu/breakage.hpp`.
    """
    return Kernel("take_beams_off_element", (bonds_of_elements, bond_marks, loads_of_bonds, candidates, postponed))


def take_dashpots_off_element(
    bonds_of_elements: BondsOfElements, bond_marks: BondMarks, loads_of_bonds: LoadsOfBonds, dashpots: Dashpots,
    candidates: Candidates, postponed: Postponed
) -> Kernel:
    """The sums of all forces and the sums of dashpots alone both contain these loads."""
    return Kernel("take_dashpots_off_element", (
        bonds_of_elements, bond_marks, loads_of_bonds, dashpots, candidates, postponed
    ))


def take_leaving(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, cell_dilatation: CellDilatation,
    cell_slack: CellSlack, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> Kernel:
    """Launched for `leave_cracks`: puts cracks to rest, or parts their faces, as `soften_cracks` has found.

    Over one index, in `core/gpu/cracks.hpp`.
    """
    return Kernel("take_leaving", (
        device_span, moving, elastic_facets, cell_dilatation, cell_slack, cohesive_cracks, crack_lists
    ))


def take_over_energies(contact_pairs: ContactPairs, near_pairs: NearPairs, event_log: EventLog) -> Kernel:
    """Subtracts the energies that contacts store from the energy released in the run, in the order of the events."""
    return Kernel("take_over_energies", (contact_pairs, near_pairs, event_log))


def take_over_from_cracks(begun_faces: BegunFaces, event_log: EventLog) -> Kernel:
    """Subtracts the energy that faces store as they begin to touch from the released energy."""
    return Kernel("take_over_from_cracks", (begun_faces, event_log))


def take_pairs_off_element(
    non_local_bonds: NonLocalBonds, bonds_of_elements: BondsOfElements, bond_marks: BondMarks, candidates:
    Candidates, postponed: Postponed
) -> Kernel:
    """Launched for `break_pairs`: removes the bonds that fail: their force from the kept sums, and the energy of
    their springs.

    Over one index, in `core/gpu/non_local_pairs.hpp`.
    """
    return Kernel("take_pairs_off_element", (non_local_bonds, bonds_of_elements, bond_marks, candidates, postponed))


def take_woken(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, cell_dilatation: CellDilatation,
    cell_slack: CellSlack, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> Kernel:
    """Launched for `wake_cracks`: treats resting cracks one by one again that are about to soften or close.

    Over one index, in `core/gpu/cracks.hpp`.
    """
    return Kernel("take_woken", (
        device_span, moving, elastic_facets, cell_dilatation, cell_slack, cohesive_cracks, crack_lists
    ))


def touch_parted_face(
    moving: Moving, contact_pairs: ContactPairs, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists,
    parted_reach: PartedReach
) -> Kernel:
    """Makes pairs of the cells whose faces have parted in this step."""
    return Kernel("touch_parted_face", (moving, contact_pairs, cohesive_cracks, crack_lists, parted_reach))


def turn_stress_of_element(moving: Moving, lagged_stresses: LaggedStresses) -> Kernel:
    """Turns the stresses of a step ago with their elements.

    Over one index, in `core/gpu/non_local_pairs.hpp`.
    """
    return Kernel("turn_stress_of_element", (moving, lagged_stresses))


def twist_layer(
    moving: Moving, wall_constraints: WallConstraints, dilatation_gradients: DilatationGradients
) -> Kernel:
    """Computes the torques of bent layers on each cell.

    Over one index, in `core/gpu/cells.hpp`.
    """
    return Kernel("twist_layer", (moving, wall_constraints, dilatation_gradients))


def wake_crack(
    moving: Moving, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> Kernel:
    """Launched for `wake_cracks`: treats resting cracks one by one again that are about to soften or close.

    Over one index, in `core/gpu/cracks.hpp`.
    """
    return Kernel("wake_crack", (moving, elastic_facets, cohesive_cracks, crack_lists))


def watch_resting_crack(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, facet_strengths: FacetStrengths,
    cohesive_cracks: CohesiveCracks, crack_lists: CrackLists
) -> Kernel:
    """Finds the resting cracks that are about to soften or close.

    Over one index, in `core/gpu/cracks.hpp`.
    """
    return Kernel("watch_resting_crack", (
        device_span, moving, elastic_facets, facet_strengths, cohesive_cracks, crack_lists
    ))


def weigh_cell(cell_dilatation: CellDilatation, cell_slack: CellSlack, cohesive_cracks: CohesiveCracks) -> Kernel:
    """Computes the weights of the cells of all cracks at the start of a run.

    Over one index, in `core/gpu/cracks.hpp`.
    """
    return Kernel("weigh_cell", (cell_dilatation, cell_slack, cohesive_cracks))


def withdraw_facets_of_cell(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, facet_release: FacetRelease,
    candidates: Candidates, postponed: Postponed
) -> Kernel:
    """Lists the cells whose loads change, and subtracts the loads of their facets and walls from the kept sums.

    Over one index, in `core/gpu/facet_breakage.hpp`.
    """
    return Kernel("withdraw_facets_of_cell", (
        moving, elastic_facets, wall_constraints, facet_release, candidates, postponed
    ))


def write_all_crushing_of_beams(
    device_span: DeviceSpan, softening_bounds: SofteningBounds, softening_beams: SofteningBeams, event_log:
    EventLog, history_rows: HistoryRows
) -> Kernel:
    """Writes the energy that beams have released beyond their fracture energy.

    Over one index, in `core/gpu/softening_beams.hpp`.
    """
    return Kernel("write_all_crushing_of_beams", (
        device_span, softening_bounds, softening_beams, event_log, history_rows
    ))


def write_all_crushing_of_facets(
    device_span: DeviceSpan, crushing_portions: CrushingPortions, event_log: EventLog, history_rows: HistoryRows
) -> Kernel:
    """Launched for `write_crushing_of_facets`: writes the energy that facets have released beyond their fracture
    energy.

    Over one index, in `core/gpu/crack_report.hpp`.
    """
    return Kernel("write_all_crushing_of_facets", (device_span, crushing_portions, event_log, history_rows))


def write_energy_of_contacts(
    device_span: DeviceSpan, contact_energies: ContactEnergies, history_rows: HistoryRows
) -> Kernel:
    """Adds the energy of contacts to a record.

    Over one index, in `core/gpu/contacts.hpp`.
    """
    return Kernel("write_energy_of_contacts", (device_span, contact_energies, history_rows))


def write_energy_of_yielding(
    device_span: DeviceSpan, crack_energies: CrackEnergies, history_rows: HistoryRows
) -> Kernel:
    """Writes the heat of yielding into a record.

    Over one index, in `core/gpu/crack_report.hpp`.
    """
    return Kernel("write_energy_of_yielding", (device_span, crack_energies, history_rows))


def write_facet_failure(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints,
    facet_release: FacetRelease, bond_marks: BondMarks, candidates: Candidates, event_log: EventLog
) -> Kernel:
    """Finds the energy of failed facet number e, which keeps its integrity until all energies are known."""
    return Kernel("write_facet_failure", (
        device_span, moving, elastic_facets, wall_constraints, facet_release, bond_marks, candidates, event_log
    ))


def write_gauge(
    device_span: DeviceSpan, gauges: Gauges, gauge_parts: GaugeParts, history_rows: HistoryRows
) -> Kernel:
    """Component k % 3 of gauge k / 3, in the present row of records."""
    return Kernel("write_gauge", (device_span, gauges, gauge_parts, history_rows))


def write_gauge_of_wall(device_span: DeviceSpan, walls: Walls, gauges: Gauges, history_rows: HistoryRows) -> Kernel:
    """Launched for `write_walls`: adds the work of walls to a record, and writes gauges of walls.

    Over one index, in `core/gpu/contacts.hpp`.
    """
    return Kernel("write_gauge_of_wall", (device_span, walls, gauges, history_rows))


def write_pair_failure(
    device_span: DeviceSpan, moving: Moving, beams: Beams, non_local_bonds: NonLocalBonds, candidates: Candidates,
    event_log: EventLog
) -> Kernel:
    """Launched for `break_pairs`: removes the bonds that fail: their force from the kept sums, and the energy of
    their springs.

    Over one index, in `core/gpu/non_local_pairs.hpp`.
    """
    return Kernel("write_pair_failure", (device_span, moving, beams, non_local_bonds, candidates, event_log))


def write_released_energy(device_span: DeviceSpan, event_log: EventLog, history_rows: HistoryRows) -> Kernel:
    """Writes the energy released into a record.

    Over one index, in `core/gpu/breakage.hpp`.
    """
    return Kernel("write_released_energy", (device_span, event_log, history_rows))


def write_sum(device_span: DeviceSpan, folded_portions: FoldedPortions, history_rows: HistoryRows) -> Kernel:
    """Column c of the present row of records."""
    return Kernel("write_sum", (device_span, folded_portions, history_rows))


def write_work_of_extra_forces(
    device_span: DeviceSpan, non_local_work: NonLocalWork, history_rows: HistoryRows
) -> Kernel:
    """Writes the work of the extra forces of bonds to the energy balance.

    Over one index, in `core/gpu/non_local_pairs.hpp`.
    """
    return Kernel("write_work_of_extra_forces", (device_span, non_local_work, history_rows))


def write_work_of_walls(device_span: DeviceSpan, walls: Walls, history_rows: HistoryRows) -> Kernel:
    """Launched for `write_walls`: adds the work of walls to a record, and writes gauges of walls.

    Over one index, in `core/gpu/contacts.hpp`.
    """
    return Kernel("write_work_of_walls", (device_span, walls, history_rows))


def yield_cell(
    device_span: DeviceSpan, moving: Moving, stresses_of_cells: StressesOfCells, yielding_cells: YieldingCells,
    crack_onset: CrackOnset
) -> Kernel:
    """Lets the cells of a portion yield whose stress reaches their yield surface.

    Over one index, in `core/gpu/yielding.hpp`.
    """
    return Kernel("yield_cell", (device_span, moving, stresses_of_cells, yielding_cells, crack_onset))


#: Passes `begin_beam_by_…` by the name of their criterion.
BEGIN_BEAM_BY = {
    "mohr_coulomb": begin_beam_by_mohr_coulomb,
    "peripheral_stress": begin_beam_by_peripheral_stress,
}
#: Passes `judge_beam_by_…` by the name of their criterion.
JUDGE_BEAM_BY = {
    "ellipse": judge_beam_by_ellipse,
    "linear_sum": judge_beam_by_linear_sum,
    "mohr_coulomb": judge_beam_by_mohr_coulomb,
    "peripheral_stress": judge_beam_by_peripheral_stress,
}
#: Passes `judge_facet_by_…` by the name of their criterion.
JUDGE_FACET_BY = {
    "mohr_coulomb": judge_facet_by_mohr_coulomb,
}
