#pragma once
#include "../../steps.hpp"
#include "../../tables/contact_tables.hpp"
#include "../../tables/damage_tables.hpp"
#include "../../tables/non_local_tables.hpp"

namespace bondem {

// Adds what walls do to the stresses of the elements of a portion.
void add_wall_moments(const Turn &turn, const Moving &all, const ContactConstants &c, const WallContacts &contacts,
                      const Walls &walls, const LaggedStresses &stresses);
// Adds to the stresses of the ends of bonds that have failed in this step what the contact does that follows them;
// after that contact has begun. No other element is looked at, as it may have moved on.
void add_begun_contacts(const Turn &turn, const Moving &all, const ContactConstants &c, const ContactPairs &pairs,
                        const LaggedStresses &stresses, const EventLog &log);

}  // namespace bondem
