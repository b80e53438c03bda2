// Changes by the removal of a beam that fails: loads on its ends, released energy, and loads of its dashpot.
#pragma once
#include "../../laws/damping.hpp"
#include "../beams/bonds.hpp"
#include "integrity.hpp"
#include "pipeline.hpp"

namespace bondem {

struct FailedBeam {
    BeamLoads<double> loads;
    Removal removal;
};
inline FailedBeam failed_beam(const double *pose, const Beams &beams, const BeamIntegrity &state, Index k) {
    const Ends<double> ends = ends_of(pose, beams, k);
    const BeamShape<double> shape = shape_of<double>(beams, k);
    const double s = state.integrity(k);
    const BeamLoads<double> loads = beam_loads(ends, shape, stiffness_of(beams, k, s));
    const BeamEnergy<double> energy = beam_energy(ends, shape, stiffness_of(beams, k, 1.0), beams.ks(k), beams.lever(k));
    return {loads,
            {s * (energy.normal + energy.shear + energy.bending + energy.twisting), length(ends.branch) - shape.length,
             plus(centre(pose, beams.i(k)), beams.lever(k) / shape.length, ends.branch)}};
}
inline BeamLoads<double> loads_of_dashpot(const Moving &all, const Beams &beams, const Dashpots &dashpots, Index k) {
    const Index m = dashpots.c.shape[1];
    const double *const c = dashpots.c.data, s = beams.integrity(k);
    const Motion<double> a(gather(all.motion.data, beams.i(k))), b(gather(all.motion.data, beams.j(k)));
    const BeamDashpots<double> dashpot = {s * c[k], s * c[m + k], s * c[2 * m + k], s * c[3 * m + k]};
    return dashpot_loads(ends_of(all.pose.data, beams, k).branch, {b.v - a.v, a.w, b.w}, dashpots.share(k), dashpot);
}
// Subtracts the loads of a beam from the kept sum of its end i, or of its end j.
inline void take_off_end(double *row, bool is_i, const BeamLoads<double> &loads) {
    take_off(row, is_i ? -1.0 : 1.0, loads.force, 1.0, is_i ? loads.on_i : loads.on_j);
}

}  // namespace bondem
