// Stress-free strains that change in time: rest lengths L (1 + ε*) at the time of the clock, and their work, the
// trapezoid of ∂U/∂ε* over dε*.
//
// Nothing is done in steps in which no strain changes. ∂U/∂ε* is also found one step before a change, because the
// trapezoid needs it.
#include "../../registered.hpp"
#include "rows.hpp"
#include "strained_beam.hpp"
#include "timeline.hpp"

namespace bondem {

// Sets rest lengths L (1 + ε*), and adds the work of the strains.
void follow_strains(const Turn &turn, const Timeline &timeline, const Strain &strain, const Moving &all,
                    const Beams &beams, const Rows &rows) {
    const Clock &clock = turn.clock;
    const Index count = strain.schedule.size();
    const auto &factor = strain.factor;
    bool changed = clock.first, needed = clock.first;
    for (Index g = 0; g < count; g++) {
        factor(1, g) = value_at(timeline, strain.schedule(g), clock.time);
        changed |= factor(1, g) != factor(0, g);
        needed |= factor(1, g) != value_at(timeline, strain.schedule(g), clock.time + clock.dt);
    }
    if (!(changed || needed)) return;
    for (Index g = 0; g < count; g++) factor(3, g) = 0.0;
    for (Index e = 0; e < strain.bond.size(); e++) {
        if (changed) stretch_beam(strain, beams, e);
        const double tension = tension_of(all, strain, beams, e);
        for (Index g = 0; g < count; g++) factor(3, g) -= tension * strain.length(e) * strain.part(g, e);
    }
    for (Index g = 0; g < count; g++) {
        if (!clock.first) rows.work(strain.place) += 0.5 * (factor(2, g) + factor(3, g)) * (factor(1, g) - factor(0, g));
        factor(0, g) = factor(1, g);
        factor(2, g) = factor(3, g);
    }
}
BONDEM_PASS(follow_strains, of_rows, "")

}  // namespace bondem
