// The damage pipeline: failure of bonds (beams, facets of cells, or bonds of the non-local law) in an explicit step.
//
// Bonds fail at the end of a step. The velocity of an element changes twice per step: at the end of the step, by the
// forces of the new positions, and as the next step begins (`passes/motion/moving.hpp`). The two elements of a
// failing bond end the step with the full force of the bond, and begin the next step without this force. The energy
// of a bond is therefore released between two steps, and the energy balance is as exact as the time integration.
//
// A step has these stages (`bondem/interactions/step_part.py`). A block is a range of consecutive bonds:
//
//     loads    The pass over forces compares a size of the load of each bond with its bound, block by block, and
//              lists (`Marks`) the few bonds that reach their bound.
//     judge    `judge` evaluates the criterion of the marked bonds of a block, index(k) → (index, mode), and keeps
//              those with index ≥ 1. `postpone(k)` postpones the elements that the failure changes.
//     divide   `postpone_elements` divides the elements of each block into those that continue, and postponed ones,
//              which end the step and do not begin the next. `keep_sums` keeps the sums of their forces.
//     apply    `remove` calls apply(k) → (energy, gap, place) for the bonds that fail, in their order. The call
//              subtracts the force of the bond from the kept sums of its ends, and sets the integrity. `remove` logs
//              the event, and adds its energy to the energy released in the run. A further pass may follow for each
//              of these bonds (`for_each_event`): contact where its ends press on each other, which adds to the kept
//              sums, and stores a part of the energy.
//     resume   `list_postponed` lists all postponed elements, and ends the failures of the step. The passes of
//              motion, with a time step of 0, then find the acceleration of these elements and begin their next step.
//
// Each criterion and each kind of bond provide two functions:
//
//     index(k) → Verdict<double>     at the poses of the step, before any element postponed by k moves
//     apply(k) → Removal             at the same poses, on one thread
//
// Beams: `beam_failure.cpp`. Facets of cells (`passes/cells/facet_failure.cpp`) postpone the neighbours of both cells
// too, as their stresses change. Bonds of the non-local law (`passes/non_local/pair_failure.cpp`) postpone their
// ends. Softening beams postpone no element, as their force does not jump.
//
// No bit depends on threads, on blocks or on pauses: failure is decided bond by bond, from the poses alone.
#pragma once
#include "../../exact_sum.hpp"
#include "../../laws/criteria/loads.hpp"
#include "../../select.hpp"
#include "../../steps.hpp"
#include "../../tables/damage_tables.hpp"
#include "../../vector3.hpp"

namespace bondem {

// Result of the removal of a bond.
struct Removal {
    double energy;  // released [J]
    double gap;  // how far it is open [m]
    Vector place;  // [m]
    double opening_steps = undefined;  // steps since the onset of softening, NaN without
    double pressed = infinity;  // largest overlap with which a contact may take over [m]
};

// ---- marks

#if defined(BONDEM_LANES)

BONDEM_INLINE Lanes limits_of(const float *limit) {
    typedef float Floats __attribute__((vector_size(lanes * 4), aligned(4)));
    return __builtin_convertvector(*reinterpret_cast<const Floats *>(limit), Lanes);
}
// List of a block, to which a pass over its bonds writes those that reach their bounds.
class Marks {
  public:
    template <class Bounds>
    Marks(const Bounds &bounds, const Candidates &candidates, const Range &range)
        : limit(bounds.limit.data), of_force(bounds.of_force), of_moment(bounds.of_moment),
          first(candidates.marked.data + candidates.begin(range.block)), next(first) {}

    // Calls on(n) for each bond k + n, n from `known` on, whose size reaches its bound.
    template <class On>
    BONDEM_INLINE void for_each_near(Index k, int known, Lanes force_squared, Lanes moment_squared, On on) const {
        const Lanes size = of_force * force_squared + of_moment * moment_squared, bound = limits_of(limit + k);
        if (__builtin_expect(any(size >= bound), 0))
            for (int n = known; n < lanes; n++)
                if (size[n] >= bound[n]) on(n);
    }
    // Marks the bonds of a group that reach their bounds.
    BONDEM_INLINE void mark(Index k, int known, Lanes force_squared, Lanes moment_squared) {
        for_each_near(k, known, force_squared, moment_squared, [&](int n) { put(k + n); });
    }
    void put(Index k) { *next++ = k; }
    Index count() const { return next - first; }

