#pragma once
#include "../../steps.hpp"
#include "../../tables/contact_tables.hpp"

namespace bondem {

// Moves walls to the end of the step that begins at the time of the clock.
void move_walls(const Turn &turn, const WallMotions &motions, const Walls &walls);
// Applies half a kick to free wall e, and returns its angular velocity afterwards.
void kick_free(const WallMotions &motions, const Walls &walls, Index e, double dt);
void show_free_spin(const Walls &walls, Index w);
// Work of a wall over half a step, by its loads before or after their sum.
void begin_loads(WallRow &row, double half);
void end_loads(const Walls &walls, Index w, double half);
// Adds forces of walls to the elements of a portion, and keeps their memory.
void press_walls(const Turn &turn, const Moving &all, const ContactConstants &c,
                 const WallContacts &contacts, const Walls &walls, const ContactSums &to);
// Adds the elastic energy of contacts of a portion with walls [J].
void sum_wall_energies(const Turn &turn, const Moving &all, const ContactConstants &c,
                       const WallContacts &contacts, const Walls &walls, const ContactEnergies &energies);

}  // namespace bondem
