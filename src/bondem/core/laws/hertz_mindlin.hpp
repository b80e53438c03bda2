// Point contact of elastic spheres after Hertz and Mindlin, with the damping of Tsuji.
//
//     F = 4/3 E* √R* u^(3/2)      kn = dF/du = 2 E* √(R* u)      ks = 8 G* √(R* u)
//     E* = E / (2 (1 - ν²))       G* = G / (2 (2 - ν))           1/R* = 1/R_i + 1/R_j
//
// with the normal force F, the overlap u, the radii R, the tangential stiffness ks, and the elastic constants E, G
// and ν of both spheres. At a rigid wall E* and G* are doubled, and R* = R. Energy: ∫ F du = 2/5 F u. A stretch ξ of
// the tangential spring adds ½ dks/du ξ² to F (`contact.hpp`). The dashpots have √(5/6) of the share β of the
// critical damping that a linear spring would have. The overlap to the power 5/4 then oscillates like the overlap of
// a linear spring, and the restitution is the same at every speed (Antypov and Elliott, EPL 94, 2011).
//
// Limits: overlaps up to a tenth of the smaller radius. Sources: Mindlin and Deresiewicz, J. Appl. Mech. 20 (1953);
// Tsuji, Tanaka and Ishida, Powder Technology 71 (1992) 239–250.
#pragma once
#include "contact.hpp"

namespace bondem {

// Parameters of the law: one for all contacts, or one per contact.
template <class Number> struct HertzMindlinLaw {
    Number modulus;  // E* of two spheres [Pa]
    Number damping;  // β of a linear spring of the same restitution [-]

    static constexpr double of_linear = 0.9128709291752769;  // √(5/6)
    static constexpr bool hardens = true;

    // Contact of two spheres; `own` is the stiffness of a pair with a linear spring of its own [N/m], else 0.
    template <class T> BONDEM_INLINE ContactSpring<T> between(T own, T ra, T rb, T overlap) const {
        const T k = stiffness(ra, rb, overlap);
        const auto linear = own > T{};
        return {select(linear, own, k), select(linear, all<T>(1.0), all<T>(2.0 / 3.0)),
                select(linear, all<T>(0.5), all<T>(0.4)),
                select(linear, T{} + damping, T{} + of_linear * damping),
                select(linear, all<T>(0.0), all<T>(0.5))};
    }
    // The stiffness kn of two spheres at the overlap a step ago.
    template <class T> BONDEM_INLINE T before(T own, T ra, T rb, T overlap, T) const {
        return select(own > T{}, own, stiffness(ra, rb, overlap));
    }
    template <class T> BONDEM_INLINE ContactSpring<T> at_wall(T r, T overlap) const {
        return {4.0 * modulus * root(r * overlap), all<T>(2.0 / 3.0), all<T>(0.4), T{} + of_linear * damping,
                all<T>(0.5)};
    }

  private:
    template <class T> BONDEM_INLINE T stiffness(T ra, T rb, T overlap) const {
        return 2.0 * modulus * root(ra * rb / (ra + rb) * overlap);
    }
};

}  // namespace bondem
