// Passes of the non-local law that are called by several source files or run on a device (GPU).
#pragma once
#include "../../steps.hpp"
#include "../../tables/contact_tables.hpp"
#include "../../tables/damage_tables.hpp"
#include "../../tables/non_local_tables.hpp"

namespace bondem {

// Sums normal and shear energy of the springs of a portion of bonds, and the work of their extra forces [J].
void sum_non_local_energies(const Range &range, const Moving &all, const Beams &beams, const NonLocalBonds &bonds,
                            const Ledger &ledger);
// Adds contacts with walls to the stresses of the elements of a portion.
void add_wall_moments(const Range &range, const Moving &all, const ContactConstants &c, const WallContacts &contacts,
                      const Walls &walls, const LaggedStresses &stresses);
// Adds new contacts to the stresses of the ends of bonds that have failed in this step, after these contacts have
// begun. Other elements are not read, because they may have moved.
void add_new_contacts(const Range &range, const Moving &all, const ContactConstants &c, const ContactPairs &pairs,
                      const LaggedStresses &stresses, const EventLog &log);

}  // namespace bondem
