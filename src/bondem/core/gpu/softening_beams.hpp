// Beams that soften, on a GPU, in the same stages as on the CPU (`passes/damage/beam_softening.cpp`).
//
// Softening beams are in lists, one per range of bonds. The thread of a listed beam lowers its integrity and adds its
// dissipation to an exact sum. The thread of a list moves broken beams to its end. The thread of any beam computes
// its loads, and starts to soften a beam that has reached its criterion, before loads are added to elements. A single
// thread logs broken beams, and adds beams that have started to soften to the lists, in the same order as the CPU.
#pragma once
#include "../passes/contacts/handover.hpp"
#include "../passes/damage/softening_beam.hpp"
#include "breakage.hpp"
#include "contacts.hpp"

namespace bondem {

// ---- integrity

// Softens the beam of the row at place e of the lists.
inline void soften_listed(Index e, const DeviceSpan &span, const Moving &all, const Beams &beams,
                          const SofteningBounds &bounds, const SofteningBeams &soft) {
    const Index q = e / bonds_of_portion;
    if (e - q * bonds_of_portion >= soft.number(q)) return;
    const Index c = soft.listed(e);
    exact_sum(soft.lost, 0).add_shared(soften_beam(clock_of(span), all, beams, bounds, soft, c));
    if (has_broken(bounds, soft, c)) put_shared(soft.parted(q), Index(1));
}
inline void end_portion_of_softening(Index q, const SofteningBounds &bounds, const SofteningBeams &soft) {
    if (soft.parted(q) != 0) part_broken(bounds, soft, q);
}
constexpr auto log_all_softened = once<log_softened_beams>;

// ---- forces, with the pressure on the softened part of a beam

BONDEM_INLINE void put_pressed(Index k, const Moving &all, const Beams &beams, BeamLoads<double> loads,
                               const LoadsOfBonds &to, const SofteningBounds &bounds) {
    const Vector apart = ends_of(all.pose.data, beams, k).branch;
    loads.force = plus(loads.force, bounds.press(k), pressure_on(apart, beams.length(k)));
    put(to, k, loads);
}
inline void load_softening_beam(Index k, const Moving &all, const Beams &beams, const LoadsOfBonds &to,
                                const SofteningBounds &bounds, const BondMarks &marks) {
    const BeamLoads<double> loads = loads_of(k, all, beams, Own{beams});
    mark_one(k, loads, bounds, marks);
    put_pressed(k, all, beams, loads, to, bounds);
}
inline void load_softening_uniform_beam(Index k, const Moving &all, const Beams &beams, const UniformBeams &uniform,
                                        const LoadsOfBonds &to, const SofteningBounds &bounds, const BondMarks &marks) {
    const BeamLoads<double> loads = loads_of(k, all, beams, all_uniform(uniform));
    mark_one(k, loads, bounds, marks);
    put_pressed(k, all, beams, loads, to, bounds);
}
// Starts the softening of beam k if it is marked and reaches its criterion, and scales its loads by its integrity.
template <class Criterion>
BONDEM_INLINE void begin_one(Index k, const DeviceSpan &span, const Moving &all, const Beams &beams, const LoadsOfBonds &to,
                             const SofteningBounds &bounds, const BondMarks &marks, const Candidates &candidates) {
    const Clock clock = clock_of(span);
    if (marks.mark(k) == 0 || clock.first || !(beams.integrity(k) > 0.0)) return;
    if (!list_failing(k, begin_beam<Criterion>(all, beams, bounds, clock.dt, k), marks, candidates)) return;
    const double left = beams.integrity(k);
    const BeamLoads<double> whole = loads_in(to, k);
    put_pressed(k, all, beams, {left * whole.force, left * whole.on_i, left * whole.on_j}, to, bounds);
}
#define BONDEM_BEGIN(_, name, Criterion) constexpr auto begin_beam_by_##name = as<&begin_one<Criterion>>;
BONDEM_SOFTENING_CRITERIA(BONDEM_BEGIN, )
#undef BONDEM_BEGIN

// ---- beams that have begun

constexpr auto begin_all_softening = once<begin_softening>;

// ---- contact where beams have broken

constexpr auto release_all_pressure = once<release_pressure>;
constexpr auto begin_all_softened_contacts = once<begin_softened_contacts>;

// ---- sums for the history

constexpr auto sum_portion_of_pressure = portion_of_bonds<sum_pressed_energies>;
constexpr auto write_all_crushing_of_beams = once<write_crushing_of_beams>;

}  // namespace bondem
