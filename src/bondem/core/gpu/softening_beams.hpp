// Beams that soften, on a device: a thread lets one row of the lists lose integrity, one thread a portion adds up what its
// rows have dissipated, a thread loads one beam, which begins to soften there, and one thread logs beams that have broken
// and begins the rows.
//
// The stages are those of the CPU (`passes/damage/beam_softening.cpp`), in the same order of rows and bonds.
#pragma once
#include "../passes/contacts/handover.hpp"
#include "../passes/damage/beam_softening.hpp"
#include "../passes/damage/softening_beam.hpp"
#include "breakage.hpp"
#include "contacts.hpp"

namespace bondem {

// ---- integrity

// The row at place e of the lists.
inline void soften_listed(Index e, const DeviceSpan &span, const Moving &all, const Beams &beams,
                          const SofteningBounds &bounds, const SofteningBeams &soft, const SofteningLosses &losses) {
    const Index q = e / bonds_of_portion;
    if (e - q * bonds_of_portion >= soft.number(q)) return;
    const Index c = soft.listed(e);
    losses.lost(e) = soften_beam(clock_of(span), all, beams, bounds, soft, c);
    if (has_broken(bounds, soft, c)) put_shared(soft.parted(q), Index(1));
}
inline void end_portion_of_softening(Index q, const SofteningBounds &bounds, const SofteningBeams &soft,
                                     const SofteningLosses &losses) {
    const Index first = q * bonds_of_portion, last = first + soft.number(q);
    double lost = 0.0;
    for (Index e = first; e < last; e++) lost += losses.lost(e);
    soft.lost(q) = lost;
    if (soft.parted(q) != 0) part_broken(bounds, soft, q);
}
inline void log_all_softened(Index, const DeviceSpan &span, const Moving &all, const Beams &beams, const SofteningBeams &soft,
                             const EventLog &log) {
    log_softened_beams(turn_of(span, 0), all, beams, soft, log);
}

// ---- forces, with the pressure on the softened part of a beam

template <class Criterion>
BONDEM_INLINE void put_softening(Index k, const DeviceSpan &span, const Moving &all, const Beams &beams,
                                 BeamLoads<double> loads, const LoadsOfBonds &to, const SofteningBounds &bounds,
                                 const BondMarks &marks, const Candidates &candidates) {
    mark_one(k, loads, bounds, marks);
    const Clock clock = clock_of(span);
    if (marks.mark(k) != 0 && !clock.first && beams.integrity(k) > 0.0) {
        const Verdict<double> verdict = begin_beam<Criterion>(all, beams, bounds, clock.dt, k);
        if (list_failing(k, verdict, marks, candidates)) {
            const double left = beams.integrity(k);
            loads = {left * loads.force, left * loads.on_i, left * loads.on_j};
        }
    }
    const Vector apart = ends_of(all.pose.data, beams, k).branch;
    loads.force = plus(loads.force, bounds.press(k), pressure_on(apart, beams.length(k)));
    put(to, k, loads);
}
#define BONDEM_LOAD(_, name, Criterion)                                                                                   \
    inline void load_beam_softening_by_##name(Index k, const DeviceSpan &span, const Moving &all, const Beams &beams,     \
                                              const LoadsOfBonds &to, const SofteningBounds &bounds,                      \
                                              const BondMarks &marks, const Candidates &candidates) {                     \
        put_softening<Criterion>(k, span, all, beams, loads_of(k, all, beams), to, bounds, marks, candidates);            \
    }                                                                                                                     \
    inline void load_alike_beam_softening_by_##name(Index k, const DeviceSpan &span, const Moving &all,                   \
                                                    const Beams &beams, const AlikeBeams &alike, const LoadsOfBonds &to,  \
                                                    const SofteningBounds &bounds, const BondMarks &marks,                \
                                                    const Candidates &candidates) {                                       \
        put_softening<Criterion>(k, span, all, beams, loads_of(k, all, beams, alike), to, bounds, marks, candidates);     \
    }
BONDEM_SOFTENING_CRITERIA(BONDEM_LOAD, )
#undef BONDEM_LOAD

// ---- beams that have begun

inline void begin_all_softening(Index, const DeviceSpan &span, const Candidates &candidates, const SofteningBounds &bounds,
                                const SofteningBeams &soft, const EventLog &log) {
    begin_softening(turn_of(span, 0), candidates, bounds, soft, log);
}

// ---- contact where beams have broken

inline void release_all_pressure(Index, const DeviceSpan &span, const EventLog &log, const SofteningBounds &bounds) {
    release_pressure(turn_of(span, 0), log, bounds);
}
inline void begin_all_softened_contacts(Index, const DeviceSpan &span, const Moving &all, const ContactConstants &c,
                                        const ContactPairs &pairs, const NearPairs &near, const EventLog &log,
                                        const ContactSums &to) {
    begin_softened_contacts(turn_of(span, 0), all, c, pairs, near, log, to);
}

// ---- what the history needs

inline void sum_portion_of_pressure(Index b, const DeviceSpan &span, const Moving &all, const Beams &beams,
                                    const SofteningBounds &bounds, const Portions &portions) {
    sum_pressed_energies(portion_of(span, b, bonds_of_portion, span.m), all, beams, bounds, portions);
}
inline void write_all_crushing_of_beams(Index, const DeviceSpan &span, const SofteningBounds &bounds, const SofteningBeams &soft,
                                        const EventLog &log, const HistoryRows &history) {
    double sum = 0.0;
    for (Index c = 0; c < soft.begun(0); c++) sum += crushed_by_beam(bounds, soft, c);
    history.record(clock_of(span).record, of_crushing) = sum - log.crushed(0);
}

}  // namespace bondem
