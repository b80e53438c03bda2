// How the tables of contacts and walls describe themselves to Python.
#pragma once
#include "described.hpp"
#include "passes/contacts/adhesion.hpp"
#include "passes/contacts/candidates.hpp"
#include "passes/contacts/contact_loads.hpp"
#include "passes/contacts/face_contacts.hpp"
#include "passes/contacts/handover.hpp"
#include "passes/contacts/travel.hpp"
#include "passes/contacts/rigid_walls.hpp"
#include "passes/contacts/rolling.hpp"

namespace bondem {

#define F BONDEM_FIELD

BONDEM_TABLE(ContactRow, F(modulus, ""), F(soft, ""), F(friction, ""), F(damping, ""), F(rolling, ""), F(twisting, ""), F(deep, ""),
             F(strength, ""), F(reach, ""))
BONDEM_TABLE(ContactConstants, F(between, "kinds kinds 9"), F(at_walls, "kinds walls 9"), F(kind, "n"), F(hertzian, ""), F(radius, "n"))
BONDEM_TABLE(ContactPairs, F(first, "pairs"), F(second, "pairs"), F(start, "n+1"), F(reach, "pairs"), F(own, "pairs"),
             F(memory, "pairs 8"), F(touch, "pairs"), F(bond, "pairs"), F(joined, "*"), F(of_bond, "*"), F(period, "6"))
BONDEM_TABLE(NearPairs, F(near, "pairs+1"), F(close, "pairs+1"), F(output, "pairs 8"), F(counts, "element_portions 2"),
             F(width, ""), F(beyond, ""))
BONDEM_TABLE(AdheringPairs, F(force, "pairs 3"))
BONDEM_TABLE(RolledPairs, F(rolled, "pairs 3"), F(output, "pairs 4"))
BONDEM_TABLE(RolledWalls, F(rolled, "wall_contacts 3"))
BONDEM_TABLE(FacePairs, F(in_start, "n+1"), F(out_start, "n+1"), F(out_bond, "*"), F(lever_i, "3 m"), F(lever_j, "3 m"),
             F(pitch, "3"), F(normal, "3 m"), F(j, "m"), F(k, "m"), F(area, "m"), F(listed, "m"), F(plane, "m"), F(open, "m"), F(faced, "n"),
             F(outer, "n"), F(earlier_start, "n+1"), F(earlier, "pairs"), F(chosen, "pairs"), F(whole, "pairs"), F(close, "pairs"),
             F(output, "pairs 12"), F(gained, "pairs"), F(count, "element_portions"))
BONDEM_TABLE(Travel, F(listed, "n 3"), F(measured, "n 3"), F(portion, "element_portions 3"), F(far, "2"), F(reach, ""))
BONDEM_TABLE(ContactSums, F(sums, "n 8"))
BONDEM_TABLE(ContactEnergies, F(energy, "element_portions"))
BONDEM_TABLE(WallContacts, F(start, "n+1"), F(element, "wall_contacts"), F(wall, "wall_contacts"), F(gap, "wall_contacts"),
             F(memory, "wall_contacts 6"), F(touch, "wall_contacts"), F(output, "wall_contacts 7"))
BONDEM_TABLE(WallRow, F(displacement, "3"), F(growth, ""), F(velocity, "3"), F(growth_rate, ""), F(force, "3"),
             F(growth_force, ""), F(work, ""), F(normal_force, ""), F(orientation, "4"), F(spin, "3"), F(torque, "3"),
             F(momentum, "3"))
BONDEM_TABLE(WallShape, F(point, "3"), F(axis, "3"), F(radius, ""), F(kind, ""), F(hole, ""), F(about, "3"))
BONDEM_TABLE(WallInertia, F(inverse_mass, ""), F(inverse_moment, "3"), F(principal, "4"))
BONDEM_TABLE(WallListed, F(point, "3"), F(axis, "3"), F(growth, ""), F(farthest, ""))
BONDEM_TABLE(WallLoad, F(force, "3"), F(normal, ""), F(torque, "3"))
BONDEM_TABLE(Walls, F(shape, "walls 12"), F(body, "walls 27"), F(inertia, "walls 8"),
             F(listed, "walls 8"))
BONDEM_TABLE(WallMotions, F(times, "wall_times"), F(values, "wall_times"), F(start, "wall_schedules+1"),
             F(drive_wall, "wall_drives"), F(drive_component, "wall_drives"), F(drive_schedule, "wall_drives"),
             F(drive_rate, "wall_drives"), F(drive_axis, "wall_drives 3"), F(servo_wall, "servos"), F(servo_schedule, "servos"), F(servo_speed, "servos"),
             F(servo_mass, "servos"), F(servo_damping, "servos"), F(free_wall, "free_walls"), F(free_mass, "free_walls"),
             F(free_force, "free_walls 3"), F(free_torque, "free_walls 3"))
BONDEM_TABLE(PairSources, F(bond_start, "n+1"), F(bond_first, "m"),
             F(wanted, "m"), F(rest_start, "n+1"), F(rest_first, "rest"), F(rest_gap, "rest"), F(kept_start, "n+1"),
             F(kept_first, "kept"), F(kept_memory, "kept 8"))
BONDEM_TABLE(FoundPairs, F(first, "room"), F(second, "room"), F(bond, "room"), F(start, "n+1"), F(gap, "room"),
             F(memory, "room 8"), F(touch, "room"))
BONDEM_TABLE(WallSources, F(radius, "n"), F(rest_start, "n+1"), F(rest_wall, "rest"), F(rest_gap, "rest"),
             F(kept_start, "n+1"), F(kept_wall, "kept"), F(kept_memory, "kept 6"), F(skin, ""), F(start, "n+1"))
BONDEM_TABLE(FoundWalls, F(element, "room"), F(wall, "room"), F(gap, "room"), F(now, "room"), F(memory, "room 6"),
             F(touch, "room"))

#undef F

// Lines of the lists in `index.cpp`.
#define BONDEM_CONTACT_TABLES                                                                                            \
    described<ContactRow>(), described<ContactConstants>(), described<ContactPairs>(), described<NearPairs>(), described<AdheringPairs>(), described<RolledPairs>(), described<RolledWalls>(), described<FacePairs>(), described<Travel>(),               \
        described<ContactSums>(), described<ContactEnergies>(), described<WallContacts>(), described<WallRow>(), described<WallShape>(), \
        described<WallInertia>(), described<WallListed>(), described<WallLoad>(), described<Walls>(),           \
        described<WallMotions>(), described<PairSources>(), described<FoundPairs>(), described<WallSources>(),           \
        described<FoundWalls>()
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
