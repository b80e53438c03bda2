// One beam that softens: its row, the integrity that it loses in a step, and the list of a portion of bonds. The passes of
// the CPU and a thread of a device call these functions.
#pragma once
#include "../../laws/beam_softening.hpp"
#include "../../tables/beam_softening_tables.hpp"
#include "../beams/bonds.hpp"

namespace bondem {

// Columns of a row of a beam that has begun to soften.
namespace soft_column {
enum : Index { bond, first, last, rate, spent, mode };
}
// Integrity below which a beam has broken.
constexpr double broken_integrity = 1e-9;

// Energy of beam k as if it were whole.
inline OpeningEnergy<double> opening_energy_of(const double *pose, const Beams &beams, Index k) {
    const Ends<double> ends = ends_of(pose, beams, k);
    const BeamShape<double> shape = shape_of<double>(beams, k);
    const BeamEnergy<double> energy = beam_energy(ends, shape, stiffness_of(beams, k, 1.0), beams.ks(k), beams.lever(k));
    return opening_energy(energy, length(ends.branch) - shape.length);
}
// Keeps the energy of a beam that is found to begin.
inline void keep_onset(const double *pose, const Beams &beams, const SofteningBeams &soft, Index k) {
    const OpeningEnergy<double> energy = opening_energy_of(pose, beams, k);
    soft.onset(k, 0) = energy.opening;
    soft.onset(k, 1) = energy.sliding;
}
inline Index bond_of_row(const SofteningBeams &soft, Index c) { return Index(soft.row(c, soft_column::bond)); }

// Lets the beam of row c lose integrity where `changes`; returns the energy dissipated [J].
//
// The energy is s times a square of the opening, whose work the schemes count by the trapezoidal rule: the energy
// released is -Δs times the product of the openings before and after, the root of the product of Y before and after.
inline double soften_beam(const double *pose, const Beams &beams, const BeamIntegrity &state, const SofteningBounds &bounds,
                          const SofteningBeams &soft, Index c, bool changes) {
    double *const row = &soft.row(c, 0);
    const Index k = bond_of_row(soft, c);
    const OpeningEnergy<double> energy = opening_energy_of(pose, beams, k);
    const double s = state.integrity(k), rate = energy.opening + energy.sliding;
    double left = s;
    if (changes) {
        left = softened(s, root(rate), row[soft_column::first], row[soft_column::last]);
        if (left < broken_integrity) left = 0.0;
    }
    const double spent = root(row[soft_column::rate] * rate) * (s - left);
    row[soft_column::rate] = rate;
    row[soft_column::spent] += spent;
    if (left < s) {
        state.integrity(k) = left;
        if (state.hold.size() > 0) state.hold(k) = left / beams.length(k);
        bounds.press(k) = (1.0 - left) * beams.kn(k);
    }
    return spent;
}
inline bool has_broken(const BeamIntegrity &state, const SofteningBeams &soft, Index c) {
    return !(state.integrity(bond_of_row(soft, c)) > 0.0);
}

// Moves the rows of portion q that have broken behind the others, each kind in its order.
inline void part_broken(const BeamIntegrity &state, const SofteningBeams &soft, Index q) {
    const Index first = q * bonds_of_portion, count = soft.number(q);
    Index kept = 0;
    for (Index e = 0; e < count; e++) {
        const Index c = soft.listed(first + e);
        if (has_broken(state, soft, c)) continue;
        for (Index place = e; place > kept; place--) soft.listed(first + place) = soft.listed(first + place - 1);
        soft.listed(first + kept++) = c;
    }
    soft.number(q) = kept;
    soft.parted(q) = count - kept;
}

}  // namespace bondem
