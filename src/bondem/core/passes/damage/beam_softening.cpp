// Beams that soften in a step (`laws/beam_softening.hpp`).
//
// Those that have begun stand in lists, one per portion of bonds, and lose integrity before the forces of a step. They
// stay in the pass over all beams, with the integrity that they have, and carry pressure there by a stiffness of their own.
// A beam that reaches its strength is found as one that breaks is, and listed at the end of the step. It holds no element, as
// its force does not jump.
#include "beam_softening.hpp"

#include "../../laws/beam_softening.hpp"
#include "beam_verdicts.hpp"

namespace bondem {
namespace {

// Columns of a row.
enum Column : Index { bond_column, first_column, last_column, rate_column, spent_column, mode_column };
// Integrity below which a beam has broken.
constexpr double broken = 1e-9;

// A beam as if it were whole.
struct WholeBeam {
    double extension;  // [m]
    OpeningEnergy<double> energy;
};
WholeBeam whole_beam(const double *pose, const Beams &beams, Index k) {
    const Ends<double> ends = ends_of(pose, beams, k);
    const BeamShape<double> shape = shape_of<double>(beams, k);
    const BeamEnergy<double> energy = beam_energy(ends, shape, stiffness_of(beams, k, 1.0), beams.ks(k), beams.lever(k));
    const double extension = length(ends.branch) - shape.length;
    return {extension, opening_energy(energy, extension)};
}

// Integrity of a beam that had s, at the rate Y; what it dissipates is added to `lost`.
//
// The energy is s times a square of the opening, whose work the schemes count by the trapezoidal rule: what is released is
// -Δs times the product of the openings before and after, the root of the product of Y before and after.
double lose_integrity(double *row, double s, double rate, bool changes, double &lost) {
    double left = s;
    if (changes) {
        left = softened(s, root(rate), row[first_column], row[last_column]);
        if (left < broken) left = 0.0;
    }
    const double spent = root(row[rate_column] * rate) * (s - left);
    row[rate_column] = rate;
    row[spent_column] += spent;
    lost += spent;
    return left;
}

template <class Criterion>
void find_softening(const Turn &turn, const Moving &all, const Beams &beams, const Strengths &strengths,
                    const Candidates &candidates, const SofteningBeams &soft) {
    judge(
        turn, candidates, [&](Index k) { return beams.integrity(k) > 0.0; },
        [&](Index k) { return verdict_of<Criterion>(all.pose.data, beams, strengths, k); },
        [&](Index k) {
            const OpeningEnergy<double> energy = whole_beam(all.pose.data, beams, k).energy;
            soft.onset(k, 0) = energy.opening;
            soft.onset(k, 1) = energy.sliding;
        });
}

}  // namespace

void soften_beams(const Turn &turn, const Moving &all, const Beams &beams, const BeamIntegrity &state,
                  const SofteningBounds &bounds, const SofteningBeams &soft) {
    const Index q = turn.block, first = turn.first, count = soft.number(q);
    Index kept = 0, parted = 0;
    Index gone[bonds_of_portion];
    double lost = 0.0;
    for (Index e = first; e < first + count; e++) {
        const Index c = soft.listed(e);
        double *const row = &soft.row(c, 0);
        const Index k = Index(row[bond_column]);
        const OpeningEnergy<double> energy = whole_beam(all.pose.data, beams, k).energy;
        const double s = state.integrity(k), rate = energy.opening + energy.sliding;
        const double left = lose_integrity(row, s, rate, !turn.clock.first, lost);
        if (left < s) {
            state.integrity(k) = left;
            if (state.hold.size() > 0) state.hold(k) = left / beams.length(k);
            bounds.press(k) = (1.0 - left) * beams.kn(k);
        }
        if (left > 0.0)
            soft.listed(first + kept++) = c;
        else
            gone[parted++] = c;
    }
    for (Index e = 0; e < parted; e++) soft.listed(first + kept + e) = gone[e];
    soft.number(q) = kept;
    soft.parted(q) = parted;
    soft.lost(q) = lost;
}

void log_softened_beams(const Turn &turn, const Moving &all, const Beams &beams, const SofteningBeams &soft,
                        const EventLog &log) {
    log.written(1) = log.written(0);
    for (Index q = 0; q < soft.number.size(); q++) {
        log.released(0) += soft.lost(q);
        for (Index e = 0; e < soft.parted(q); e++) {
            const double *row = &soft.row(soft.listed(q * bonds_of_portion + soft.number(q) + e), 0);
            const Index k = Index(row[bond_column]);
            const Vector d = ends_of(all.pose.data, beams, k).branch;
            const double *x = &all.pose(beams.i(k), 0), share = beams.lever(k) / beams.length(k);
            log_event(turn.clock, log, k, Index(row[mode_column]),
                      {row[spent_column], length(d) - beams.length(k), plus(Vector{x[0], x[1], x[2]}, share, d)});
        }
        soft.parted(q) = 0;
    }
}

void find_softening_by_peripheral_stress(const Turn &turn, const Moving &all, const Beams &beams, const Strengths &strengths,
                                         const Candidates &candidates, const SofteningBeams &soft) {
    find_softening<PeripheralStress>(turn, all, beams, strengths, candidates, soft);
}
void find_softening_by_mohr_coulomb(const Turn &turn, const Moving &all, const Beams &beams, const Strengths &strengths,
                                    const Candidates &candidates, const SofteningBeams &soft) {
    find_softening<MohrCoulomb>(turn, all, beams, strengths, candidates, soft);
}

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
