// Contributions of contacts to the stresses of elements of the non-local law, on the CPU and on a device.
#pragma once
#include "../../steps.hpp"
#include "../../tables/contact_tables.hpp"
#include "../../tables/damage_tables.hpp"
#include "../../tables/non_local_tables.hpp"

namespace bondem {

// Adds contacts with walls to the stresses of the elements of a portion.
void add_wall_moments(const Range &range, const Moving &all, const ContactConstants &c, const WallContacts &contacts,
                      const Walls &walls, const LaggedStresses &stresses);
// Adds new contacts to the stresses of the ends of bonds that have failed in this step, after these contacts have
// begun. Other elements are not read, because they may have moved.
void add_new_contacts(const Range &range, const Moving &all, const ContactConstants &c, const ContactPairs &pairs,
                      const LaggedStresses &stresses, const EventLog &log);

}  // namespace bondem
