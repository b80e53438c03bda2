// A beam with a stress-free strain ε* that changes in time: change of its length at rest, and work of the strain.
#pragma once
#include "../beams/bonds.hpp"
#include "strain_factors.hpp"

namespace bondem {

// Stretch 1 + ε* of strained beam e at the present factors.
inline double stretch_of(const Strain &strain, Index e) {
    using namespace strain_factor;
    double stretch = strain.still(e);
    for (Index g = 0; g < strain.schedule.size(); g++) stretch += strain.factor(now, g) * strain.part(g, e);
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

// Stretches strained beam e if lengths change, and calls add(g, ∂U/∂factor) for each strain g [J].
template <class Add>
inline void stretch_and_add(const Moving &all, const Strain &strain, const Beams &beams, Index e, Add add) {
    if (strain.due(strain_due::levers)) stretch_beam(strain, beams, e);
    const double tension = tension_of(all, strain, beams, e);
    for (Index g = 0; g < strain.schedule.size(); g++) add(g, -tension * strain.length(e) * strain.part(g, e));
}
// Adds the work of the strains, except before the first step of a call.
inline void add_work_of(const Clock &clock, const Strain &strain, const Rows &rows) {
    double none = 0.0;
    take_work(strain, clock.first ? none : rows.work(strain.place));
}

}  // namespace bondem
