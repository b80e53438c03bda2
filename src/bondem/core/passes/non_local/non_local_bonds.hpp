#pragma once
#include "../../steps.hpp"
#include "../../tables/non_local_tables.hpp"

namespace bondem {

// Sums normal and shear energy of the springs of a portion, and the work of extra forces [J].
void sum_non_local_energies(const Turn &turn, const Moving &all, const Beams &beams, const NonLocalBonds &bonds,
                            const Portions &portions, const NonLocalWork &work);
inline double sum_of(const NonLocalWork &work) {
    double taken = 0.0;
    for (Index q = 0; q < work.taken.size(); q++) taken += work.taken(q);
    return taken;
}

}  // namespace bondem
