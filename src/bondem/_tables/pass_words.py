"""Purposes of the passes of a step, written by `python -m tests.core.tables` from the headers."""

#: What the passes of each kind run over.
KINDS = (
    "once",
    "bonds of a block",
    "elements of a block, then shared ones",
    "elements that domains share",
    "elements, in portions",
    "bonds, in portions",
    "elements of a block, which it divides",
    "postponed elements of a block",
    "elements, in a range a thread",
)
#: What each pass is for.
SENTENCES = {
    "accumulate_and_mark": "Adds what facets contribute to V θ of their cells, and marks facets near to failure.",
    "accumulate_dilatation": "Adds what the facets of a block contribute to V θ of their cells.",
    "accumulate_left_dilatation": (
        "Adds what facets contribute to V θ of their cells, where many facets have no integrity left."
    ),
    "add_adhesion_loads": "Adds adhesion to the elements of a range.",
    "add_alike_beam_loads": "Adds forces and torques of beams that differ in length only.",
    "add_alike_beam_loads_softening_by_mohr_coulomb": (
        "Adds forces and torques of beams that may soften, with the pressure on softened ones."
    ),
    "add_alike_beam_loads_softening_by_peripheral_stress": (
        "Adds forces and torques of beams that may soften, with the pressure on softened ones."
    ),
    "add_and_keep_facet_loads": (
        "Adds and keeps the forces of the facets of a block, and adds up the moments V σ of their cells."
    ),
    "add_beam_loads": "Adds forces and torques of the beams of a block to the sums of their elements.",
    "add_beam_loads_softening_by_mohr_coulomb": (
        "Adds forces and torques of beams that may soften, with the pressure on softened ones."
    ),
    "add_beam_loads_softening_by_peripheral_stress": (
        "Adds forces and torques of beams that may soften, with the pressure on softened ones."
    ),
    "add_begun_contacts": (
        "Adds to the stresses of the ends of bonds that have failed in this step what the contact does that follows "
        "them; after that contact has begun."
    ),
    "add_body_forces": "Adds body forces to the sums, and their work over the half of the step that ends.",
    "add_body_work": (
        "Adds the work of body forces over the half of the step that begins, behind the pass by which elements move, "
        "or open a step."
    ),
    "add_cell_energies": (
        "Adds the energy of dilatation, and that of half facets at walls, to the normal energy of the first portion "
        "of facets."
    ),
    "add_contact_loads": (
        "Adds forces of contacts to the sums of elements, and losses to theirs, and leaves them at zero."
    ),
    "add_crack_energies": "Adds the energies of cracks and walls to those of the first portion of facets.",
    "add_crack_loads": "Adds the forces of cracks that are treated one by one to the sums of their cells.",
    "add_dashpot_loads": "Adds forces and torques of the dashpots of beams to sums of their own.",
    "add_dashpots": (
        "Adds the forces of dashpots to those of springs; they stay, as the power that they take is found later."
    ),
    "add_face_loads": "Adds what faces do to the elements of a range.",
    "add_facet_loads": (
        "Adds forces and torques of the facets of a block to the sums of their cells, whose stresses are known."
    ),
    "add_gradient_energies": "Adds the energies of gradients to those of the facets.",
    "add_inertia_forces": "Adds the forces of the correction to the sums of the elements.",
    "add_lasting_loads": "Finds and adds forces and torques of bonds that cannot fail, without keeping them.",
    "add_layer_torques": "Adds the torques of bent layers to the sums of the cells.",
    "add_marked_alike_beam_loads": (
        "Adds forces and torques of beams that differ in length only, and marks beams near to failure."
    ),
    "add_marked_beam_loads": "Adds forces and torques of the beams of a block, and marks beams near to failure.",
    "add_non_local_loads": (
        "Adds forces and torques of the bonds to the sums of the elements, in the order of the bonds."
    ),
    "add_pair_loads": "Adds what pairs do to the elements of a range, in the order of the pairs.",
    "add_pair_moments": (
        "Adds what contacts of pairs do to the stresses of the elements of a range, in the order of the pairs."
    ),
    "add_rolling_loads": "Adds moments of resistance to rolling to the elements of a range.",
    "add_still_surface_stresses": (
        "Adds what walls and loads on free facets do to the stresses of surface cells that were found without a step."
    ),
    "add_stored_loads": (
        "Integrates the stored forces and moments of the beams of a block over the step, and adds them to the sums of"
        " their elements."
    ),
    "add_strain_work": "Adds the work of strains that have changed, when the forces after that are known.",
    "add_stress_differences": "Adds the forces of the springs between cells to their stresses.",
    "add_surface_stresses": "Adds what walls and loads on free facets do to the stresses of surface cells.",
    "add_traction_work": (
        "Adds half the work of tractions that change: once by the stresses before, and once by those after."
    ),
    "add_wall_dilatation": "Adds what walls contribute to V θ of their cells.",
    "add_wall_loads": "Adds the forces of walls to the sums of their cells.",
    "add_wall_moments": "Adds what walls do to the stresses of the elements of a portion.",
    "add_yielding_work": "Adds the work of loads on free facets that move as their cells yield.",
    "adhere_at_walls": "Finds the adhesion of a portion of elements at walls.",
    "adhere_pairs": "Finds the adhesion of the near pairs of a portion of elements.",
    "apply_walls": (
        "Sets the forces of walls on the rows of their cells, whose stresses are known, and adds the work of walls "
        "that move: the trapezoid of the force over the displacement."
    ),
    "begin_bases": "Takes over V θ of cells without their cracks.",
    "begin_contacts": (
        "Begins contact where beams have broken in this step, on the sums that are kept for their ends."
    ),
    "begin_crack_powers": (
        "Sets ∂U/∂factor of the stress-free strains by the forces that cracks have, where the time of the clock was "
        "not reached by a step."
    ),
    "begin_cracks": "Begins the cracks of facets that are marked.",
    "begin_face_contacts": "Begins the contact of faces that part in this step.",
    "begin_softened_contacts": (
        "Begins contact where beams that soften have broken at the beginning of this step: its energy is that of the "
        "pressure, which it replaces."
    ),
    "begin_softening": (
        "Writes the rows of beams that have begun to soften in this step, and adds up what they have dissipated."
    ),
    "begin_strain_work": (
        "Finds ∂U/∂factor by the stresses in the poses, where the time of the clock was not reached by a step."
    ),
    "bend_layers": "Computes how layers one cell thick are bent at each cell.",
    "break_beams": "Removes the beams that fail.",
    "break_facets": "Removes the facets that fail, and brings the stresses of their cells up to date.",
    "break_pairs": "Removes the bonds that fail: their force from the kept sums, and the energy of their springs.",
    "carry_cracks": "Sums b⊗f of the cracks of each cell from their forces of the last step.",
    "check_beams": (
        "Counts unbroken beams of a portion that are turned beyond the range of their energy, and beyond its end."
    ),
    "check_facets": (
        "Counts unbroken facets of a portion that are turned beyond the range of their energy, and beyond its end."
    ),
    "check_travel": "Finds whether the list may miss a contact by now, also where a centre is not a number.",
    "clear_row_forces": "Leaves the forces of all rows at zero, for the loads that are added next.",
    "collect_dashpots": (
        "Adds to the sums of shared elements what dashpots of other domains have for them, and leaves zeros there."
    ),
    "collect_dilatation": (
        "Adds to V θ of shared cells what facets of other domains have for them, and leaves zeros there."
    ),
    "collect_facet_moments": (
        "Adds to the sums of moments of shared cells what facets of other domains have for them, and leaves zeros "
        "there."
    ),
    "collect_moments": (
        "Adds to shared elements what bonds of other domains have for their stresses, and leaves zeros there."
    ),
    "collect_sums": (
        "Adds to the sums of shared elements what bonds of other domains have for them, and leaves zeros there."
    ),
    "count_wall_work": "Finds what walls have supplied, for the guard of the energy.",
    "find_accelerations": "Computes the accelerations of the elements by their loads alone.",
    "find_cell_stresses": (
        "Finds the mean stresses of cells from the forces of the last step on their facets and cracks."
    ),
    "find_dilatation_inertia": "Computes ρ β θ̈ of the cells by the accelerations of the elements.",
    "find_inertia_forces": "Computes the forces of the correction on the elements.",
    "find_non_local_forces": (
        "Finds forces and torques of the bonds of a block, integrates what they store over the step, and adds what "
        "they do to the stresses of their elements."
    ),
    "find_still_stresses": (
        "Finds the mean stresses of cells where forces of the present were found anew, without a step."
    ),
    "find_strengths_along": "Keeps the strengths of facets that begin to crack.",
    "find_stress_candidates": (
        "Writes the stresses of facets in tension, as candidates of a portion; marks facets of cells without "
        "cohesion."
    ),
    "find_stresses": (
        "Finds the stresses of a portion, and bounds of their principal stresses; leaves zeros in the moments."
    ),
    "find_stresses_of_block": (
        "Finds the stresses of the elements of a block, and bounds of their principal stresses; leaves zeros in the "
        "moments."
    ),
    "follow_body_forces": "Brings body forces to the time of the clock.",
    "follow_cell_strains": (
        "Brings stress-free strains, and with them the levers of facets and walls, to the time of the clock."
    ),
    "follow_couples": "Adds moments on regions as forces and torques of their elements.",
    "follow_drives": "Sets prescribed velocities at the time of the clock, and over the step that begins there.",
    "follow_levers": "Takes over the levers of facets, where strains of cells have changed them.",
    "follow_loads": "Adds forces and torques, those that turn with their elements turned.",
    "follow_strains": "Sets rest lengths L (1 + ε*), and adds the work of the strains.",
    "follow_tractions": "Brings tractions to the time of the clock.",
    "follow_walls": (
        "Brings walls to the time of the clock; where it was not reached by a step, their forces are brought up to "
        "date as well."
    ),
    "index_candidates_by_cone": "Finds the index of each candidate by a cone in its mean and deviatoric stress.",
    "index_candidates_by_function": "Finds the index of each candidate by a C function, such as that of a user.",
    "index_candidates_by_mean_stress": "Finds the index of each candidate by its mean stress.",
    "judge_beams_by_ellipse": (
        "Finds which of the marked beams of a block fail by a criterion, and holds their elements."
    ),
    "judge_beams_by_linear_sum": (
        "Finds which of the marked beams of a block fail by a criterion, and holds their elements."
    ),
    "judge_beams_by_mohr_coulomb": (
        "Finds which of the marked beams of a block fail by a criterion, and holds their elements."
    ),
    "judge_beams_by_peripheral_stress": (
        "Finds which of the marked beams of a block fail by a criterion, and holds their elements."
    ),
    "judge_cells": (
        "Finds the cells whose facets may crack: those with cracks, and those whose stress may reach their strength."
    ),
    "judge_cells_by_cone": "Finds the cells whose facets are evaluated: those whose stress may reach the cone.",
    "judge_cells_by_mean_stress": (
        "Finds the cells whose facets are evaluated: those whose mean stress may reach the criterion."
    ),
    "judge_cells_by_size": (
        "Finds the cells whose facets are evaluated: those whose stress is large enough for the criterion of a user."
    ),
    "judge_energy": "Finds whether a number is not finite, or the motion has more energy than can have come in.",
    "judge_facets_by_mohr_coulomb": (
        "Finds which of the marked facets fail by a criterion, at the present stresses, and holds their cells and the"
        " neighbours of these."
    ),
    "judge_pairs": "Finds which of the marked bonds of a block fail, and holds their elements.",
    "keep_dashpots": "Keeps the sums of the dashpots of elements that are held.",
    "keep_measures": "Takes over what was measured anew in a step.",
    "keep_sums": "Keeps the sums of elements that are held.",
    "leave_cracks": "Puts cracks to rest, or parts their faces, as `soften_cracks` has found.",
    "link_cracks": (
        "Takes over the cracks of a state as a run begins: constants, weights of cells, lists, and what cracks carry."
    ),
    "list_cracks": "Makes the lists of cracks anew where they are out of date.",
    "list_postponed": (
        "Lists all elements that are held, those that own rows of the boundary last, and ends the failures of the "
        "step."
    ),
    "load_cracks": "Finds forces and torques of the cracks that are treated one by one, and what they dissipate.",
    "load_walls": "Sums the forces of elements on walls, adds their work, and closes the step of free walls.",
    "log_cracks": "Adds up what cracks have dissipated, and logs those without strength left.",
    "log_softened_beams": "Adds up what all portions have dissipated, and logs beams that have broken.",
    "mark_cracking_facets": "Marks facets of the material that begin to crack.",
    "mark_cracking_planes": "Marks facets of planes, such as joints, that begin to crack.",
    "mark_failing_facets": (
        "Marks candidates that fail, and leaves these with the mean stress of their cells, of which the index gives "
        "their strength."
    ),
    "mark_pairs": (
        "Marks the bonds of a block that reach their criterion by bounds of the principal stresses of both elements."
    ),
    "measure_cracks": (
        "Finds faces and halves of the cracks that are treated one by one, and axes of those that have lost nothing "
        "yet."
    ),
    "measure_travel": "Finds how far the elements of a portion are from where distances were measured.",
    "measure_wall_overlaps": (
        "Keeps the deepest overlap of the elements of a portion with a wall, over the radius, where distances are "
        "measured anew."
    ),
    "move_elements": "Elements that own no row of the boundary close the step, and open the next.",
    "move_resisted": (
        "Elements that own no row of the boundary close the step against what resists their motion, and open the "
        "next."
    ),
    "move_resisted_rows": (
        "Elements that own rows of the boundary close the step against what resists their motion, and open the next."
    ),
    "move_rows": "Elements that own rows of the boundary close the step, and open the next.",
    "move_walls": "Takes walls to the end of the step that begins at the time of the clock.",
    "open_body_work": "Adds the work of body forces over the half of the step that begins after a pause.",
    "open_elements": "All elements open a step after a pause; none owns a row of the boundary.",
    "open_elements_and_rows": "All elements open a step after a pause; some own rows of the boundary.",
    "postpone_elements": (
        "Divides the elements of a block, or shared ones, into those that move on and those that are held."
    ),
    "press_pairs": (
        "Finds forces and memory of the pairs of a portion of elements; lists those that may touch where elements "
        "have moved too far since that was done."
    ),
    "press_pairs_and_faces": (
        "Finds forces and memory of the pairs of a portion of cells with cracks, which touch by faces too."
    ),
    "press_walls": "Adds forces of walls to the elements of a portion, and keeps their memory.",
    "read_gauges": "Writes three components of each gauge of elements.",
    "relax_cracked_cells": "Finds the stresses of all cells with cracks that are treated one by one.",
    "relax_stale_cells": "Finds the stresses of cells with cracks that are out of date.",
    "release_pressure": "Ends the pressure on beams that soften and have broken at the beginning of this step.",
    "relieve_pairs": (
        "Takes the force of bonds that fail out of the stresses of their elements, and sets their integrity to 0; "
        "after `break_pairs`."
    ),
    "renew_wall_rows": "Sets the forces of walls on the rows of their cells anew.",
    "reopen_elements": "Elements of a list that own no row of the boundary open a step.",
    "reopen_rows": "Elements of a list that own rows of the boundary open a step.",
    "restore_facets": "Adds the loads of the facets that are left, and of walls, to the kept sums.",
    "roll_at_walls": "Finds moments of resistance to rolling of a portion of elements at walls.",
    "roll_pairs": "Finds moments and memory of the pairs of a portion of elements that touch and may roll.",
    "slide_cracks": "Sums the forces of the cracks of each cell, and lets their faces slip by them.",
    "soften_beams": "Lowers the integrity of beams of a portion that soften, before the forces.",
    "soften_cracks": "Lowers the integrities of cracks, and finds those that go to rest.",
    "stress_cells": "Sets the stresses of cells, whose V θ is complete and left at zero.",
    "stretch_all_cells": (
        "Stretches levers of all facets with the plastic deformation of their cells, as a run begins."
    ),
    "stretch_anew": (
        "Stretches levers with the plastic deformation of their cells, where stress-free strains have set them anew."
    ),
    "stretch_cells": "Stretches levers of facets with the plastic deformation of their cells, where it has grown.",
    "stretch_walls_and_cracks": (
        "Stretches levers of walls and cracks with the plastic deformation of their cells, where it has grown."
    ),
    "subtract_dilatation_energies": "Subtracts from the kinetic energies what the mass of the cells has too much.",
    "sum_adhesion_at_walls": "Adds the energy of adhesion at walls of a portion of elements, below 0 [J].",
    "sum_adhesion_energies": "Adds the energy of adhesion of the pairs of a portion, below 0 [J].",
    "sum_beam_energies": "Sums normal, shear, bending and twisting energy of a portion [J].",
    "sum_crack_energies": "Sums the energies of the cracks that are treated one by one [J].",
    "sum_crack_powers": (
        "Sets ∂U/∂factor of the stress-free strains at cracks that are treated one by one, where it is needed."
    ),
    "sum_dilatation_energies": (
        "Sums the energy of dilatation of a portion of cells, whose V θ is complete and left at zero [J]."
    ),
    "sum_element_energies": "Sums kinetic energies and losses of a portion [J].",
    "sum_face_energies": "Adds the elastic energy of the pairs of a portion that touch by faces [J].",
    "sum_facet_energies": (
        "Sums normal, shear, bending and twisting energy of the facets of a portion, without dilatation [J]."
    ),
    "sum_gradient_energies": (
        "Sums the energies of gradients in portions of cells, for the dilatation that facets have added up."
    ),
    "sum_heat": "Sums the energy that the cells of a portion have dissipated by yielding [J].",
    "sum_moments": (
        "Finds V σ of cells from the forces that are kept, as a run begins, to the bits of the sums of a step."
    ),
    "sum_non_local_energies": (
        "Sums normal and shear energy of the springs of a portion, and the work of extra forces [J]."
    ),
    "sum_pair_energies": "Sums the elastic energy of the pairs of a portion [J].",
    "sum_pressed_energies": (
        "Adds the energy of the pressure on softened beams of a portion to their normal energy."
    ),
    "sum_rolling_at_walls": (
        "Adds the energy that springs of rolling store at walls, of a portion of elements [J]."
    ),
    "sum_rolling_energies": "Adds the energy that springs of rolling store in the pairs of a portion [J].",
    "sum_stored_energies": "Sums normal, shear, bending and twisting energy of a portion [J].",
    "sum_strain_powers": "Sums ∂U/∂factor of the facets of a portion, where it is needed.",
    "sum_stress_differences": (
        "Sums the differences between the stresses of each cell and those of its neighbours."
    ),
    "sum_stressed_dilatation": "Sums the energy of dilatation of a portion of cells by their stresses [J].",
    "sum_wall_energies": "Adds the elastic energy of contacts of a portion with walls [J].",
    "take_moments": "Sets V σ and Σ `bending_square` of cells, whose sums are complete and left at zero.",
    "touch_parted_faces": "Lets the cells touch like others whose faces have parted in this step.",
    "turn_stresses": "Turns the stresses of a step ago with their elements.",
    "twist_layers": "Computes the torques of bent layers on each cell.",
    "wake_cracks": "Treats resting cracks one by one again that are about to soften or close.",
    "watch_resting_cracks": "Finds the resting cracks that are about to soften or close.",
    "weigh_cracked_cells": "Finds the weights of the cells of all cracks, as a run begins.",
    "withdraw_dashpots": (
        "Takes the dashpots of beams that fail off the kept sums of their ends; before the beams are removed."
    ),
    "withdraw_facets": (
        "Lists the cells whose loads change, and takes the loads of their facets and walls off the kept sums."
    ),
    "write_contact_energy": "Adds the energy of contacts to a record.",
    "write_crushing_of_beams": "Writes what beams have released beyond their fracture energy.",
    "write_crushing_of_facets": "Writes what facets have released beyond their fracture energy.",
    "write_heat": "Writes the heat of yielding into a record.",
    "write_ledger": "Writes time and the energy ledger.",
    "write_non_local_work": "Writes the work of the extra forces of bonds to the ledger.",
    "write_released": "Writes the energy released into a record.",
    "write_walls": "Adds the work of walls to a record, and writes gauges of walls.",
    "yield_cells": "Lets the cells of a portion yield whose stress reaches their yield surface.",
}
