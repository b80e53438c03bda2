// Strains of beams that change, on a device: one thread follows their factors, one each computes a portion of the beams, and
// one adds up their work (`passes/boundary/strains.cpp`).
#pragma once
#include "../passes/boundary/strained_beam.hpp"
#include "../passes/boundary/timeline.hpp"
#include "turns.hpp"

namespace bondem {

inline void follow_strain_factors(Index, const DeviceSpan &span, const Timeline &timeline, const Strain &strain,
                                  const StrainPortions &portions) {
    const Clock &clock = clock_of(span);
    const auto &factor = strain.factor;
    bool changed = clock.first, needed = clock.first;
    for (Index g = 0; g < strain.schedule.size(); g++) {
        factor(1, g) = value_at(timeline, strain.schedule(g), clock.time);
        changed |= factor(1, g) != factor(0, g);
        needed |= factor(1, g) != value_at(timeline, strain.schedule(g), clock.time + clock.dt);
    }
    portions.due(0) = changed;
    portions.due(1) = changed || needed;
}
inline void strain_portion(Index b, const Moving &all, const Strain &strain, const Beams &beams,
                           const StrainPortions &portions) {
    if (!portions.due(1)) return;
    const Index count = strain.schedule.size(), last = least((b + 1) * works_of_portion, strain.bond.size());
    for (Index g = 0; g < count; g++) portions.power(b, g) = 0.0;
    for (Index e = b * works_of_portion; e < last; e++) {
        if (portions.due(0)) stretch_beam(strain, beams, e);
        const double tension = tension_of(all, strain, beams, e);
        for (Index g = 0; g < count; g++) portions.power(b, g) -= tension * strain.length(e) * strain.part(g, e);
    }
}
inline void add_work_of_strains(Index, const DeviceSpan &span, const Strain &strain, const StrainPortions &portions,
                                const Rows &rows) {
    if (!portions.due(1)) return;
    const auto &factor = strain.factor;
    for (Index g = 0; g < strain.schedule.size(); g++) {
        double power = 0.0;
        for (Index b = 0; b < portions.power.size(); b++) power += portions.power(b, g);
        factor(3, g) = power;
        if (!clock_of(span).first)
            rows.work(strain.place) += 0.5 * (factor(2, g) + power) * (factor(1, g) - factor(0, g));
        factor(0, g) = factor(1, g);
        factor(2, g) = power;
    }
}

}  // namespace bondem
