// Beams that fail without softening: the criterion on their loads, and their removal.
#include "../../registered.hpp"
#include "beam_removal.hpp"
#include "beam_verdicts.hpp"

namespace bondem {
namespace {

// Evaluates marked beams of a block by a criterion, and postpones the elements of failed beams.
template <class Criterion>
void judge_beams(const Range &range, const Moving &all, const Beams &beams, const Strengths &strengths,
                 const Candidates &candidates, const Postponed &postponed) {
    judge(
        range, candidates, [&](Index k) { return beams.integrity(k) > 0.0; },
        [&](Index k) { return verdict_of<Criterion>(all.pose.data, beams, strengths, k); },
        [&](Index k) { postpone_ends(postponed, beams, k); });
}

#if defined(BONDEM_LANES)

// Coefficient c of the bonds from k on; lanes after the last bond repeat that of the last one.
Lanes coefficients_of(const Strengths &strengths, Index k, Index c) {
    Lanes all;
    for (int n = 0; n < lanes; n++) all[n] = strengths.coefficient(least(k + n, strengths.station.size() - 1), c);
    return all;
}
Lanes stations_of(const Strengths &strengths, Index k) {
    Lanes all;
    for (int n = 0; n < lanes; n++) all[n] = strengths.station(least(k + n, strengths.station.size() - 1));
    return all;
}

// Finds the index of every beam by a criterion in given poses, as many at once as there are lanes.
template <class Criterion>
Index index_beams(Index, const Poses &all, const Beams &beams, const Strengths &strengths, const FailureIndices &found) {
    const double *const pose = all.pose.data;
    if (strengths.station.size() == 0) return 0;
    for_each_group(0, beams.i.size(), [&](Group group) {
        const Index k = group.first;
        const Row<Lanes> i = gather(pose, beams.i.data + k), j = gather(pose, beams.j.data + k);
        const Ends<Lanes> ends = ends_of(i, j, beams.period.data);
        const BeamShape<Lanes> shape = shape_of<Lanes>(beams, k);
        const Lanes s = load(beams.integrity.data + k), zero = {};
        const BeamLoads<Lanes> loads = beam_loads(ends, shape, stiffness_of(beams, k, s));
        const Coefficients<Lanes> c = {coefficients_of(strengths, k, 0), coefficients_of(strengths, k, 1),
                                       coefficients_of(strengths, k, 2), coefficients_of(strengths, k, 3)};
        const Lanes index = Criterion::verdict(seen_loads<Criterion>(ends, shape, loads, stations_of(strengths, k)), c).index;
        store(found.index.data + k, s > zero ? index : zero);
    });
    return 0;
}

#endif

Removal break_beam(const double *pose, const Beams &beams, const BeamIntegrity &state, const Postponed &postponed, Index k) {
    const FailedBeam failed = failed_beam(pose, beams, state, k);
    take_off_end(&postponed.sum(beams.i(k), 0), true, failed.loads);
    take_off_end(&postponed.sum(beams.j(k), 0), false, failed.loads);
    put_integrity_of_beam(state, k, 0.0, beams.length(k));
    return failed.removal;
}

void withdraw_dashpot(const Moving &all, const Beams &beams, const Dashpots &dashpots, const Postponed &postponed, Index k) {
    const BeamLoads<double> loads = loads_of_dashpot(all, beams, dashpots, k);
    // the sums of all forces and the sums of dashpots alone both contain these loads
    double *const tables[2] = {postponed.sum.data, dashpots.sums.data + 8 * postponed.first_row};
    for (double *sums : tables) {
        take_off_end(sums + 8 * beams.i(k), true, loads);
        take_off_end(sums + 8 * beams.j(k), false, loads);
    }
}

}  // namespace

#if defined(BONDEM_LANES)
#define BONDEM_CRITERION(_, name, Criterion)                                         \
    BONDEM_PASS_AS(judge_beams_by_##name, bonds_of_blocks, "ends pose; adds flag", judge_beams<Criterion>)  \
    BONDEM_CALL_AS(index_beams_by_##name, "", index_beams<Criterion>)
BONDEM_BEAM_CRITERIA(BONDEM_CRITERION, )
#undef BONDEM_CRITERION
#endif

// Subtracts dashpots of failed beams from the kept sums of their ends, before the beams are removed.
void withdraw_dashpots(const Range &, const Moving &all, const Beams &beams, const Dashpots &dashpots,
                       const Candidates &candidates, const Postponed &postponed) {
    for_each_failing(candidates, [&](Index k, Index) { withdraw_dashpot(all, beams, dashpots, postponed, k); });
}
BONDEM_PASS(withdraw_dashpots, of_events, "ends motion; still pose; adds sum sums")

// Removes the beams that fail.
void break_beams(const Range &range, const Moving &all, const Beams &beams, const BeamIntegrity &state,
                 const Candidates &candidates, const Postponed &postponed, const EventLog &log) {
    remove(range, candidates, log, [&](Index k) { return break_beam(all.pose.data, beams, state, postponed, k); });
}
BONDEM_PASS(break_beams, of_events, "still pose; adds sum")

}  // namespace bondem
