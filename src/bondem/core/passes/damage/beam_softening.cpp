// Passes over beams that soften in a step (`laws/beam_softening.hpp`).
//
// A portion is a range of consecutive bonds, and has a list of its softening beams. These beams lose integrity before
// the forces of a step are computed. The pass over all beams then computes their forces, with the present integrity,
// and with the full stiffness for pressure. A beam that reaches its strength in this pass softens at once, so that
// its force never exceeds its strength. Such a beam is added to a list at the end of the step, and postpones the
// motion of no element, because its force does not jump.
#include "softening_beam.hpp"

#include "../../ledger.hpp"
#include "../../registered.hpp"

namespace bondem {

// Lowers the integrity of the softening beams of a portion, before forces are computed.
void soften_beams(const Range &range, const Moving &all, const Beams &beams, const SofteningBounds &bounds,
                  const SofteningBeams &soft) {
    const Index q = range.block, last = range.first + soft.number(q);
    if (last == range.first) return;
    ExactSum lost = {};
    for (Index e = range.first; e < last; e++)
        lost.add(soften_beam(range.clock, all, beams, bounds, soft, soft.listed(e)));
    part_broken(bounds, soft, q);
    exact_sum(soft.lost, 0).add_shared(lost);
}
BONDEM_PASS(soften_beams, of_bonds, "ends motion pose")

void log_softened_beams(const Range &range, const Moving &all, const Beams &beams, const SofteningBeams &soft,
                        const EventLog &log) {
    log.written(log_count::before) = log.written(log_count::events);
    if (soft.rows(0) == 0) return;
    log.released(0) += exact_sum(soft.lost, 0).take();
    for (Index q = 0; q < soft.number.size(); q++) {
        for (Index e = 0; e < soft.parted(q); e++) {
            const double *row = &soft.row(soft.listed(q * bonds_of_portion + soft.number(q) + e), 0);
            const Index k = Index(row[soft_column::bond]);
            const Vector d = ends_of(all.pose.data, beams, k).branch;
            const double share = beams.lever(k) / beams.length(k);
            log_event(range.clock, log, k, Index(row[soft_column::mode]),
                      {row[soft_column::spent], length(d) - beams.length(k), plus(centre(all.pose.data, beams.i(k)), share, d),
                       double(range.clock.step) - row[soft_column::began]});
        }
        soft.parted(q) = 0;
    }
}
BONDEM_PASS(log_softened_beams, of_events, "ends pose")

void begin_softening(const Range &range, const Candidates &candidates, const SofteningBounds &bounds, const SofteningBeams &soft,
                     const EventLog &log) {
    if (!any_fails(candidates)) return;
    ExactSum lost = {};
    for_each_failing(candidates, [&](Index k, Index mode) {
        const Index c = soft.rows(0)++, q = k / bonds_of_portion;
        const double *const onset = &bounds.onset(k, 0), spent = onset[onset_column::spent];
        const double all[7] = {double(k), onset[onset_column::first], onset[onset_column::last], onset[onset_column::rate],
                               spent, double(mode), double(range.clock.step)};
        for (Index column = 0; column < 7; column++) soft.row(c, column) = all[column];
        soft.listed(q * bonds_of_portion + soft.number(q)++) = c;
        bounds.limit(k) = float(infinity);
        lost.add(spent);
    });
    log.released(0) += lost.value();
    end_failures(candidates);
}
BONDEM_PASS(begin_softening, of_events, "")

void sum_pressed_energies(const Range &range, const Moving &all, const Beams &beams, const SofteningBounds &bounds,
                          const Ledger &ledger) {
    add_up(ledger, history_column::normal, range.first, range.last, [&](Index k) {
        if (bounds.press(k) == 0.0) return 0.0;
        const double pressed = positive(beams.length(k) - length(ends_of(all.pose.data, beams, k).branch));
        return 0.5 * bounds.press(k) * pressed * pressed;
    });
}
BONDEM_PASS(sum_pressed_energies, of_bonds, "ends pose")

void write_crushing_of_beams(const Range &range, const SofteningBounds &bounds, const SofteningBeams &soft, const EventLog &log,
                             const HistoryRows &history) {
    ExactSum sum = {};
    for (Index c = 0; c < soft.rows(0); c++) sum.add(crushed_by_beam(bounds, soft, c));
    history.record(range.clock.record, history_column::crushing) = sum.value() - log.crushed(0);
}
BONDEM_PASS(write_crushing_of_beams, of_rows, "")

}  // namespace bondem
