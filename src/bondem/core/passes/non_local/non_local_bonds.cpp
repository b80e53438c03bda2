// Bonds of the non-local law (`laws/non_local.hpp`): their forces, and their contributions to the present stresses.
//
// A step computes the forces of all bonds, then the stresses of all elements, and then adds the forces to the sums of
// the elements. Without failure and contacts no pass needs the stresses before the elements move. In this case forces
// are added as soon as they are computed, and not stored. A time step of 0 computes the forces of a state again,
// without a change of extra forces, gaps and stresses.
#include "non_local_passes.hpp"

#include "../../ledger.hpp"
#include "../../registered.hpp"
#include "../../tables/columns.hpp"
#include "bond_columns.hpp"

namespace bondem {
namespace {

#if defined(BONDEM_LANES)

// Distance in bonds at which first elements are prefetched.
constexpr Index ahead = 32;

BONDEM_INLINE Row<Lanes> moment_row(const Stress<Lanes> &s) {
    const Lanes zero = {};
    return {{s.xx, s.yy, s.zz, s.xy, s.xz, s.yz, zero, zero}};
}

// Number of bonds that pass one stage of `find_forces` before the next stage begins. All stages in one loop would
// need many times the registers, form one long chain of dependent operations, and access more columns at once than
// caches can foresee.
constexpr Index bonds_of_stage = 128;

// Results of one stage for a group of bonds, which the next stage reads.
struct Staged {
    PairPose<Lanes> now;
    Rotation<Lanes> of_i;
    Vector3<Lanes> force;  // the extra force [N] after the second stage, the total force [N] after the third
};

// Finds the forces of the bonds of a range; calls give(group, pose, loads) with their loads.
template <bool steps, class Give>
BONDEM_INLINE void find_forces(const Range &range, const double *pose, const Beams &beams, const NonLocalBonds &bonds,
                               const LaggedStresses &stresses, Give give) {
    const Short *const i = beams.i.data, *const j = beams.j.data;
    const double *const space = stresses.space.data;
    const PairLaw law = pair_law(bonds);
    Staged staged[bonds_of_stage / lanes];
    for (Index first = range.first; first < range.last; first += bonds_of_stage) {
        const auto stage = [&](auto on) __attribute__((always_inline)) {
            Staged *at = staged;
            for_each_group(first, least(first + bonds_of_stage, range.last),
                           [&](Group group) __attribute__((always_inline)) { on(group, group.first, *at++); });
        };
        stage([&](Group, Index k, Staged &at) __attribute__((always_inline)) {
            prefetch(pose, i + least(k + ahead, range.last - lanes));
            const Ends<Lanes> ends = ends_of(gather(pose, i + k, j + k), beams.period.data);
            at.of_i = matrix_of(ends.i);
            at.now = pair_pose(ends.branch, at.of_i, ends.j, pair_shape<Lanes>(bonds, k));
        });
        stage([&](Group, Index k, Staged &at) __attribute__((always_inline)) {
            const auto mean = [&]() __attribute__((always_inline)) {
                return all<Lanes>(0.5) * stress_of(gather_sums(space, i + k, j + k));
            };
            const PairStore<Lanes> before = stored_by<Lanes>(bonds, k);
            at.force = extra_now<steps>(before, at.now, at.of_i, pair_stiffness<Lanes>(bonds, k), law, mean);
        });
        stage([&](Group group, Index k, Staged &at) __attribute__((always_inline)) {
            const Lanes s = load(beams.integrity.data + k);
            const PairStore<Lanes> before = stored_by<Lanes>(bonds, k);
            const PairStore<Lanes> after = store_now<steps>(before, at.force, at.now, at.of_i, s);
            keep_store(bonds, group, s, after, before);
            at.force = s * present_force(after, at.now, at.of_i, pair_stiffness<Lanes>(bonds, k));
        });
        stage([&](Group group, Index, Staged &at) __attribute__((always_inline)) {
            give(group, at.now, non_local_loads(at.now, at.force));
        });
    }
}
template <class Give>
BONDEM_INLINE void find_forces(const Range &range, const Moving &all, const Beams &beams, const NonLocalBonds &bonds,
                               const LaggedStresses &stresses, Give give) {
    if (range.clock.dt > 0.0)
        find_forces<true>(range, all.pose.data, beams, bonds, stresses, give);
    else
        find_forces<false>(range, all.pose.data, beams, bonds, stresses, give);
}

// Adds forces of a group of bonds to the moments of their elements; `add_loads` adds their loads to the sums.
BONDEM_INLINE void add_moments(const LaggedStresses &stresses, const Beams &beams, Group group,
                               const PairPose<Lanes> &now, Vector3<Lanes> force) {
    const Index k = group.first;
    add_rows(stresses.moment.data, stresses.to_i.data + k, beams.j.data + k,
             moment_row(symmetric_product(now.lever_i, force)), moment_row(symmetric_product(-now.lever_j, force)),
             group.known);
}
BONDEM_INLINE void add_loads(const StepBlocks &blocks, Group group, const NonLocalLoads<Lanes> &loads) {
    const Index k = group.first;
    const BeamLoads<Lanes> each = {-loads.force, loads.on_i, -loads.on_j};
    add_loads_of(blocks.sums.data, blocks.row_i.data + k, blocks.row_j.data + k, each, group.known);
}

#endif

}  // namespace

#if defined(BONDEM_LANES)

// Finds forces and torques of the bonds of a block, integrates their stored values over the step, and adds their
// moments to the stresses of their elements.
void find_non_local_forces(const Range &range, const Moving &all, const Beams &beams, const NonLocalBonds &bonds,
                           const LaggedStresses &stresses) {
    const auto keep = [&](Group group, const PairPose<Lanes> &now, const NonLocalLoads<Lanes> &loads)
                          __attribute__((always_inline)) {
        keep_output(bonds, group, loads);
        add_moments(stresses, beams, group, now, loads.force);
    };
    find_forces(range, all, beams, bonds, stresses, keep);
}
BONDEM_PASS(find_non_local_forces, bonds_of_blocks, "ends pose space; adds moment")

// Adds forces and torques of the bonds to the sums of the elements, in the order of the bonds.
void add_non_local_loads(const Range &range, const NonLocalBonds &bonds, const StepBlocks &blocks) {
    const double *const data = bonds.output.data;
    const Index m = bonds.output.shape[1];
    for_each_group(range.first, range.last, [&](Group group) __attribute__((always_inline)) {
        const auto vector = [&](Output first) __attribute__((always_inline)) {
            return vector_at<Lanes>(data, m, first, group.first);
        };
        add_loads(blocks, group, {vector(force_column), vector(on_i_column), vector(on_j_column)});
    });
}
BONDEM_PASS(add_non_local_loads, bonds_of_blocks, "adds sums")

// Finds and adds forces and torques of bonds that cannot fail, without keeping them.
void add_lasting_loads(const Range &range, const Moving &all, const Beams &beams, const NonLocalBonds &bonds,
                       const LaggedStresses &stresses, const StepBlocks &blocks) {
    const auto add = [&](Group group, const PairPose<Lanes> &now, const NonLocalLoads<Lanes> &loads)
                         __attribute__((always_inline)) {
        add_moments(stresses, beams, group, now, loads.force);
        add_loads(blocks, group, loads);
    };
    find_forces(range, all, beams, bonds, stresses, add);
}
BONDEM_PASS(add_lasting_loads, bonds_of_blocks, "ends pose space; adds moment sums")

#endif

void sum_non_local_energies(const Range &range, const Moving &all, const Beams &beams, const NonLocalBonds &bonds,
                            const Ledger &ledger) {
    ExactSum normal = {}, shear = {}, taken = {};
    for (Index k = range.first; k < range.last; k++) {
        const double s = beams.integrity(k);
        if (s > 0.0) {
            const SpringEnergy<double> energy =
                spring_energy(pair_pose(all.pose.data, beams, bonds, k), pair_stiffness<double>(bonds, k));
            normal.add(s * energy.normal);
            shear.add(s * energy.shear);
        }
        taken.add(bonds.history(taken_column, k));
    }
    sum_of(ledger, history_column::normal).add_shared(normal);
    sum_of(ledger, history_column::shear).add_shared(shear);
    sum_of(ledger, history_column::extra_work).add_shared(taken);
}
BONDEM_PASS(sum_non_local_energies, of_bonds, "ends pose")

// Finds extra forces at small strain, where frames of elements are those of space.
Index find_small_extra_forces(Index, const SmallPairs &pairs, const ExtraForces &extra) {
    const PairLaw law = {pairs.nu, pairs.limited != 0};
    for (Index k = 0; k < pairs.area.size(); k++) {
        const auto stress = [&](Index end) { return pairs.stress.row<const Stress<double>>(pairs.pairs(k, end)); };
        const Vector n = pairs.normal.row<const Vector>(k);
        const Vector slip = pairs.kt(k) * tangential(pairs.gap.row<const Vector>(k), n);
        extra.force.row<Vector>(k) = extra_force(mean_of(stress(0), stress(1)), n, pairs.area(k), slip, law);
    }
    return 0;
}
BONDEM_CALL(find_small_extra_forces, "")

namespace {
// A motion (u, θ) of an element, or a force and a torque.
struct Twist {
    Vector u, turn;
};
Vector moved_by(const Twist &a, Vector lever) { return a.u + cross(a.turn, lever); }

void add_load(const Array<double, 2> &to, Index row, Vector force, Vector lever) {
    to.row<Twist>(row) = {to.row<Twist>(row).u + force, to.row<Twist>(row).turn + cross(lever, force)};
}
// Adds the symmetric part of b ⊗ F to the moment of an element.
void add_moment(const Array<double, 2> &to, Index row, Vector b, Vector f) {
    Stress<double> &sum = to.row<Stress<double>>(row);
    sum.xx += b.x * f.x, sum.yy += b.y * f.y, sum.zz += b.z * f.z;
    sum.xy += 0.5 * (b.x * f.y + b.y * f.x), sum.xz += 0.5 * (b.x * f.z + b.z * f.x);
    sum.yz += 0.5 * (b.y * f.z + b.z * f.y);
}
}  // namespace

// Takes steps of small motions with extra forces that lag a step behind, until their energy is 1e30 times the first.
Index take_small_steps(Index, const SmallPairs &pairs, const SmallSprings &springs, const SmallSteps &run) {
    const PairLaw law = {pairs.nu, pairs.limited != 0};
    const Index n = run.volume.size(), m = pairs.area.size();
    for (Index step = 0; step < run.size.size(); step++) {
        for (Index p = 0; p < 6 * n; p++) {
            run.motion.data[p] += run.dt * run.speed.data[p];
            run.load.data[p] = run.moment.data[p] = 0.0;
        }
        for (Index k = 0; k < m; k++) {
            const Index i = pairs.pairs(k, 0), j = pairs.pairs(k, 1);
            const Vector n_k = pairs.normal.row<const Vector>(k);
            const Vector a = springs.lever_i.row<const Vector>(k), b = springs.lever_j.row<const Vector>(k);
            const auto opened = [&](const Array<double, 2> &by) {
                return moved_by(by.row<const Twist>(j), b) - moved_by(by.row<const Twist>(i), a);
            };
            Vector &gap = run.gap.row<Vector>(k);
            const Stress<double> mean =
                mean_of(run.stress.row<const Stress<double>>(i), run.stress.row<const Stress<double>>(j));
            const Vector extra = extra_force(mean, n_k, pairs.area(k), pairs.kt(k) * tangential(gap, n_k), law);
            gap = opened(run.motion);
            const PairStiffness<double> stiffness = {pairs.area(k), springs.kn(k), pairs.kt(k)};
            Vector force = spring_force(PairPose<double>{n_k, a, b, gap}, stiffness) + extra;
            add_moment(run.moment, i, a, force);
            add_moment(run.moment, j, b, -1.0 * force);
            const Vector rate = opened(run.speed);
            const double inward = (springs.along(k) - springs.across(k)) * dot(rate, n_k);
            force = plus(plus(force, springs.across(k), rate), inward, n_k);
            add_load(run.load, i, force, a);
            add_load(run.load, j, -1.0 * force, b);
        }
        double size = 0.0;
        for (Index p = 0; p < 6 * n; p++) {
            double &speed = run.speed.data[p], load = run.load.data[p];
            const double weight = run.weight.data[p], drag = run.gamma * (load < 0.0 ? -load : load);
            load -= speed > 0.0 ? drag : speed < 0.0 ? -drag : 0.0;
            speed += run.dt * load / weight;
            size += weight * speed * speed;
            run.stress.data[p] = run.moment.data[p] / run.volume(p / 6);
        }
        run.size(step) = size;
        if (!(size < 1e30 * (run.size(0) > 1e-300 ? run.size(0) : 1e-300))) return 0;
    }
    return 0;
}
BONDEM_CALL(take_small_steps, "")

#if defined(BONDEM_LANES)

// Finds forces and torques of all bonds in given poses from their stored values.
Index load_non_local_bonds(Index, const Poses &all, const Beams &beams, const NonLocalBonds &bonds) {
    for_each_group(0, beams.i.size(), [&](Group group) {
        const Index k = group.first;
        const Row<Lanes> i = gather(all.pose.data, beams.i.data + k), j = gather(all.pose.data, beams.j.data + k);
        const Ends<Lanes> ends = ends_of(i, j, beams.period.data);
        const Rotation<Lanes> of_i = matrix_of(ends.i);
        const PairPose<Lanes> now = pair_pose(ends.branch, of_i, ends.j, pair_shape<Lanes>(bonds, k));
        const Vector3<Lanes> force =
            present_force(stored_by<Lanes>(bonds, k), now, of_i, pair_stiffness<Lanes>(bonds, k));
        keep_output(bonds, group, non_local_loads(now, load(beams.integrity.data + k) * force));
    });
    return 0;
}
BONDEM_CALL(load_non_local_bonds, "")

#endif

}  // namespace bondem
