#pragma once
#include "../../steps.hpp"
#include "../../tables/contact_tables.hpp"
#include "../../tables/crack_tables.hpp"

namespace bondem {

// Lets the cells touch like others whose faces have parted in this step.
void touch_parted_faces(const Turn &turn, const Moving &all, const ContactPairs &pairs, const NearPairs &near,
                        const CohesiveCracks &cracks, const CrackLists &lists, const PartedReach &reach);

}  // namespace bondem
