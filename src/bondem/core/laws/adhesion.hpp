// Adhesion of two bodies: an attractive force F that decreases linearly from F_c at contact to zero at a gap D.
//
//     F = F_c            g < 0        U = F_c (g - D / 2)
//     F = F_c (1 - g/D)  0 <= g < D   U = -F_c (D - g)² / 2 D      F_c = σ A,  A = π min(R_i, R_j)², at a wall π R²
//
// g is the gap [m], negative for an overlap, D the range [m] and F_c the pull-off force [N]. σ is the adhesive
// strength [Pa], R the radius of a sphere [m] and U the energy [J]. F opposes the spring and the dashpot of the
// contact. F is a continuous function of the gap alone, so that adhesion dissipates no energy. Friction is limited by
// the repulsive force alone, which at rest exceeds the external compression by F_c. Source: the adhesive rolling
// resistance linear model of PFC (pull-off force F_0, range D_0); σ A as in the cohesive law of Yade.
#pragma once
#include "linear_contact.hpp"

namespace bondem {

struct Adhesion {
    double pull_off, reach;  // F_c [N], D [m], 0 for none

    // Adhesion of strength σ between two spheres; for a sphere at a wall, both radii are its own.
    Adhesion(double strength, double reach, double ra, double rb)
        : pull_off(strength * pi * (ra < rb ? ra * ra : rb * rb)), reach(reach) {}
    double force(double gap) const { return gap < 0.0 ? pull_off : gap < reach ? pull_off * (1.0 - gap / reach) : 0.0; }
    double energy(double gap) const {
        if (gap < 0.0) return pull_off * (gap - 0.5 * reach);
        return gap < reach ? -0.5 * pull_off * (reach - gap) * (reach - gap) / reach : 0.0;
    }
};

}  // namespace bondem
