// Declarations of passes over contacts and walls that other source files or a GPU call.
#pragma once
#include "../../steps.hpp"
#include "../../tables/contact_tables.hpp"

namespace bondem {

// True if distances are measured in this step: the step has no duration, or an element has moved too far since the
// last measurement, or a place is not finite.
inline bool measures_anew(const Range &range, const NearPairs &near, const Travel &travel) {
    return range.clock.dt == 0.0 || !(travel.far(0) <= near.width);
}
// Adds forces and losses of contacts to those of the elements, and sets those of contacts to zero.
void add_contact_loads(const Range &range, const Moving &all, const StepBlocks &blocks, const ContactSums &contacts);
// Sums the elastic energy of the pairs of a portion [J].
void sum_pair_energies(const Range &range, const Moving &all, const ContactConstants &law, const ContactPairs &pairs,
                       const Ledger &ledger);
// Moves walls to the end of the step that begins at the time of the clock.
void move_walls(const Range &range, const WallMotions &motions, const Walls &walls);
// Adds the changes over dt to velocity and angular momentum of free wall e.
void kick_free(const WallMotions &motions, const Walls &walls, Index e, double dt);
// Sets the angular velocity of wall w from its angular momentum, if it turns freely.
void show_free_spin(const Walls &walls, Index w);
// Adds the force of contact e to the sums of its wall.
void add_to_wall(const WallContacts &contacts, Index e);
// Takes the forces of wall w from their sums, which are then zero, and adds its work; `half` is half the step [s].
void load_wall_by_sums(const WallContacts &contacts, const Walls &walls, Index w, double half);
// Adds the absolute works of walls to the energy balance, for its guard.
void count_wall_work(const Range &range, const Walls &walls, const Ledger &ledger);
// Adds the works of walls to the energy balance, and writes gauges of walls.
void write_walls(const Range &range, const Walls &walls, const Gauges &gauges, const Ledger &ledger,
                 const HistoryRows &history);
// Adds forces of walls to the elements of a portion, and stores the memory of these contacts.
void press_walls(const Range &range, const Moving &all, const ContactConstants &c,
                 const WallContacts &contacts, const Walls &walls, const ContactSums &to);
// Adds the elastic energy of contacts of a portion with walls [J].
void sum_wall_energies(const Range &range, const Moving &all, const ContactConstants &c,
                       const WallContacts &contacts, const Walls &walls, const Ledger &ledger);

}  // namespace bondem
