// Beams of the incremental formulation on a GPU. The thread of a beam integrates the loads stored for the beam over
// the step, and writes forces and torques on both of its ends.
#pragma once
#include "../passes/incremental/stored_columns.hpp"
#include "beams.hpp"

namespace bondem {

inline void load_stored_beam(Index k, const DeviceSpan &span, const Moving &all, const Beams &beams,
                             const StoredLoads &stored, const LoadsOfBonds &to) {
    const Vector apart = ends_of(all.pose.data, beams, k).branch;
    const Motion<double> a(gather(all.motion.data, beams.i(k))), b(gather(all.motion.data, beams.j(k)));
    const StoredColumns<double> history(stored);
    const StoredShape<double> shape = stored_shape<double>(beams, k);
    const StoredLoad<double> now = integrated(history(k), apart, {b.v - a.v, a.w, b.w}, shape,
                                              stored_stiffness<double>(beams, stored, k), clock_of(span).dt);
    history.keep(k, now);
    const double s = beams.integrity(k);
    const BeamLoads<double> loads = stored_loads(now, apart, shape);
    put(to, k, {s * loads.force, s * loads.on_i, s * loads.on_j});
}
constexpr auto sum_portion_of_stored = portion_of_bonds<sum_stored_energies>;

}  // namespace bondem
