// Bonds of the non-local law that fail by the mean stress of their two elements.
//
// The criterion is evaluated when the stresses of the step are known. σ1 of a mean is at most the mean of both σ1, and σ3 at
// least the mean of both σ3, so that only bonds that reach their criterion by these are evaluated exactly. The energy
// released is that of the springs; the work of extra forces stays in an entry of its own. The stresses of the
// elements, which the next step takes, are then without the bond.
#include "pair_failure.hpp"

#include "../../laws/criteria/principal_stress.hpp"
#include "../../laws/principal.hpp"
#include "../damage/pipeline.hpp"
#include "bond_columns.hpp"

namespace bondem {
namespace {

// Columns of a stress in space that hold bounds of its largest and its least principal stress.
enum Bounds : Index { largest_column = 6, least_column };

Verdict<double> verdict_of(const Beams &beams, const LaggedStresses &stresses, const Strengths &strengths, Index k) {
    const auto stress = [&](Short p) { return stresses.space.row<const Stress<double>>(p); };
    const PrincipalStress<double> found = principal(mean_of(stress(beams.i(k)), stress(beams.j(k))));
    const double *c = &strengths.coefficient(k, 0);
    const Coefficients<double> own = {c[0], c[1], c[2], c[3]};
    return PrincipalStressCriterion::verdict(largest_of(found), least_of(found), own);
}

// Takes from the stress of an element, in its own frame, what ± a force does at a lever.
void relieve(const double *pose, const LaggedStresses &stresses, Short p, Vector lever, Vector force, double sign) {
    const Vector own = turned_by(inverse(orientation(gather(pose, p))), force);
    const Stress<double> s = (sign * stresses.inverse(p)) * symmetric_product(lever, own);
    const double all[6] = {s.xx, s.yy, s.zz, s.xy, s.xz, s.yz};
    for (Index c = 0; c < 6; c++) stresses.stress(p, c) -= all[c];
}

Vector output_at(const NonLocalBonds &bonds, Output first, Index k) {
    return vector_at<double>(bonds.output.data, bonds.output.shape[1], first, k);
}

}  // namespace

void mark_pairs(const Turn &turn, const Beams &beams, const LaggedStresses &stresses, const Strengths &strengths,
                const Candidates &candidates) {
    const Index first = candidates.begin(turn.block), last = strengths.coefficient.size();
    Index next = first;
    for_each_group(turn.first, turn.last, [&](Group group) __attribute__((always_inline)) {
        const Index k = group.first;
        const double *const space = stresses.space.data;
        const Row<Lanes> i = gather(space, beams.i.data + k), j = gather(space, beams.j.data + k);
        Short place[lanes];
        for (int n = 0; n < lanes; n++) place[n] = Short(least(k + n, last - 1));
        const auto coefficient = [&](Index c) { return number_at(strengths.coefficient.data, 4, c, place); };
        const Coefficients<Lanes> own = {coefficient(0), coefficient(1), coefficient(2), coefficient(3)};
        const Lanes largest = 0.5 * (i.column[largest_column] + j.column[largest_column]);
        const Lanes lowest = 0.5 * (i.column[least_column] + j.column[least_column]);
        const Lanes index = PrincipalStressCriterion::verdict(largest, lowest, own).index;
        const Lanes s = load(beams.integrity.data + k), zero = {}, one = zero + 1.0;
        if (__builtin_expect(any_reaches(s > zero ? index : zero, one), 0))
            for (int n = group.known; n < lanes; n++)
                if (s[n] > 0.0 && index[n] >= 1.0) candidates.marked(next++) = k + n;
    });
    candidates.count(turn.block) = next - first;
}

void judge_pairs(const Turn &turn, const Beams &beams, const LaggedStresses &stresses, const Strengths &strengths,
                 const Candidates &candidates, const Postponed &postponed) {
    judge(
        turn, candidates, [&](Index k) { return beams.integrity(k) > 0.0; },
        [&](Index k) { return verdict_of(beams, stresses, strengths, k); },
        [&](Index k) {
            hold(postponed, beams.i(k));
            hold(postponed, beams.j(k));
        });
}

void break_pairs(const Turn &turn, const Moving &all, const Beams &beams, const NonLocalBonds &bonds,
                 const Candidates &candidates, const Postponed &postponed, const EventLog &log) {
    const double *const pose = all.pose.data;
    remove(turn, candidates, log, [&](Index k) -> Removal {
        const Short i = beams.i(k), j = beams.j(k);
        const Vector force = output_at(bonds, force_column, k);
        take_off(&postponed.kept(i, 0), 1.0, force, 1.0, output_at(bonds, on_i_column, k));
        take_off(&postponed.kept(j, 0), -1.0, force, -1.0, output_at(bonds, on_j_column, k));
        const PairPose<double> now = pair_pose(pose, beams, bonds, k);
        const SpringEnergy<double> energy = spring_energy(now, pair_stiffness<double>(bonds, k));
        const Vector centre = {pose[8 * i], pose[8 * i + 1], pose[8 * i + 2]};
        return {beams.integrity(k) * (energy.normal + energy.shear), dot(now.gap, now.normal),
                plus(centre + now.lever_i, 0.5, now.gap)};
    });
}

void relieve_pairs(const Turn &, const Moving &all, const Beams &beams, const NonLocalBonds &bonds,
                   const LaggedStresses &stresses, const BeamIntegrity &state, const Candidates &candidates) {
    const double *const pose = all.pose.data;
    for_each_failing(candidates, [&](Index k, Index) {
        const Vector force = output_at(bonds, force_column, k);
        const PairShape<double> shape = pair_shape<double>(bonds, k);
        relieve(pose, stresses, beams.i(k), shape.lever_i, force, 1.0);
        relieve(pose, stresses, beams.j(k), shape.lever_j, force, -1.0);
        for (Index c = 0; c < bonds.output.size(); c++) bonds.output(c, k) = 0.0;
        state.integrity(k) = 0.0;
    });
}

Index index_pairs(Index, const Beams &beams, const LaggedStresses &stresses, const Strengths &strengths,
                  const FailureIndices &found) {
    for (Index k = 0; k < strengths.coefficient.size(); k++)
        found.index(k) = beams.integrity(k) > 0.0 ? verdict_of(beams, stresses, strengths, k).index : 0.0;
    return 0;
}

}  // namespace bondem