  private:
    const float *const limit;
    const double of_force, of_moment;
    Index *const first, *next;
};

#endif

// ---- evaluation

// Postpones an element at the end of the step. Several threads may postpone an element that domains share.
inline void postpone_element(const Postponed &postponed, Index element, Byte as = 1) {
    put_shared(postponed.flag(element), as);
}
inline void postpone_ends(const Postponed &postponed, const Beams &beams, Index k) {
    postpone_element(postponed, beams.i(k));
    postpone_element(postponed, beams.j(k));
}
inline bool is_postponed(const Postponed &postponed, Index element) {
    return get_shared(postponed.flag(element)) != 0;
}
inline bool any_fails(const Candidates &candidates) { return get_shared(candidates.any(0)) != 0; }

template <class Strong> inline Coefficients<double> coefficients_of(const Strong &strengths, Index k) {
    const double *c = &strengths.coefficient(k, 0);
    return {c[0], c[1], c[2], c[3]};
}
// Keeps the marked bonds of a block that fail. No bond fails before the first step of a call of the core.
//
//     may_fail(k)    true for an unbroken bond
//     index(k)       index and mode of the bond
//     postpone(k)    postpones the elements that the failure of the bond changes
template <class MayFail, class IndexOf, class Postpone>
inline void judge(const Range &range, const Candidates &candidates, MayFail may_fail, IndexOf index, Postpone postpone) {
    const Index first = candidates.begin(range.block);
    Index failing = 0;
    if (!range.clock.first)
        for (Index e = first; e < first + candidates.count(range.block); e++) {
            const Index k = candidates.marked(e);
            if (!may_fail(k)) continue;
            const Verdict<double> verdict = index(k);
            if (!(verdict.index >= 1.0)) continue;
            candidates.marked(first + failing) = k;
            candidates.mode(first + failing) = Index(verdict.mode);
            failing++;
            postpone(k);
        }
    candidates.count(range.block) = failing;
    if (failing > 0) put_shared(candidates.any(0), Index(1));
}

// ---- removal

// Calls on(k, mode) for the bonds that fail in this step, in their order.
template <class On> inline void for_each_failing(const Candidates &candidates, On on) {
    if (!any_fails(candidates)) return;
    for (Index b = 0; b < candidates.count.size(); b++)
        for (Index e = candidates.begin(b); e < candidates.begin(b) + candidates.count(b); e++)
            on(candidates.marked(e), candidates.mode(e));
}
inline bool any_event(const EventLog &log) { return log.written(log_count::before) < log.written(log_count::events); }
// Calls on(k, event) for the bonds that have failed in this step; event is the number of a row of the log.
template <class On> inline void for_each_event(const EventLog &log, On on) {
    for (Index event = log.written(log_count::before); event < log.written(log_count::events); event++)
        on(Index(log.event(event, event_column::bond)), event);
}

inline void write_event(const Clock &clock, const EventLog &log, Index event, Index k, Index mode, const Removal &removal) {
    double *const row = &log.event(event, 0);
    const Vector x = removal.place;
    const double all[event_column::count] = {clock.time, double(clock.step), double(k), double(mode), removal.gap, removal.energy,
                            x.x, x.y, x.z, removal.opening_steps};
    for (Index c = 0; c < event_column::count; c++) row[c] = all[c];
    log.pressed(event) = removal.pressed;
}
inline void log_event(const Clock &clock, const EventLog &log, Index k, Index mode, const Removal &removal) {
    write_event(clock, log, log.written(log_count::events)++, k, mode, removal);
}

// Removes the bonds that fail in this step by apply(k) → Removal, and logs their events.
template <class Apply>
inline void remove(const Range &range, const Candidates &candidates, const EventLog &log, Apply apply) {
    log.written(log_count::before) = log.written(log_count::events);
    if (!any_fails(candidates)) return;
    ExactSum released = {};
    for_each_failing(candidates, [&](Index k, Index mode) {
        const Removal removal = apply(k);
        log_event(range.clock, log, k, mode, removal);
        released.add(removal.energy);
    });
    log.released(0) += released.value();
}

// Ends the failures of a step: empties the lists of failing bonds.
inline void end_failures(const Candidates &candidates) {
    for (Index b = 0; b < candidates.count.size(); b++) candidates.count(b) = 0;
    candidates.any(0) = 0;
}

// Subtracts a force and a torque, each times a number, from the kept sums of an element.
inline void take_off(double *row, double sign, Vector force, double turning, Vector torque) {
    for (Index c = 0; c < 3; c++) {
        row[c] -= sign * force[c];
        row[4 + c] -= turning * torque[c];
    }
}

}  // namespace bondem
