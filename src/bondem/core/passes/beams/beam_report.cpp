// What the guard and the history need of beams.
#include "beam_report.hpp"

#include "bonds.hpp"

namespace bondem {

void check_beams(const Turn &turn, const Moving &all, const Beams &beams, const Portions &portions) {
    Index wide = 0, lost = 0, not_finite = 0;
    for (Index k = turn.first; k < turn.last; k++) {
        const BeamTurn<double> turned = beam_turn(ends_of(all.pose.data, beams, k), direction_of<double>(beams, k));
        const double c = least(turned.c1, turned.c2), w2 = turned.w2;
        not_finite |= !(c * c + w2 < 4.0);
        if (beams.integrity(k) > 0.0) {
            wide += (c < 0.7) | (w2 < 0.75);
            lost += (c <= 0.0) | (w2 <= 0.25);
        }
    }
    portions.turned(turn.block, 0) = wide;
    portions.turned(turn.block, 1) = lost;
    portions.turned(turn.block, 2) = not_finite;
}

void sum_beam_energies(const Turn &turn, const Moving &all, const Beams &beams, const Portions &portions) {
    double sum[4] = {};
    for (Index k = turn.first; k < turn.last; k++) {
        const BeamEnergy<double> energy = beam_energy(ends_of(all.pose.data, beams, k), shape_of<double>(beams, k),
                                                      stiffness_of(beams, k, 1.0), beams.ks(k), beams.lever(k));
        const double s = beams.integrity(k);
        sum[0] += s * energy.normal;
        sum[1] += s * energy.shear;
        sum[2] += s * energy.bending;
        sum[3] += s * energy.twisting;
    }
    for (Index c = 0; c < 4; c++) portions.bonds(turn.block, c) = sum[c];
}

}  // namespace bondem
