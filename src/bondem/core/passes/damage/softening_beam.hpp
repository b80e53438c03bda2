// One beam that softens: onset, row of data, loss of integrity, and its place in a list of softening beams.
#pragma once
#include "../../laws/beam_softening.hpp"
#include "../../tables/beam_softening_tables.hpp"
#include "beam_verdicts.hpp"
#include "integrity.hpp"

namespace bondem {

// Further columns of a beam that begins to soften in this step.
namespace onset_column {
enum : Index { first, last, rate, spent };
}
// Integrity below which a beam has broken.
constexpr double broken_integrity = 1e-9;

inline Ends<double> ends_of(const Row<double> &i, const Row<double> &j, const Beams &beams) {
    return ends_of(i, j, beams.period.data);
}
// Parts of the energy of beam k at full integrity that opening and sliding release [J]; pressure releases none.
__attribute__((noinline)) inline OpeningEnergy<double> opening_energy_of(const Ends<double> &ends, const Beams &beams, Index k) {
    const BeamShape<double> shape = shape_of<double>(beams, k);
    const BeamEnergy<double> energy = beam_energy(ends, shape, stiffness_of(beams, k, 1.0), beams.ks(k), beams.lever(k));
    return opening_energy(energy, length(ends.branch) - shape.length);
}
inline double rate_of(const OpeningEnergy<double> &energy) { return energy.opening + energy.sliding; }
inline Index bond_of_row(const SofteningBeams &soft, Index c) { return Index(soft.row(c, soft_column::bond)); }

// Product of the openings λ of beam k before and after the last step, in which it has moved at its present velocity
// [J]; below zero where it was pressed before. `rate` is Y now.
//
// Schemes count work by the trapezoidal rule. A step in which s falls by Δs so loses Δs (Y - ½ ∇Y·Δx): Δs λ λ' on a
// straight path.
__attribute__((noinline)) inline double opened_product(const Moving &all, const Beams &beams, const Ends<double> &ends, double rate, double dt, Index k) {
    const Motion<double> i(gather(all.motion.data, beams.i(k))), j(gather(all.motion.data, beams.j(k)));
    const BeamLoads<double> loads = beam_loads(ends, shape_of<double>(beams, k), stiffness_of(beams, k, 1.0));
    const Vector force = minus(loads.force, beams.kn(k), pressure_on(ends.branch, beams.length(k)));
    return rate + 0.5 * dt * (dot(force, j.v - i.v) + dot(loads.on_i, i.w) + dot(loads.on_j, j.w));
}
inline void put_softened(const Beams &beams, const SofteningBounds &bounds, Index k, double s) {
    put_integrity_of_beam(bounds, k, s, beams.length(k));
    bounds.press(k) = (1.0 - s) * beams.kn(k);
}

// Lowers the integrity of the beam of row c, except before the first step of a call; returns the dissipation [J].
inline double soften_beam(const Clock &clock, const Moving &all, const Beams &beams, const SofteningBounds &bounds,
                          const SofteningBeams &soft, Index c) {
    double *const row = &soft.row(c, 0);
    const Index k = bond_of_row(soft, c);
    const Ends<double> ends = ends_of(all.pose.data, beams, k);
    const double s = bounds.integrity(k), before = row[soft_column::rate], rate = rate_of(opening_energy_of(ends, beams, k));
    row[soft_column::rate] = rate;
    if (clock.first) return 0.0;
    double left = softened(s, {row[soft_column::first], row[soft_column::last]}, row[soft_column::spent], root(before), root(rate));
    if (left < broken_integrity) left = 0.0;
    if (left == s) return 0.0;
    const double spent = (s - left) * opened_product(all, beams, ends, rate, clock.dt, k);
    row[soft_column::spent] += spent;
    put_softened(beams, bounds, k, left);
    return spent;
}
// Dissipation of the beam of row c beyond its fracture energy [J].
inline double crushed_by_beam(const SofteningBounds &bounds, const SofteningBeams &soft, Index c) {
    const double *const row = &soft.row(c, 0);
    const Index k = bond_of_row(soft, c), mode = Index(row[soft_column::mode]);
    const double of_mode = mode == failure_mode::shear || mode == failure_mode::twisting ? bounds.slide(k) : bounds.tear(k);
    return most(row[soft_column::spent] - absorbed_energy(row[soft_column::first], row[soft_column::last], of_mode), 0.0);
}
inline bool has_broken(const SofteningBounds &bounds, const SofteningBeams &soft, Index c) {
    return !(bounds.integrity(bond_of_row(soft, c)) > 0.0);
}

// ---- onset

// Pose of an element a step ago: it has moved at its present velocity since then.
__attribute__((noinline)) inline Row<double> row_before(const Moving &all, Short element, double dt) {
    const Row<double> now = gather(all.pose.data, element);
    const Motion<double> moving(gather(all.motion.data, element));
    const Vector back = -dt * moving.v;
    const Quaternion<double> q = turned(orientation(now), -dt * moving.w);
    return {{now.column[0] + back.x, now.column[1] + back.y, now.column[2] + back.z, now.column[3], q.w, q.x, q.y, q.z}};
}

// Index and mode of a beam at given ends. Not inlined: two inlined evaluations would need twice the registers.
template <class Criterion>
__attribute__((noinline)) Verdict<double> verdict_apart(const Ends<double> &ends, const Beams &beams,
                                                        const SofteningBounds &bounds, Index k) {
    return verdict_at<Criterion>(ends, beams, bounds, k);
}

// Softens whole beam k if it has reached its criterion within the last step; returns index and mode.
//
// Within the step the index is taken to grow on a line, from 0 for a beam under pressure, and the criterion is
// reached where it is 1. A beam without remaining integrity keeps half of the least one, and breaks in the next step.
template <class Criterion>
inline Verdict<double> begin_beam(const Moving &all, const Beams &beams, const SofteningBounds &bounds, double dt, Index k) {
    const Ends<double> now = ends_of(all.pose.data, beams, k);
    const Verdict<double> verdict = verdict_apart<Criterion>(now, beams, bounds, k);
    if (!(verdict.index >= 1.0)) return verdict;
    const Ends<double> then = ends_of(row_before(all, beams.i(k), dt), row_before(all, beams.j(k), dt), beams);
    const double index = positive(verdict_apart<Criterion>(then, beams, bounds, k).index);
    const double share = index < 1.0 ? (1.0 - index) / (verdict.index - index) : 0.0;
    const OpeningEnergy<double> before = opening_energy_of(then, beams, k), after = opening_energy_of(now, beams, k);
    const auto between = [&](double a, double b) {
        const double opening = (1.0 - share) * root(a) + share * root(b);
        return opening * opening;
    };
    const OpeningEnergy<double> at_onset = {between(before.opening, after.opening), between(before.sliding, after.sliding)};
    const double first = root(rate_of(at_onset)), rate = rate_of(after);
    const double last = last_opening(at_onset, bounds.tear(k), bounds.slide(k), first);
    const double product = opened_product(all, beams, now, rate, dt, k);
    const double left = most(softened(1.0, {first, last}, 0.0, product / root(rate), root(rate)), 0.5 * broken_integrity);
    put_softened(beams, bounds, k, left);
    const double onset[4] = {first, last, rate, (1.0 - left) * product};
    for (Index column = 0; column < 4; column++) bounds.onset(k, column) = onset[column];
    return verdict;
}

// Moves the rows of broken beams of portion q after the others, each kind in its order.
inline void part_broken(const SofteningBounds &bounds, const SofteningBeams &soft, Index q) {
    const Index first = q * bonds_of_portion, count = soft.number(q);
    Index unbroken = 0;
    for (Index e = 0; e < count; e++) {
        const Index c = soft.listed(first + e);
        if (has_broken(bounds, soft, c)) continue;
        for (Index place = e; place > unbroken; place--) soft.listed(first + place) = soft.listed(first + place - 1);
        soft.listed(first + unbroken++) = c;
    }
    soft.number(q) = unbroken;
    soft.parted(q) = count - unbroken;
}

// ---- passes that the CPU and a device call

// Adds up the dissipation of all portions, and logs broken beams.
void log_softened_beams(const Range &range, const Moving &all, const Beams &beams, const SofteningBeams &soft,
                        const EventLog &log);
// Writes the rows of beams that have begun to soften in this step, and adds up their dissipation.
void begin_softening(const Range &range, const Candidates &candidates, const SofteningBounds &bounds,
                     const SofteningBeams &soft, const EventLog &log);
// Writes the energy that beams have released beyond their fracture energy in this run [J].
void write_crushing_of_beams(const Range &range, const SofteningBounds &bounds, const SofteningBeams &soft,
                             const EventLog &log, const HistoryRows &history);
// Adds the energy of the pressure on softened beams of a portion to their normal energy.
void sum_pressed_energies(const Range &range, const Moving &all, const Beams &beams, const SofteningBounds &bounds,
                          const Ledger &ledger);

}  // namespace bondem
