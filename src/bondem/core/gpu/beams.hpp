// Beams on a device: a thread computes one beam or dashpot, and writes the loads on its ends into `LoadsOfBonds`.
#pragma once
#include "../passes/beams/beam_report.hpp"
#include "../passes/damage/beam_removal.hpp"
#include "ranges.hpp"

namespace bondem {

BONDEM_INLINE void put(const LoadsOfBonds &to, Index k, const BeamLoads<double> &loads) {
    keep_loads(to.load.data, to.load.shape[1], k, loads);
}

BONDEM_INLINE BeamLoads<double> loads_of(Index k, const Moving &all, const Beams &beams) {
    const BeamStiffness<double> stiffness = stiffness_of(beams, k, beams.integrity(k));
    return beam_loads(ends_of(all.pose.data, beams, k), shape_of<double>(beams, k), stiffness);
}
// Loads of beam k in a model whose beams differ in length only.
BONDEM_INLINE BeamLoads<double> loads_of(Index k, const Moving &all, const Beams &beams, const UniformBeams &uniform) {
    const double h = uniform.per_length(k);
    const double AL = uniform.AL * h;
    const BeamStiffness<double> stiffness = {uniform.knL * h, AL, uniform.BL * h, AL, uniform.ktL * h};
    return beam_loads(ends_of(all.pose.data, beams, k), shape_of<double>(beams, k), stiffness);
}

inline void load_beam(Index k, const Moving &all, const Beams &beams, const LoadsOfBonds &to) {
    put(to, k, loads_of(k, all, beams));
}
inline void load_uniform_beam(Index k, const Moving &all, const Beams &beams, const UniformBeams &uniform,
                              const LoadsOfBonds &to) {
    put(to, k, loads_of(k, all, beams, uniform));
}
inline void load_dashpot(Index k, const Moving &all, const Beams &beams, const Dashpots &dashpots, const LoadsOfBonds &to) {
    put(to, k, loads_of_dashpot(all, beams, dashpots, k));
}

constexpr auto check_portion = portion_of_bonds<check_beams>;
constexpr auto sum_portion_of_beams = portion_of_bonds<sum_beam_energies>;

}  // namespace bondem
