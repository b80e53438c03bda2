// Linear contact: a spring whose stiffness follows from an effective modulus E, like that of a bond.
//
//     F = kn u,   kn = E A / L        two spheres: A = π min(R_i, R_j)²,  L = R_i + R_j
//                                     at a rigid wall: A = π R²,  L = R
//
// with the overlap u and the radii R. Energy: ½ kn u². A pair whose bond is broken has the stiffness of that bond,
// and is linear with every law (docs/decisions/0020-contact-after-breakage.md). Limits: overlaps up to half of the
// smaller radius. Sources: Cundall and Strack (1979), and Potyondy and Cundall (2004) for the modulus.
#pragma once
#include "contact.hpp"

namespace bondem {

constexpr double pi = 3.141592653589793;

// Parameters of the law: one for all contacts, or one per contact.
template <class Number> struct LinearLaw {
    Number modulus;  // E [Pa]
    Number damping;  // β [-]

    static constexpr bool hardens = false;

    // Contact of two spheres; `own` is the stiffness of a pair with a spring of its own [N/m], else 0.
    template <class T> BONDEM_INLINE ContactSpring<T> between(T own, T ra, T rb, T) const {
        const T small = select(ra < rb, ra, rb), k = modulus * pi * small * small / (ra + rb);
        return {select(own > T{}, own, k), all<T>(1.0), all<T>(0.5), T{} + damping, T{}};
    }
    // The stiffness kn of two spheres a step ago; it does not depend on the overlap.
    template <class T> BONDEM_INLINE T before(T, T, T, T, T kn) const { return kn; }

    template <class T> BONDEM_INLINE ContactSpring<T> at_wall(T r, T) const {
        return {modulus * pi * r, all<T>(1.0), all<T>(0.5), T{} + damping, T{}};
    }
};

}  // namespace bondem
