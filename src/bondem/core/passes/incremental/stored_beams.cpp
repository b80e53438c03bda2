// Passes that integrate the stored loads of beams over a step (`laws/incremental.hpp`), and apply them.
#include "stored_columns.hpp"

#include "../../ledger.hpp"
#include "../../registered.hpp"

namespace bondem {

#if defined(BONDEM_LANES)

// Integrates the stored loads of the beams of a block over the step, and adds them to the sums of their elements.
void add_stored_loads(const Range &range, const Moving &all, const Beams &beams, const StoredLoads &stored,
                      const StepBlocks &blocks) {
    constexpr Index ahead = 32;  // distance in bonds at which first elements are prefetched
    const Short *const i = beams.i.data, *const j = beams.j.data;
    const double *const pose = all.pose.data, *const motion = all.motion.data, *const period = beams.period.data;
    const StoredColumns<Lanes> history(stored);
    for_each_group(range.first, range.last, [&](Group group) __attribute__((always_inline)) {
        const Index k = group.first;
        prefetch(pose, i + least(k + ahead, range.last - lanes));
        prefetch(motion, i + least(k + ahead, range.last - lanes));
        const Vector3<Lanes> apart = branch(gather(pose, i + k), gather(pose, j + k), period);
        const Motion<Lanes> a(gather(motion, i + k)), b(gather(motion, j + k));
        const StoredShape<Lanes> shape = stored_shape<Lanes>(beams, k);
        const StoredLoad<Lanes> now = integrated(history(k), apart, {b.v - a.v, a.w, b.w}, shape,
                                                 stored_stiffness<Lanes>(beams, stored, k), range.clock.dt);
        history.keep(group, now);
        const Lanes s = load(beams.integrity.data + k);
        const BeamLoads<Lanes> one = stored_loads(now, apart, shape), loads = {s * one.force, s * one.on_i, s * one.on_j};
        add_loads_of(blocks.sums.data, blocks.row_i.data + k, blocks.row_j.data + k, loads, group.known);
    });
}
BONDEM_PASS(add_stored_loads, bonds_of_blocks, "ends motion pose; adds sums")

#endif

void sum_stored_energies(const Range &range, const Moving &all, const Beams &beams, const StoredLoads &stored,
                         const Ledger &ledger) {
    const StoredColumns<double> history(stored);
    ModeSums sum = {};
    for (Index k = range.first; k < range.last; k++) {
        const Vector apart = ends_of(all.pose.data, beams, k).branch;
        const BeamEnergy<double> energy =
            stored_energy(history(k), apart / length(apart), stored_stiffness<double>(beams, stored, k));
        sum.add(beams.integrity(k), energy);
    }
    sum.add_to(ledger);
}
BONDEM_PASS(sum_stored_energies, of_bonds, "ends pose")

// Finds the loads of each beam on its elements in given poses.
Index load_stored_beams(Index, const Poses &all, const Beams &beams, const StoredLoads &stored,
                        const LoadsOfEach &loads) {
    const StoredColumns<double> history(stored);
    for (Index k = 0; k < beams.i.size(); k++) {
        const BeamLoads<double> one =
            stored_loads(history(k), ends_of(all.pose.data, beams, k).branch, stored_shape<double>(beams, k));
        const double s = beams.integrity(k);
        const BeamLoads<double> left = {s * one.force, s * one.on_i, s * one.on_j};
        keep_loads(loads.found.data, loads.found.shape[1], k, left);
    }
    return 0;
}
BONDEM_CALL(load_stored_beams, "")

}  // namespace bondem
