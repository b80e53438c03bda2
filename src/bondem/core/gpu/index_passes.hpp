// List of the passes for a GPU, in each of which a thread computes a single bond, element or other index.
// Written by `python -m tests.core.tables` from the other headers here. The macro applies X to each pass.
#pragma once
#include "adhesion.hpp"
#include "beams.hpp"
#include "boundary.hpp"
#include "breakage.hpp"
#include "cells.hpp"
#include "contacts.hpp"
#include "crack_onset.hpp"
#include "crack_report.hpp"
#include "cracks.hpp"
#include "facet_breakage.hpp"
#include "for_each.hpp"
#include "heap_sort.hpp"
#include "motion.hpp"
#include "new_contacts.hpp"
#include "non_local_pairs.hpp"
#include "ranges.hpp"
#include "record.hpp"
#include "rolling.hpp"
#include "softening_beams.hpp"
#include "storing_beams.hpp"
#include "strains.hpp"
#include "stress_onset.hpp"
#include "yielding.hpp"

#define BONDEM_INDEX_PASSES(X) \
    X(adhere_one_pair) X(add_adhesion_of_element) X(adhere_element_at_walls) X(sum_portion_of_adhesion) \
    X(sum_portion_of_adhesion_at_walls) X(load_beam) X(load_uniform_beam) X(load_dashpot) X(check_portion) \
    X(sum_portion_of_beams) X(clear_row) X(follow_loads_of_row) X(follow_all_couples) X(follow_drive) \
    X(follow_body_group) X(load_marked_beam) X(load_marked_uniform_beam) X(rank_failing) X(count_failures) \
    X(remove_failing_beam) X(take_beams_off_element) X(load_failing_dashpot) X(take_dashpots_off_element) \
    X(keep_gathered_sum) X(keep_sum) X(keep_dashed_sum) X(resume_free) X(resume_resisted) X(resume_row) \
    X(resume_resisted_row) X(reopen_work_of_body) X(release_element) X(end_all_failures) X(write_released_energy) \
    X(dilate_facet) X(gather_dilatation) X(set_stress) X(sum_stress_difference) X(add_stress_difference) \
    X(bend_layer) X(twist_layer) X(add_layer_torque) X(sum_portion_of_gradients) X(find_acceleration_of) \
    X(find_dilatation_inertia_of) X(find_inertia_force_of) X(add_inertia_force_of) \
    X(subtract_portion_of_dilatation) X(load_facet) X(place_wall) X(begin_walls_of_row) X(dilate_walls_of_row) \
    X(apply_walls_of_row) X(add_wall_load) X(follow_traction) X(give_dilatation) X(add_traction_work_of_row) \
    X(check_portion_of_facets) X(sum_portion_of_facets) X(sum_portion_of_cells) X(add_energy_of_support) \
    X(check_travel_of_element) X(check_travel_of_wall) X(move_all_walls) X(press_pair) X(press_pair_or_faces) \
    X(add_faces_of_element) X(add_pairs_of_element) X(press_walls_on_element) X(add_contact_load) X(load_wall) \
    X(kick_free_wall) X(measure_overlaps) X(sum_portion_of_pairs) X(sum_portion_of_faces) X(sum_portion_at_walls) \
    X(count_work_of_walls) X(write_all_walls) X(load_stored_facet) X(gather_facet_moments) X(sum_moments_of_cell) \
    X(find_cell_stress) X(find_still_stress) X(add_surface_stress) X(add_still_surface_stress) X(judge_cell) \
    X(mark_facet) X(mark_plane) X(begin_marked_crack) X(sum_stressed_portion) X(sum_portion_of_cracks) \
    X(sum_portion_of_crushing) X(write_all_crushing_of_facets) X(begin_all_levers) X(restore_crack) X(weigh_cell) \
    X(carry_cell) X(follow_lever) X(link_halves) X(begin_base) X(measure_crack) X(relax_cell) \
    X(relax_outdated_cell) X(watch_resting_crack) X(wake_crack) X(take_woken) X(soften_crack) X(part_crack) \
    X(leave_crack) X(take_leaving) X(load_crack) X(sum_cracks_of_cell) X(slide_crack_of) X(add_crack_load) \
    X(log_all_cracks) X(dilate_marked_facet) X(postpone_neighbour) X(withdraw_facets_of_cell) \
    X(write_facet_failure) X(end_facets_of_cell) X(restore_facets_of_cell) X(renew_wall_row) X(gather_loads) \
    X(gather_dashpots) X(move_gathered) X(move_gathered_resisted) X(move_summed) X(move_summed_resisted) \
    X(move_gathered_row) X(move_gathered_resisted_row) X(move_summed_row) X(move_summed_resisted_row) \
    X(open_element) X(open_element_or_row) X(open_work_of_body) X(add_body_force) X(add_work_of_body) \
    X(begin_contact_of_event) X(add_new_contacts_of_element) X(take_over_energies) X(touch_parted_face) \
    X(open_face) X(begin_faces_of_pair) X(settle_face) X(settle_faces_of_cell) X(take_over_from_cracks) \
    X(find_force_of_pair) X(turn_stress_of_element) X(gather_moments) X(add_pair_moments_of_element) \
    X(add_wall_moments_of_element) X(find_stress_of_element) X(judge_pair) X(write_pair_failure) \
    X(take_pairs_off_element) X(relieve_element) X(end_failing_pair) X(add_all_new_contacts) \
    X(sum_portion_of_springs) X(set_clock) X(count_record) X(sum_portion_of_elements) X(judge_all_energy) \
    X(write_whole_ledger) X(read_part_of_gauge) X(write_gauge) X(roll_one_pair) X(add_rolling_of_element) \
    X(roll_element_at_walls) X(sum_portion_of_rolling) X(sum_portion_of_rolling_at_walls) X(soften_listed) \
    X(end_portion_of_softening) X(log_all_softened) X(load_softening_beam) X(load_softening_uniform_beam) \
    X(begin_all_softening) X(release_all_pressure) X(begin_all_softened_contacts) X(sum_portion_of_pressure) \
    X(write_all_crushing_of_beams) X(load_stored_beam) X(sum_portion_of_stored) X(follow_strain_factors) \
    X(stretch_strained_beam) X(add_work_of_strains) X(follow_cell_factors) X(stretch_facet_of_step) \
    X(stretch_wall_of_step) X(sum_strain_portion) X(begin_strain_portion) X(begin_cell_strains) \
    X(add_work_of_cell_strains) X(judge_cell_by_mean_stress) X(judge_cell_by_cone) X(judge_cell_by_size) \
    X(clear_candidates) X(find_stress_candidate) X(index_candidate_by_mean_stress) X(index_candidate_by_cone) \
    X(mark_failing_facet) X(find_strength_along) X(yield_cell) X(add_yielding_work_of_row) X(sum_portion_of_heat) \
    X(stretch_yielded_cell) X(stretch_growing_cell) X(stretch_wall_of_cell) X(stretch_crack_of_cells) \
    X(keep_base_levers) X(stretch_cell_anew) X(stretch_wall_anew) X(add_crack_power) X(begin_crack_power) \
    X(judge_beam_by_elliptic) X(judge_beam_by_linear_sum) X(judge_beam_by_mohr_coulomb) \
    X(judge_beam_by_peripheral_stress) X(judge_facet_by_mohr_coulomb) X(begin_beam_by_mohr_coulomb) \
    X(begin_beam_by_peripheral_stress)
