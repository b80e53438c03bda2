// Contact of cells whose cracked facet has parted: it begins without a force.
#include "../../registered.hpp"
#include "../../tables/contact_tables.hpp"
#include "../../tables/crack_tables.hpp"
#include "../contacts/handover.hpp"
#include "crack_rows.hpp"

namespace bondem {

// Makes pairs of the cells whose faces have parted in this step.
void touch_parted_faces(const Turn &, const Moving &all, const ContactPairs &pairs, const NearPairs &near,
                        const CohesiveCracks &cracks, const CrackLists &lists, const PartedReach &reach) {
    for (Index e = 0; e < lists.size(3); e++) {
        const Index k = lists.parted(e);
        shape_of(cracks, k).top = reach.apart(k) = let_touch(all, pairs, near, k, reach.apart(k));
    }
}
BONDEM_PASS(touch_parted_faces, serial)

}  // namespace bondem
