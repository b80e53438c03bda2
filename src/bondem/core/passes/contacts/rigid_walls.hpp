#pragma once
#include "../../steps.hpp"
#include "../../tables/contact_tables.hpp"

namespace bondem {

// Takes walls to the end of the step that begins at the time of the clock.
void move_walls(const Turn &turn, const WallMotions &motions, const Walls &walls);
// Half a kick of free wall e, and its angular velocity after it.
void kick_free(const WallMotions &motions, const Walls &walls, Index e, double dt);
void show_free_spin(const Walls &walls, Index w);
// Half a step of the work of a wall by its loads before, and after they have been summed.
void begin_loads(WallRow &row, double half);
void end_loads(const Walls &walls, Index w, double half);
// Adds forces of walls to the elements of a portion, and keeps their memory.
void press_walls(const Turn &turn, const Moving &all, const ContactConstants &c,
                 const WallContacts &contacts, const Walls &walls, const ContactSums &to);
// Keeps the deepest overlap of the elements of a portion with a wall, over the radius, where distances are measured anew.
void measure_wall_overlaps(const Turn &turn, const Moving &all, const ContactConstants &c, const WallContacts &contacts,
                           const Walls &walls, const NearPairs &near, const Travel &travel);
// Sums the forces of elements on walls, adds their work, and closes the step of free walls.
void load_walls(const Turn &turn, const WallContacts &contacts, const WallMotions &motions, const Walls &walls);
// Adds the elastic energy of contacts of a portion with walls [J].
void sum_wall_energies(const Turn &turn, const Moving &all, const ContactConstants &c,
                       const WallContacts &contacts, const Walls &walls, const ContactEnergies &energies);
// Finds what walls have supplied, for the guard of the energy.
void count_wall_work(const Turn &turn, const Walls &walls, const Portions &portions);
// Adds the work of walls to a record, and writes gauges of walls.
void write_walls(const Turn &turn, const Walls &walls, const Gauges &gauges, const HistoryRows &history);

}  // namespace bondem
