// Bonds of the non-local law on a GPU. The thread of a bond computes its force, and the thread of an element computes
// its stress. The thread of a bond then evaluates the failure criterion by the stresses of both elements. Further
// passes remove failed bonds, and subtract their forces from the stresses of their elements.
//
// The contributions of bonds and contacts to the stress of an element are added in the same order as on the CPU.
#pragma once
#include "../passes/non_local/non_local_passes.hpp"
#include "../passes/non_local/own_stress.hpp"
#include "../passes/non_local/pair_removal.hpp"
#include "../passes/non_local/pair_verdict.hpp"
#include "../passes/non_local/touch_levers.hpp"
#include "breakage.hpp"
#include "contacts.hpp"

namespace bondem {

// ---- forces of bonds

template <bool steps>
BONDEM_INLINE void find_pair(Index k, const Moving &all, const Beams &beams, const NonLocalBonds &bonds,
                             const LaggedStresses &stresses, const LoadsOfBonds &to) {
    const double *const space = stresses.space.data, s = beams.integrity(k);
    const Ends<double> ends = ends_of(all.pose.data, beams, k);
    const Rotation<double> of_i = matrix_of(ends.i);
    const PairPose<double> now = pair_pose(ends.branch, of_i, ends.j, pair_shape<double>(bonds, k));
    const PairStiffness<double> stiffness = pair_stiffness<double>(bonds, k);
    const PairStore<double> before = stored_by<double>(bonds, k);
    const auto mean = [&] { return mean_of(stress_of(gather(space, beams.i(k))), stress_of(gather(space, beams.j(k)))); };
    const Vector extra = extra_now<steps>(before, now, of_i, stiffness, pair_law(bonds), mean);
    const PairStore<double> after = store_now<steps>(before, extra, now, of_i, s);
    keep_store(bonds, k, s, after, before);
    const NonLocalLoads<double> loads = non_local_loads(now, s * present_force(after, now, of_i, stiffness));
    keep_output(bonds, k, loads);
    put(to, k, {-loads.force, loads.on_i, -loads.on_j});
}
inline void find_force_of_pair(Index k, const DeviceSpan &span, const Moving &all, const Beams &beams,
                               const NonLocalBonds &bonds, const LaggedStresses &stresses, const LoadsOfBonds &to) {
    if (clock_of(span).dt > 0.0)
        find_pair<true>(k, all, beams, bonds, stresses, to);
    else
        find_pair<false>(k, all, beams, bonds, stresses, to);
}

// ---- stresses of elements

inline void turn_stress_of_element(Index p, const Moving &all, const LaggedStresses &stresses) {
    turn_stress(Short(p), all.pose.data, stresses);
}
inline void gather_moments(Index p, const Moving &all, const NonLocalBonds &bonds, const BondsOfElements &of,
                           const LaggedStresses &stresses) {
    const Quaternion<double> q = orientation(gather(all.pose.data, Short(p)));
    const Rotation<double> of_i = matrix_of(q);  // as in `pair_pose`, bit by bit
    Stress<double> sum = {};
    for_each_bond_of(of, p, [&](Index k, bool is_i) {
        const PairShape<double> shape = pair_shape<double>(bonds, k);
        const Vector lever = is_i ? turned_by(of_i, shape.lever_i) : -turned_by(q, shape.lever_j);
        sum = sum + symmetric_product(lever, output_at(bonds, force_column, k));
    });
    row_at(stresses.moment.data, Short(p)) = {{sum.xx, sum.yy, sum.zz, sum.xy, sum.xz, sum.yz, 0.0, 0.0}};
}
// Adds the pairs of element p to its stress: as the later element of a pair, then as the earlier one.
inline void add_pair_moments_of_element(Index p, const Moving &all, const ContactConstants &c, const ContactPairs &pairs,
                                        const EarlierPairs &earlier, const NearPairs &near, const LaggedStresses &stresses) {
    for_each_pair_of(pairs, earlier.start, earlier.pair, p, [&](Index k, bool later) {
        if (!as_spheres(pairs.touch(k))) return;
        const TouchLevers lever(c, pairs, k, branch_of(all.pose.data, pairs, k));
        const Vector force = near.output.row<const Vector>(k);
        add_moment(stresses, Short(p), later ? lever.of_second : lever.of_first, later ? force : -force);
    });
}
constexpr auto add_wall_moments_of_element = one_element<add_wall_moments>;
inline void find_stress_of_element(Index p, const Moving &all, const LaggedStresses &stresses) {
    find_stress(Short(p), all.pose.data, stresses);
}

// ---- failure

inline void judge_pair(Index k, const DeviceSpan &span, const Beams &beams, const LaggedStresses &stresses,
                       const Strengths &strengths, const BondMarks &marks, const Candidates &candidates,
                       const Postponed &postponed) {
    marks.mark(k) = 0;
    if (clock_of(span).first || !(beams.integrity(k) > 0.0)) return;
    const double *const space = stresses.space.data;
    const Row<double> i = gather(space, beams.i(k)), j = gather(space, beams.j(k));
    if (!(bound_of_index(i, j, coefficients_of(strengths, k)) >= 1.0)) return;
    if (list_failing(k, verdict_of_pair(beams, stresses, strengths, k), marks, candidates))
        postpone_ends(postponed, beams, k);
}
inline void write_pair_failure(Index e, const DeviceSpan &span, const Moving &all, const Beams &beams,
                               const NonLocalBonds &bonds, const Candidates &candidates, const EventLog &log) {
    if (e < candidates.count(0))
        write_failure(e, span, candidates, log, removal_of_pair(all, beams, bonds, candidates.marked(e)));
}
inline void take_pairs_off_element(Index p, const NonLocalBonds &bonds, const BondsOfElements &of, const BondMarks &marks,
                                   const Candidates &candidates, const Postponed &postponed) {
    if (!any_fails(candidates) || !is_postponed(postponed, p)) return;
    for_each_failing_of(p, of, marks, [&](Index k, bool is_i) { take_off_pair(&postponed.sum(p, 0), is_i, bonds, k); });
}
inline void relieve_element(Index p, const Moving &all, const NonLocalBonds &bonds, const BondsOfElements &of,
                            const BondMarks &marks, const LaggedStresses &stresses, const Candidates &candidates) {
    if (!any_fails(candidates)) return;
    for_each_failing_of(p, of, marks, [&](Index k, bool is_i) { relieve(all, stresses, Short(p), is_i, bonds, k); });
}
inline void end_failing_pair(Index e, const NonLocalBonds &bonds, const BeamIntegrity &state, const Candidates &candidates) {
    if (e < candidates.count(0)) end_pair(bonds, state, candidates.marked(e));
}
constexpr auto add_all_new_contacts = once<add_new_contacts>;

// ---- sums for the history

constexpr auto sum_portion_of_springs = portion_of_bonds<sum_non_local_energies>;

}  // namespace bondem
