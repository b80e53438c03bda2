// Failure of beams on a GPU, in the same stages as on the CPU (`passes/damage/pipeline.hpp`). Facets and bonds of the
// non-local law use some of these functions.
//
// The thread of a beam computes the loads of the beam, and evaluates the criterion if the beam is near failure. Beams
// that fail are listed in any order; passes with one thread per failed beam sort the list and remove the beams. The
// two elements of a failed beam start the next step later than the others. The thread of such an element subtracts
// the loads of its failed beams, in the order of beams. A single thread adds up released energies.
#pragma once
#include "../passes/damage/beam_verdicts.hpp"
#include "../passes/damage/pipeline.hpp"
#include "beams.hpp"
#include "motion.hpp"
#include "record.hpp"

namespace bondem {

// ---- marks

// Marks of a bond: `near`, its load reaches its bound; `fails`, it fails in this step. 0 for other bonds.
namespace marked {
enum : Byte { near = 1, fails };
}

template <class Bounds>
BONDEM_INLINE void mark_one(Index k, const BeamLoads<double> &loads, const Bounds &bounds, const BondMarks &marks) {
    const Vector f = loads.force, a = loads.on_i, b = loads.on_j;
    const double size = bounds.of_force * dot(f, f) + bounds.of_moment * (dot(a, a) + dot(b, b));
    marks.mark(k) = size >= double(bounds.limit(k)) ? marked::near : 0;
}
BONDEM_INLINE void put_marked(Index k, const BeamLoads<double> &loads, const LoadsOfBonds &to, const FailureBounds &bounds,
                              const BondMarks &marks) {
    mark_one(k, loads, bounds, marks);
    put(to, k, loads);
}
inline void load_marked_beam(Index k, const Moving &all, const Beams &beams, const LoadsOfBonds &to,
                             const FailureBounds &bounds, const BondMarks &marks) {
    put_marked(k, loads_of(k, all, beams, Own{beams}), to, bounds, marks);
}
inline void load_marked_uniform_beam(Index k, const Moving &all, const Beams &beams, const UniformBeams &uniform,
                                     const LoadsOfBonds &to, const FailureBounds &bounds, const BondMarks &marks) {
    put_marked(k, loads_of(k, all, beams, all_uniform(uniform)), to, bounds, marks);
}

// ---- evaluation

// Lists bond k if it fails, in any order; returns true if it fails.
BONDEM_INLINE bool list_failing(Index k, const Verdict<double> &verdict, const BondMarks &marks,
                                const Candidates &candidates) {
    if (!(verdict.index >= 1.0)) return false;
    const Index place = count_up(candidates.count(0));
    marks.mark(k) = marked::fails;
    marks.failing(place) = Short(k);
    marks.mode(place) = Byte(verdict.mode);
    put_shared(candidates.any(0), Index(1));
    return true;
}
// Evaluates beam k if it is marked and unbroken; lists it and postpones its ends if it fails.
template <class Criterion>
BONDEM_INLINE void judge_beam(Index k, const DeviceSpan &span, const Moving &all, const Beams &beams,
                              const Strengths &strengths, const BondMarks &marks, const Candidates &candidates,
                              const Postponed &postponed) {
    if (marks.mark(k) == 0 || clock_of(span).first || !(beams.integrity(k) > 0.0)) return;
    if (list_failing(k, verdict_of<Criterion>(all.pose.data, beams, strengths, k), marks, candidates))
        postpone_ends(postponed, beams, k);
}
#define BONDEM_JUDGE(_, name, Criterion) constexpr auto judge_beam_by_##name = as<&judge_beam<Criterion>>;
BONDEM_BEAM_CRITERIA(BONDEM_JUDGE, )
#undef BONDEM_JUDGE

// Moves bond number e of the unordered list of failed bonds to its place in the order of bonds.
inline void rank_failing(Index e, const BondMarks &marks, const Candidates &candidates) {
    const Index count = candidates.count(0);
    if (e >= count) return;
    const Short k = marks.failing(e);
    Index place = 0;
    for (Index other = 0; other < count; other++) place += marks.failing(other) < k;
    candidates.marked(place) = k;
    candidates.mode(place) = marks.mode(e);
}

// ---- removal

// Calls on(k, true if p is end i of bond k) for the failing bonds of element p, in ascending order.
template <class On>
BONDEM_INLINE void for_each_failing_of(Index p, const BondsOfElements &bonds, const BondMarks &marks, On on) {
    for_each_bond_of(bonds, p, [&](Index k, bool is_i) {
        if (marks.mark(k) == marked::fails) on(k, is_i);
    });
}
// Writes the event of the failed bond at place e of the order of bonds.
BONDEM_INLINE void write_failure(Index e, const DeviceSpan &span, const Candidates &candidates, const EventLog &log,
                                 const Removal &removal) {
    write_event(clock_of(span), log, log.written(log_count::events) + e, candidates.marked(e), candidates.mode(e), removal);
}
// Counts the events of a step, and adds up their released energies.
inline void count_failures(Index, const Candidates &candidates, const EventLog &log) {
    log.written(log_count::before) = log.written(log_count::events);
    if (!any_fails(candidates)) return;
    log.written(log_count::events) += candidates.count(0);
    ExactSum released = {};
    for_each_event(log, [&](Index, Index event) { released.add(log.event(event, event_column::energy)); });
    log.released(0) += released.value();
}

BONDEM_INLINE BeamLoads<double> loads_in(const LoadsOfBonds &from, Index k) {
    const auto at = [&](Index c) { return vector_at<double>(from.load.data, from.load.shape[1], c, k); };
    return {at(0), at(3), at(6)};
}
// Removes the failed beam at place e of the order of bonds, and writes the loads that its ends lose.
inline void remove_failing_beam(Index e, const DeviceSpan &span, const Moving &all, const Beams &beams,
                                const BeamIntegrity &state, const Candidates &candidates, const EventLog &log,
                                const LoadsOfBonds &to) {
    if (e >= candidates.count(0)) return;
    const Index k = candidates.marked(e);
    const FailedBeam failed = failed_beam(all.pose.data, beams, state, k);
    put(to, k, failed.loads);
    write_failure(e, span, candidates, log, failed.removal);
    put_integrity_of_beam(state, k, 0.0, beams.length(k));
}
inline void take_beams_off_element(Index p, const BondsOfElements &bonds, const BondMarks &marks, const LoadsOfBonds &from,
                                   const Candidates &candidates, const Postponed &postponed) {
    if (!any_fails(candidates) || !is_postponed(postponed, p)) return;
    for_each_failing_of(p, bonds, marks, [&](Index k, bool is_i) {
        take_off_end(&postponed.sum(p, 0), is_i, loads_in(from, k));
    });
}
inline void load_failing_dashpot(Index e, const Moving &all, const Beams &beams, const Dashpots &dashpots,
                                 const Candidates &candidates, const LoadsOfBonds &to) {
    if (e >= candidates.count(0)) return;
    const Index k = candidates.marked(e);
    put(to, k, loads_of_dashpot(all, beams, dashpots, k));
}
// Subtracts dashpots of failed beams from the sums of element p: that of all forces, and that of dashpots alone.
inline void take_dashpots_off_element(Index p, const BondsOfElements &bonds, const BondMarks &marks,
                                      const LoadsOfBonds &from, const Dashpots &dashpots, const Candidates &candidates,
                                      const Postponed &postponed) {
    if (!any_fails(candidates) || !is_postponed(postponed, p)) return;
    for_each_failing_of(p, bonds, marks, [&](Index k, bool is_i) {
        const BeamLoads<double> loads = loads_in(from, k);
        take_off_end(&postponed.sum(p, 0), is_i, loads);
        take_off_end(&dashpots.sums(postponed.first_row + p, 0), is_i, loads);
    });
}

// ---- postponed elements: e and h are places in the list of all elements, and among those with a row of the boundary

inline void keep_gathered_sum(Index e, const StepBlocks &blocks, const BondsOfElements &bonds,
                              const LoadsOfBonds &from, const Postponed &postponed) {
    const Short p = blocks.ready(e);
    if (is_postponed(postponed, p)) row_at(postponed.sum.data, p) = gathered({}, p, bonds, from);
}
inline void keep_sum(Index e, const StepBlocks &blocks, const Postponed &postponed) {
    const Short p = blocks.ready(e);
    if (is_postponed(postponed, p)) row_at(postponed.sum.data, p) = row_at(blocks.sums.data, blocks.ready_row(e));
}
inline void keep_dashed_sum(Index e, const StepBlocks &blocks, const Dashpots &dashpots, const Postponed &postponed) {
    const Short p = blocks.ready(e);
    if (is_postponed(postponed, p))
        row_at(dashpots.sums.data, Short(postponed.first_row + p)) = row_at(dashpots.sums.data, blocks.ready_row(e));
}

// Finds the acceleration of element p, if it is postponed, by its kept sum; opens its next step if the run continues.
template <class Boundary, class Resisted>
BONDEM_INLINE void resume(const DeviceSpan &span, const Moving &all, const Postponed &postponed, Index p,
                          const Boundary &row, const Resisted &resistance, Index r) {
    if (!is_postponed(postponed, p)) return;
    Clock still = clock_of(span);
    still.dt = still.finish = still.begin = still.extra = 0.0;
    still.goes_on = 0;
    One one(p);
    one.row = Short(postponed.first_row + p);  // of the sums of its dashpots
    move(one, still, all, Wrench<double>(gather(postponed.sum.data, one.element)), row, resistance, r);
    if (clock_of(span).goes_on) open_one(p, clock_of(span), all, row);
}
inline void resume_free(Index e, const DeviceSpan &span, const Moving &all, const StepBlocks &blocks,
                        const Postponed &postponed) {
    resume(span, all, postponed, blocks.ready(e), NoRow{}, NoRow{}, -1);
}
inline void resume_resisted(Index e, const DeviceSpan &span, const Moving &all, const StepBlocks &blocks,
                            const Resistance &resistance, const Postponed &postponed) {
    resume(span, all, postponed, blocks.ready(e), NoRow{}, resistance, -1);
}
inline void resume_row(Index h, const DeviceSpan &span, const Moving &all, const StepBlocks &blocks, const Rows &rows,
                       const Postponed &postponed) {
    const Index p = blocks.ready(blocks.first_owner(0) + h), r = rows.of(p);
    resume(span, all, postponed, p, BoundaryRow(rows, r), NoRow{}, r);
}
inline void resume_resisted_row(Index h, const DeviceSpan &span, const Moving &all, const StepBlocks &blocks,
                                const Rows &rows, const Resistance &resistance, const Postponed &postponed) {
    const Index p = blocks.ready(blocks.first_owner(0) + h), r = rows.of(p);
    resume(span, all, postponed, p, BoundaryRow(rows, r), resistance, r);
}
inline void reopen_work_of_body(Index p, const DeviceSpan &span, const Moving &all, const BodyForces &body,
                                const Postponed &postponed) {
    if (is_postponed(postponed, p) && clock_of(span).goes_on) open_body_work(range_of(span, p), all, body);
}
inline void release_element(Index p, const Candidates &candidates, const Postponed &postponed) {
    if (any_fails(candidates)) postponed.flag(p) = 0;
}
inline void end_all_failures(Index, const Candidates &candidates) {
    if (any_fails(candidates)) end_failures(candidates);
}
inline void write_released_energy(Index, const DeviceSpan &span, const EventLog &log, const HistoryRows &history) {
    history.record(clock_of(span).record, history_column::released) = log.released(0);
}

}  // namespace bondem
