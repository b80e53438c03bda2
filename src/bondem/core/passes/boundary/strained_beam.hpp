// One beam with a stress-free strain that changes: its rest length L (1 + ε*), and the tension that does work on the
// strain.
#pragma once
#include "../beams/bonds.hpp"

namespace bondem {

// Sets what depends on the rest length of strained beam e, at the present factors.
inline double stretch_of(const Strain &strain, Index e) {
    double stretch = strain.still(e);
    for (Index g = 0; g < strain.schedule.size(); g++) stretch += strain.factor(1, g) * strain.part(g, e);
    return stretch;
}
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

}  // namespace bondem
