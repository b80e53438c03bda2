// Factors of stress-free strains of beams or cells, which follow schedules, and the work of these strains.
//
// The work in a step is the mean of ∂U/∂factor before and after the step, times the change of the factor, with U the
// elastic energy. ∂U/∂factor is therefore computed in each step in which a factor changes and in the step before. The
// first step of each call from Python computes ∂U/∂factor too.
#pragma once
#include "../../exact_sum.hpp"
#include "../../steps.hpp"
#include "timeline.hpp"

namespace bondem {

// Rows of `factor` in tables of strains: factors a step ago and now [-], ∂U/∂factor a step ago and now [J].
namespace strain_factor {
enum : Index { before, now, power_before, power };
}

// Updates the factors to the time of a clock. Sets whether levers change, and whether ∂U/∂factor is needed: in a step
// with a change and in the step before it. The first step of a call does both.
template <class Strains>
inline void follow_factors(const Clock &clock, const Timeline &timeline, const Strains &strains) {
    using namespace strain_factor;
    const auto &factor = strains.factor;
    bool changed = clock.first, needed = clock.first;
    for (Index g = 0; g < strains.schedule.size(); g++) {
        factor(now, g) = value_at(timeline, strains.schedule(g), clock.time);
        changed |= factor(now, g) != factor(before, g);
        needed |= factor(now, g) != value_at(timeline, strains.schedule(g), clock.time + clock.dt);
    }
    strains.due(strain_due::levers) = changed;
    strains.due(strain_due::power) = changed || needed;
}
// Reads and clears the sums of ∂U/∂factor, and adds the work of the strains since they were read last [J].
template <class Strains> inline void take_work(const Strains &strains, double &work) {
    using namespace strain_factor;
    const auto &factor = strains.factor;
    for (Index g = 0; g < strains.schedule.size(); g++) {
        factor(power, g) = exact_sum(strains.power, g).take();
        work += 0.5 * (factor(power_before, g) + factor(power, g)) * (factor(now, g) - factor(before, g));
        factor(before, g) = factor(now, g);
        factor(power_before, g) = factor(power, g);
    }
}

}  // namespace bondem
