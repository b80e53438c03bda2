// Beams that soften in a step (`laws/beam_softening.hpp`).
//
// Those that have begun stand in lists, one per portion of bonds, and lose integrity before the forces of a step. They
// stay in the pass over all beams, with the integrity that they have, and carry pressure there by a stiffness of their own.
// A beam that reaches its strength is found as one that breaks is, and listed at the end of the step. It holds no element, as
// its force does not jump.
#include "beam_softening.hpp"

#include "beam_verdicts.hpp"
#include "softening_beam.hpp"

namespace bondem {
namespace {

template <class Criterion>
void find_softening(const Turn &turn, const Moving &all, const Beams &beams, const Strengths &strengths,
                    const Candidates &candidates, const SofteningBeams &soft) {
    judge(
        turn, candidates, [&](Index k) { return beams.integrity(k) > 0.0; },
        [&](Index k) { return verdict_of<Criterion>(all.pose.data, beams, strengths, k); },
        [&](Index k) { keep_onset(all.pose.data, beams, soft, k); });
}

}  // namespace

void soften_beams(const Turn &turn, const Moving &all, const Beams &beams, const BeamIntegrity &state,
                  const SofteningBounds &bounds, const SofteningBeams &soft) {
    const Index q = turn.block, last = turn.first + soft.number(q);
    double lost = 0.0;
    for (Index e = turn.first; e < last; e++)
        lost += soften_beam(all.pose.data, beams, state, bounds, soft, soft.listed(e), !turn.clock.first);
    part_broken(state, soft, q);
    soft.lost(q) = lost;
}

void log_softened_beams(const Turn &turn, const Moving &all, const Beams &beams, const SofteningBeams &soft,
                        const EventLog &log) {
    log.written(1) = log.written(0);
    for (Index q = 0; q < soft.number.size(); q++) {
        log.released(0) += soft.lost(q);
        for (Index e = 0; e < soft.parted(q); e++) {
            const double *row = &soft.row(soft.listed(q * bonds_of_portion + soft.number(q) + e), 0);
            const Index k = Index(row[soft_column::bond]);
            const Vector d = ends_of(all.pose.data, beams, k).branch;
            const double *x = &all.pose(beams.i(k), 0), share = beams.lever(k) / beams.length(k);
            log_event(turn.clock, log, k, Index(row[soft_column::mode]),
                      {row[soft_column::spent], length(d) - beams.length(k), plus(Vector{x[0], x[1], x[2]}, share, d)});
        }
        soft.parted(q) = 0;
    }
}

#define BONDEM_FIND(_, name, Criterion)                                                                                \
    void find_softening_by_##name(const Turn &turn, const Moving &all, const Beams &beams, const Strengths &strengths, \
                                  const Candidates &candidates, const SofteningBeams &soft) {                          \
        find_softening<Criterion>(turn, all, beams, strengths, candidates, soft);                                      \
    }
BONDEM_SOFTENING_CRITERIA(BONDEM_FIND, )
#undef BONDEM_FIND

void begin_softening(const Turn &, const Candidates &candidates, const SofteningBounds &bounds, const SofteningBeams &soft) {
    if (!any_fails(candidates)) return;
    for_each_failing(candidates, [&](Index k, Index mode) {
        const Index c = soft.begun(0)++, q = k / bonds_of_portion;
        const OpeningEnergy<double> energy = {soft.onset(k, 0), soft.onset(k, 1)};
        const double rate = energy.opening + energy.sliding, first = root(rate);
        const double last = last_opening(energy, soft.tear(k), soft.slide(k), first);
        const double all[6] = {double(k), first, last, rate, 0.0, double(mode)};
        for (Index column = 0; column < 6; column++) soft.row(c, column) = all[column];
        soft.listed(q * bonds_of_portion + soft.number(q)++) = c;
        bounds.limit(k) = float(infinity);
    });
    end_failures(candidates);
}

void sum_pressed_energies(const Turn &turn, const Moving &all, const Beams &beams, const SofteningBounds &bounds,
                          const Portions &portions) {
    double sum = 0.0;
    for (Index k = turn.first; k < turn.last; k++) {
        if (bounds.press(k) == 0.0) continue;
        const double pressed = at_least_zero(beams.length(k) - length(ends_of(all.pose.data, beams, k).branch));
        sum += 0.5 * bounds.press(k) * pressed * pressed;
    }
    portions.bonds(turn.block, 0) += sum;
}

}  // namespace bondem
