// Stress-free strains ε* of beams that change in time: changes of lengths at rest, and work of the strains.
#include "../../registered.hpp"
#include "strained_beam.hpp"

namespace bondem {

// Adapts strained beams to their lengths L (1 + ε*), and adds the work of the strains.
void follow_strains(const Range &range, const Timeline &timeline, const Strain &strain, const Moving &all,
                    const Beams &beams, const Rows &rows) {
    follow_factors(range.clock, timeline, strain);
    if (!strain.due(strain_due::power)) return;
    for (Index e = 0; e < strain.bond.size(); e++)
        stretch_and_add(all, strain, beams, e, [&](Index g, double power) { exact_sum(strain.power, g).add(power); });
    add_work_of(range.clock, strain, rows);
}
BONDEM_PASS(follow_strains, of_rows, "")

}  // namespace bondem
