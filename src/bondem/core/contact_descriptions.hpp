// How the tables of contacts and walls describe themselves to Python.
#pragma once
#include "described_tables.hpp"
#include "passes/contacts/adhesion.hpp"
#include "passes/contacts/candidates.hpp"
#include "passes/contacts/contact_loads.hpp"
#include "passes/contacts/face_contacts.hpp"
#include "passes/contacts/handover.hpp"
#include "passes/contacts/travel.hpp"
#include "passes/contacts/rigid_walls.hpp"
#include "passes/contacts/rolling.hpp"

namespace bondem {

// Lines of the lists in `index.cpp`.
#define BONDEM_CONTACT_SEARCH P(list_pairs, "all_listed room_full"), P(count_wall_contacts, ""), P(list_wall_contacts, "")
#define BONDEM_CONTACT_PASSES                                                                                            \
    S(serial, move_walls), S(of_elements, measure_travel), S(serial, check_travel), S(of_elements, press_pairs),         \
        S(of_ranges, add_pair_loads), S(of_elements, press_walls), S(of_elements, measure_wall_overlaps),                \
        S(serial, load_walls), S(serial, keep_measures), S(elements_of_blocks, add_contact_loads),                       \
        S(of_elements, sum_pair_energies), S(of_elements, sum_wall_energies), S(serial, write_contact_energy),           \
        S(serial, count_wall_work), S(serial, write_walls), S(serial, begin_contacts), S(serial, release_pressure),             \
        S(serial, begin_softened_contacts), S(of_elements, press_pairs_and_faces), S(of_ranges, add_face_loads),          \
        S(of_elements, sum_face_energies), S(serial, begin_face_contacts), S(of_elements, roll_pairs),                   \
        S(of_ranges, add_rolling_loads), S(of_elements, roll_at_walls), S(of_elements, sum_rolling_energies),             \
        S(of_elements, sum_rolling_at_walls), S(of_elements, adhere_pairs), S(of_ranges, add_adhesion_loads),             \
        S(of_elements, adhere_at_walls), S(of_elements, sum_adhesion_energies), S(of_elements, sum_adhesion_at_walls)

}  // namespace bondem
