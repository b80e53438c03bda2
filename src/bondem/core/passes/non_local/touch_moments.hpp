#pragma once
#include "../../steps.hpp"
#include "../../tables/contact_tables.hpp"
#include "../../tables/non_local_tables.hpp"

namespace bondem {

// Adds what contacts of pairs do to the stresses of the elements of a range, in the order of the pairs.
void add_pair_moments(const Turn &turn, const Moving &all, const ContactConstants &c, const ContactPairs &pairs,
                      const NearPairs &near, const LaggedStresses &stresses);
// Adds what walls do to the stresses of the elements of a portion.
void add_wall_moments(const Turn &turn, const Moving &all, const ContactConstants &c, const WallContacts &contacts,
                      const Walls &walls, const LaggedStresses &stresses);

}  // namespace bondem
