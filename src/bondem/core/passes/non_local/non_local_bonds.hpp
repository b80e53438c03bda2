#pragma once
#include "../../steps.hpp"
#include "../../tables/non_local_tables.hpp"

namespace bondem {

// Finds forces and torques of the bonds of a block, integrates what they store over the step, and adds what they do
// to the stresses of their elements.
void find_non_local_forces(const Turn &turn, const Moving &all, const Beams &beams, const NonLocalBonds &bonds,
                           const LaggedStresses &stresses);
// Adds forces and torques of the bonds to the sums of the elements, in the order of the bonds.
void add_non_local_loads(const Turn &turn, const NonLocalBonds &bonds, const StepCut &cut);
// Finds and adds forces and torques of bonds that cannot fail, without keeping them.
void add_lasting_loads(const Turn &turn, const Moving &all, const Beams &beams, const NonLocalBonds &bonds,
                       const LaggedStresses &stresses, const StepCut &cut);
// Sums normal and shear energy of the springs of a portion, and the work of extra forces [J].
void sum_non_local_energies(const Turn &turn, const Moving &all, const Beams &beams, const NonLocalBonds &bonds,
                            const Portions &portions, const NonLocalWork &work);
inline double sum_of(const NonLocalWork &work) {
    double taken = 0.0;
    for (Index q = 0; q < work.taken.size(); q++) taken += work.taken(q);
    return taken;
}
// Writes the work of the extra forces of bonds to the ledger.
void write_non_local_work(const Turn &turn, const NonLocalWork &work, const HistoryRows &history);
// Finds forces and torques of all bonds in any poses by what they have stored.
Index load_non_local_bonds(Index threads, const Poses &all, const Beams &beams, const NonLocalBonds &bonds);
// Finds extra forces at small strain, where frames of elements are those of space.
Index find_small_extra_forces(Index threads, const SmallPairs &pairs, const ExtraForces &extra);

}  // namespace bondem
