// Energies of beams for the history of a run, and counts of beams with large rotations for the check of the run.
#include "beam_passes.hpp"

#include "../../ledger.hpp"
#include "../../registered.hpp"
#include "bonds.hpp"

namespace bondem {
namespace {

// Counts unbroken beams beyond safe angles and beyond valid angles; the third count is 1 if a number is not finite.
void count_turned(Index first, Index last, const double *pose, const Beams &beams, Index *count) {
    Index wide = 0, lost = 0, not_finite = 0;
    for (Index k = first; k < last; k++) {
        const BeamTurn<double> turned = beam_turn(ends_of(pose, beams, k), direction_of<double>(beams, k));
        const double c = least(turned.c1, turned.c2), w2 = turned.w2;
        not_finite |= !(c * c + w2 < 4.0);
        if (beams.integrity(k) > 0.0) {
            wide += (c < 0.7) | (w2 < 0.75);
            lost += (c <= 0.0) | (w2 <= 0.25);
        }
    }
    count[0] = wide, count[1] = lost, count[2] = not_finite;
}

void sum_energies(Index first, Index last, const double *pose, const Beams &beams, ModeSums &sum) {
    for (Index k = first; k < last; k++) {
        const BeamEnergy<double> energy = beam_energy(ends_of(pose, beams, k), shape_of<double>(beams, k),
                                                      stiffness_of(beams, k, 1.0), beams.ks(k), beams.lever(k));
        sum.add(beams.integrity(k), energy);
    }
}

}  // namespace

void check_beams(const Range &range, const Moving &all, const Beams &beams, const Ledger &ledger) {
    Index count[3];
    count_turned(range.first, range.last, all.pose.data, beams, count);
    count_turns(ledger, count[0], count[1], count[2]);
}
BONDEM_PASS(check_beams, of_bonds, "ends pose")

// Counts unbroken beams beyond safe angles and beyond valid angles in given poses.
Index count_turned_beams(Index, const Poses &all, const Beams &beams, const BeamTurns &found) {
    count_turned(0, beams.i.size(), all.pose.data, beams, found.found.data);
    return 0;
}
BONDEM_CALL(count_turned_beams, "")

void sum_beam_energies(const Range &range, const Moving &all, const Beams &beams, const Ledger &ledger) {
    ModeSums sum = {};
    sum_energies(range.first, range.last, all.pose.data, beams, sum);
    sum.add_to(ledger);
}
BONDEM_PASS(sum_beam_energies, of_bonds, "ends pose")

// Measures normal, shear, bending and twisting energy of all beams in given poses [J].
Index measure_beam_energies(Index, const Poses &all, const Beams &beams, const BeamEnergies &found) {
    ModeSums sum = {};
    sum_energies(0, beams.i.size(), all.pose.data, beams, sum);
    sum.put(found.energy.data);
    return 0;
}
BONDEM_CALL(measure_beam_energies, "")

}  // namespace bondem
