// Breakage on a device: a thread marks and judges one bond, one thread removes those that fail, in their order, and a thread
// each resumes the elements that this postpones.
//
// The stages are those of the CPU (`passes/damage/pipeline.hpp`). Bonds that fail are put in a list in any order, which one
// thread sorts. Where nothing fails, all threads but those of the marks return at once.
#pragma once
#include "../passes/damage/beam_failure.hpp"
#include "../passes/damage/beam_verdicts.hpp"
#include "../passes/damage/pipeline.hpp"
#include "beams.hpp"
#include "heap_sort.hpp"
#include "motion.hpp"
#include "record.hpp"

namespace bondem {

// ---- marks

template <class Bounds>
BONDEM_INLINE void mark_one(Index k, const BeamLoads<double> &loads, const Bounds &bounds, const BondMarks &marks) {
    const Vector f = loads.force, a = loads.on_i, b = loads.on_j;
    const double size = bounds.of_force * dot(f, f) + bounds.of_moment * (dot(a, a) + dot(b, b));
    marks.mark(k) = size >= double(bounds.limit(k));
}
BONDEM_INLINE void put_marked(Index k, const BeamLoads<double> &loads, const LoadsOfBonds &to, const FailureBounds &bounds,
                              const BondMarks &marks) {
    mark_one(k, loads, bounds, marks);
    put(to, k, loads);
}
inline void load_marked_beam(Index k, const Moving &all, const Beams &beams, const LoadsOfBonds &to,
                             const FailureBounds &bounds, const BondMarks &marks) {
    put_marked(k, loads_of(k, all, beams), to, bounds, marks);
}
inline void load_marked_alike_beam(Index k, const Moving &all, const Beams &beams, const AlikeBeams &alike,
                                   const LoadsOfBonds &to, const FailureBounds &bounds, const BondMarks &marks) {
    put_marked(k, loads_of(k, all, beams, alike), to, bounds, marks);
}

// ---- judging

// Lists bond k as one that fails, in any order; returns whether it does.
BONDEM_INLINE bool list_failing(Index k, const Verdict<double> &verdict, const Candidates &candidates) {
    if (!(verdict.index >= 1.0)) return false;
    const Index place = count_up(candidates.count(0));
    candidates.marked(place) = k;
    candidates.mode(place) = Index(verdict.mode);
    put_shared(candidates.any(0), Index(1));
    return true;
}
// Calls on_failure() where beam k is marked and fails.
template <class Criterion, class OnFailure>
BONDEM_INLINE void judge_one(Index k, const DeviceSpan &span, const Moving &all, const Beams &beams,
                             const Strengths &strengths, const BondMarks &marks, const Candidates &candidates,
                             OnFailure on_failure) {
    if (marks.mark(k) == 0 || clock_of(span).first || !(beams.integrity(k) > 0.0)) return;
    if (list_failing(k, verdict_of<Criterion>(all.pose.data, beams, strengths, k), candidates)) on_failure();
}
BONDEM_INLINE void hold_ends(const Postponed &postponed, const Beams &beams, Index k) {
    hold(postponed, beams.i(k));
    hold(postponed, beams.j(k));
}
#define BONDEM_JUDGE(name, Criterion)                                                                                    \
    inline void judge_beam_by_##name(Index k, const DeviceSpan &span, const Moving &all, const Beams &beams,             \
                                     const Strengths &strengths, const BondMarks &marks, const Candidates &candidates,   \
                                     const Postponed &postponed) {                                                       \
        judge_one<Criterion>(k, span, all, beams, strengths, marks, candidates,                                          \
                             [&] { hold_ends(postponed, beams, k); });                                                   \
    }
BONDEM_JUDGE(peripheral_stress, PeripheralStress)
BONDEM_JUDGE(mohr_coulomb, MohrCoulomb)
BONDEM_JUDGE(linear_sum, LinearSum)
BONDEM_JUDGE(ellipse, Elliptic)
#undef BONDEM_JUDGE

// Sorts the bonds that fail by their numbers.
inline void sort_failing(Index, const Candidates &candidates) {
    if (!any_fails(candidates)) return;
    sort_by_heap(candidates.count(0), [&](Index e) { return candidates.marked(e); }, [&](Index a, Index b) {
        exchange(candidates.marked(a), candidates.marked(b));
        exchange(candidates.mode(a), candidates.mode(b));
    });
}

// ---- elements that are postponed, number e of the list

