// Beams on a GPU. The thread of a beam writes the loads of the beam or of its dashpot to the table `LoadsOfBonds`.
#pragma once
#include "../passes/beams/beam_passes.hpp"
#include "../passes/damage/beam_removal.hpp"
#include "ranges.hpp"

namespace bondem {

BONDEM_INLINE void put(const LoadsOfBonds &to, Index k, const BeamLoads<double> &loads) {
    keep_loads(to.load.data, to.load.shape[1], k, loads);
}

// Loads of beam k whose stiffness is of a kind, `Own` or `Uniform`.
template <class Kind>
BONDEM_INLINE BeamLoads<double> loads_of(Index k, const Moving &all, const Beams &beams, const Kind &kind) {
    const BeamStiffness<double> stiffness = kind.template stiffness<double>(k);
    return beam_loads(ends_of(all.pose.data, beams, k), shape_of<double>(beams, k), stiffness);
}

inline void load_beam(Index k, const Moving &all, const Beams &beams, const LoadsOfBonds &to) {
    put(to, k, loads_of(k, all, beams, Own{beams}));
}
inline void load_uniform_beam(Index k, const Moving &all, const Beams &beams, const UniformBeams &uniform,
                              const LoadsOfBonds &to) {
    put(to, k, loads_of(k, all, beams, all_uniform(uniform)));
}
inline void load_dashpot(Index k, const Moving &all, const Beams &beams, const Dashpots &dashpots, const LoadsOfBonds &to) {
    put(to, k, loads_of_dashpot(all, beams, dashpots, k));
}

constexpr auto check_portion = portion_of_bonds<check_beams>;
constexpr auto sum_portion_of_beams = portion_of_bonds<sum_beam_energies>;

}  // namespace bondem
