// Bonds of the non-local law: extra forces by the stresses of a step before, then what they add to the stresses of
// now.
//
// A step finds the forces of all bonds, and then the stresses of all elements, before the blocks add the forces up as
// those of other bonds. A step of 0 finds the forces of a state again: extra forces stay what they are, and gaps and
// stresses do not change.
#include "non_local_bonds.hpp"

#include "../record/columns.hpp"
#include "bond_columns.hpp"

namespace bondem {
namespace {

#if defined(BONDEM_LANES)

// Bonds ahead of the loop whose first elements are asked for.
constexpr Index ahead = 32;

BONDEM_INLINE Row<Lanes> moment_row(const Stress<Lanes> &s) {
    const Lanes zero = {};
    return {{s.xx, s.yy, s.zz, s.xy, s.xz, s.yz, zero, zero}};
}

template <bool steps>
BONDEM_INLINE void find_forces(const Turn &turn, const double *pose, const Beams &beams, const NonLocalBonds &bonds,
                               const LaggedStresses &stresses) {
    const Short *const i = beams.i.data, *const j = beams.j.data;
    const double *const space = stresses.space.data;
    const PairLaw law = pair_law(bonds);
    for_each_group(turn.first, turn.last, [&](Group group) __attribute__((always_inline)) {
        const Index k = group.first;
        prefetch(pose, i + least(k + ahead, turn.last - lanes));
        const Ends<Lanes> ends = ends_of(gather(pose, i + k), gather(pose, j + k), beams.period.data);
        const Lanes s = load(beams.integrity.data + k);
        const PairPose<Lanes> now = pair_pose(ends.branch, ends.i, ends.j, pair_shape<Lanes>(bonds, k));
        const PairStiffness<Lanes> stiffness = pair_stiffness<Lanes>(bonds, k);
        const PairStore<Lanes> before = stored_by<Lanes>(bonds, k);
        const auto mean = [&]() __attribute__((always_inline)) {
            return mean_of(stress_of(gather(space, i + k)), stress_of(gather(space, j + k)));
        };
        const PairStore<Lanes> after = store_after<steps>(before, now, ends.i, s, stiffness, law, mean);
        keep_store(bonds, group, s, after, before);
        const NonLocalLoads<Lanes> loads = non_local_loads(now, turned_by(ends.i, after.extra), stiffness);
        const Vector3<Lanes> force = s * loads.force;
        add_rows(stresses.moment.data, stresses.to_i.data + k, j + k,
                 moment_row(symmetric_product(now.lever_i, force)), moment_row(symmetric_product(-now.lever_j, force)),
                 group.known);
        keep_output(bonds, group, s, loads);
    });
}

#endif

}  // namespace

#if defined(BONDEM_LANES)

void find_non_local_forces(const Turn &turn, const Moving &all, const Beams &beams, const NonLocalBonds &bonds,
                           const LaggedStresses &stresses) {
    if (turn.clock.dt > 0.0)
        find_forces<true>(turn, all.pose.data, beams, bonds, stresses);
    else
        find_forces<false>(turn, all.pose.data, beams, bonds, stresses);
}

void add_non_local_loads(const Turn &turn, const NonLocalBonds &bonds, const StepCut &cut) {
    const double *const data = bonds.output.data;
    const Index m = bonds.output.shape[1];
    for_each_group(turn.first, turn.last, [&](Group group) __attribute__((always_inline)) {
        const Index k = group.first;
        const Lanes zero = {};
        const Vector3<Lanes> f = vector_at<Lanes>(data, m, force_column, k);
        const Vector3<Lanes> t = vector_at<Lanes>(data, m, on_i_column, k);
        const Vector3<Lanes> u = vector_at<Lanes>(data, m, on_j_column, k);
        add_rows(cut.sums.data, cut.row_i.data + k, cut.row_j.data + k, {{f.x, f.y, f.z, zero, t.x, t.y, t.z, zero}},
                 {{-f.x, -f.y, -f.z, zero, -u.x, -u.y, -u.z, zero}}, group.known);
    });
}

#endif

void write_non_local_work(const Turn &turn, const NonLocalWork &work, const HistoryRows &history) {
    history.record(turn.clock.record, column::non_local) = sum_of(work);
}

void sum_non_local_energies(const Turn &turn, const Moving &all, const Beams &beams, const NonLocalBonds &bonds,
                            const Portions &portions, const NonLocalWork &work) {
    double normal = 0.0, shear = 0.0, taken = 0.0;
    for (Index k = turn.first; k < turn.last; k++) {
        const double s = beams.integrity(k);
        if (s > 0.0) {
            const SpringEnergy<double> energy =
                spring_energy(pair_pose(all.pose.data, beams, bonds, k), pair_stiffness<double>(bonds, k));
            normal += s * energy.normal;
            shear += s * energy.shear;
        }
        taken += bonds.history(taken_column, k);
    }
    double *const sum = &portions.bonds(turn.block, 0);
    sum[0] = normal, sum[1] = shear, sum[2] = sum[3] = 0.0;
    work.taken(turn.block) = taken;
}

Index find_small_extra_forces(Index, const SmallPairs &pairs, const ExtraForces &extra) {
    const PairLaw law = {pairs.nu, pairs.limited != 0};
    for (Index k = 0; k < pairs.area.size(); k++) {
        const auto stress = [&](Index end) { return pairs.stress.row<const Stress<double>>(pairs.pairs(k, end)); };
        const Vector n = pairs.normal.row<const Vector>(k);
        const Vector slip = pairs.kt(k) * across(pairs.gap.row<const Vector>(k), n);
        extra.force.row<Vector>(k) = extra_force(mean_of(stress(0), stress(1)), n, pairs.area(k), slip, law);
    }
    return 0;
}

#if defined(BONDEM_LANES)

Index load_non_local_bonds(Index, const Poses &all, const Beams &beams, const NonLocalBonds &bonds) {
    for_each_group(0, beams.i.size(), [&](Group group) {
        const Index k = group.first;
        const Row<Lanes> i = gather(all.pose.data, beams.i.data + k), j = gather(all.pose.data, beams.j.data + k);
        const Ends<Lanes> ends = ends_of(i, j, beams.period.data);
        const PairPose<Lanes> now = pair_pose(ends.branch, ends.i, ends.j, pair_shape<Lanes>(bonds, k));
        const Vector3<Lanes> extra = turned_by(ends.i, stored_by<Lanes>(bonds, k).extra);
        const NonLocalLoads<Lanes> loads = non_local_loads(now, extra, pair_stiffness<Lanes>(bonds, k));
        keep_output(bonds, group, load(beams.integrity.data + k), loads);
    });
    return 0;
}

#endif

}  // namespace bondem