inline void keep_gathered_sum(Index e, const StepCut &cut, const BondsOfElements &bonds, const LoadsOfBonds &from,
                              const Postponed &postponed) {
    const Short p = cut.ready(e);
    if (is_held(postponed, p)) row_at(postponed.kept.data, p) = gathered({}, p, bonds, from);
}
inline void keep_sum(Index e, const StepCut &cut, const Postponed &postponed) {
    const Short p = cut.ready(e);
    if (is_held(postponed, p)) row_at(postponed.kept.data, p) = row_at(cut.sums.data, cut.ready_row(e));
}
inline void keep_dashed_sum(Index e, const StepCut &cut, const Dashpots &dashpots, const Postponed &postponed) {
    const Short p = cut.ready(e);
    if (is_held(postponed, p))
        row_at(dashpots.sums.data, Short(postponed.first_row + p)) = row_at(dashpots.sums.data, cut.ready_row(e));
}

inline void withdraw_all_dashpots(Index, const DeviceSpan &span, const Moving &all, const Beams &beams,
                                  const Dashpots &dashpots, const Candidates &candidates, const Postponed &postponed) {
    withdraw_dashpots(turn_of(span, 0), all, beams, dashpots, candidates, postponed);
}
inline void break_all_beams(Index, const DeviceSpan &span, const Moving &all, const Beams &beams, const BeamIntegrity &state,
                            const Candidates &candidates, const Postponed &postponed, const EventLog &log) {
    break_beams(turn_of(span, 0), all, beams, state, candidates, postponed, log);
}

// A postponed element finds its acceleration by the sum that is kept, and opens the next step if it continues.
template <class Boundary, class Resisted>
BONDEM_INLINE void resume(const DeviceSpan &span, const Moving &all, const Postponed &postponed, Index p,
                          const Boundary &row, const Resisted &resistance, Index r) {
    Clock still = clock_of(span);
    still.dt = still.finish = still.begin = still.extra = 0.0;
    still.goes_on = 0;
    One one(p);
    one.row = Short(postponed.first_row + p);  // of the sums of its dashpots
    move(one, still, all, Wrench<double>(gather(postponed.kept.data, one.element)), row, resistance, r);
    if (clock_of(span).goes_on) open_one(p, clock_of(span), all, row);
}
inline void resume_free(Index e, const DeviceSpan &span, const Moving &all, const StepCut &cut, const Postponed &postponed) {
    const Index p = cut.ready(e);
    if (is_held(postponed, p)) resume(span, all, postponed, p, NoRow{}, NoRow{}, -1);
}
inline void resume_resisted(Index e, const DeviceSpan &span, const Moving &all, const StepCut &cut,
                            const Resistance &resistance, const Postponed &postponed) {
    const Index p = cut.ready(e);
    if (is_held(postponed, p)) resume(span, all, postponed, p, NoRow{}, resistance, -1);
}
inline void resume_row(Index h, const DeviceSpan &span, const Moving &all, const StepCut &cut, const Rows &rows,
                       const Postponed &postponed) {
    const Index p = cut.ready(cut.held(0) + h), r = rows.of(p);
    if (is_held(postponed, p)) resume(span, all, postponed, p, BoundaryRow(rows, r), NoRow{}, r);
}
inline void resume_resisted_row(Index h, const DeviceSpan &span, const Moving &all, const StepCut &cut, const Rows &rows,
                                const Resistance &resistance, const Postponed &postponed) {
    const Index p = cut.ready(cut.held(0) + h), r = rows.of(p);
    if (is_held(postponed, p)) resume(span, all, postponed, p, BoundaryRow(rows, r), resistance, r);
}
inline void reopen_work_of_body(Index p, const DeviceSpan &span, const Moving &all, const BodyForces &body,
                                const Postponed &postponed) {
    if (is_held(postponed, p) && clock_of(span).goes_on) open_body_work(turn_of(span, p), all, body);
}
inline void release_element(Index p, const Candidates &candidates, const Postponed &postponed) {
    if (any_fails(candidates)) postponed.held(p) = 0;
}
inline void end_all_failures(Index, const Candidates &candidates) {
    if (any_fails(candidates)) end_failures(candidates);
}
inline void write_released_energy(Index, const DeviceSpan &span, const EventLog &log, const HistoryRows &history) {
    history.record(clock_of(span).record, of_fracture) = log.released(0);
}

}  // namespace bondem
