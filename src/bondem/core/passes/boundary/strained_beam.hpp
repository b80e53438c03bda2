// One beam with a stress-free strain that changes: its rest length L (1 + ε*), and the work of its tension.
#pragma once
#include "../../exact_sum.hpp"
#include "../beams/bonds.hpp"
#include "timeline.hpp"

namespace bondem {

// Stretch 1 + ε* of strained beam e at the present factors.
inline double stretch_of(const Strain &strain, Index e) {
    double stretch = strain.still(e);
    for (Index g = 0; g < strain.schedule.size(); g++) stretch += strain.factor(1, g) * strain.part(g, e);
    return stretch;
}
// Sets length, shear stiffness and lever of strained beam e at the present factors.
inline void stretch_beam(const Strain &strain, const Beams &beams, Index e) {
    const Index k = strain.bond(e);
    const double stretch = stretch_of(strain, e);
    beams.length(k) = strain.length(e) * stretch;
    beams.ks(k) = strain.shear(e) / (stretch * stretch);
    beams.lever(k) = strain.lever(e) * stretch;
}
// Tension of strained beam e [N].
inline double tension_of(const Moving &all, const Strain &strain, const Beams &beams, Index e) {
    const Index k = strain.bond(e);
    const double present = length(ends_of(all.pose.data, beams, k).branch);
    return beams.integrity(k) * beams.kn(k) * (present - beams.length(k));
}

// Updates the factors to the time of a clock. Sets whether lengths change, and whether ∂U/∂factor is needed: in a
// step with a change and in the one before it. The first step of a call does both.
inline void follow_factors(const Clock &clock, const Timeline &timeline, const Strain &strain) {
    const auto &factor = strain.factor;
    bool changed = clock.first, needed = clock.first;
    for (Index g = 0; g < strain.schedule.size(); g++) {
        factor(1, g) = value_at(timeline, strain.schedule(g), clock.time);
        changed |= factor(1, g) != factor(0, g);
        needed |= factor(1, g) != value_at(timeline, strain.schedule(g), clock.time + clock.dt);
    }
    strain.due(strain_due::levers) = changed;
    strain.due(strain_due::power) = changed || needed;
}
// Stretches strained beam e if lengths change, and calls add(g, ∂U/∂factor) for each strain g [J].
template <class Add>
inline void stretch_and_add(const Moving &all, const Strain &strain, const Beams &beams, Index e, Add add) {
    if (strain.due(strain_due::levers)) stretch_beam(strain, beams, e);
    const double tension = tension_of(all, strain, beams, e);
    for (Index g = 0; g < strain.schedule.size(); g++) add(g, -tension * strain.length(e) * strain.part(g, e));
}
// Reads and clears the sums of ∂U/∂factor, and adds the work of the strains.
inline void add_work_of(const Clock &clock, const Strain &strain, const Rows &rows) {
    const auto &factor = strain.factor;
    for (Index g = 0; g < strain.schedule.size(); g++) {
        factor(3, g) = exact_sum(strain.power, g).take();
        if (!clock.first) rows.work(strain.place) += 0.5 * (factor(2, g) + factor(3, g)) * (factor(1, g) - factor(0, g));
        factor(0, g) = factor(1, g);
        factor(2, g) = factor(3, g);
    }
}

}  // namespace bondem
