// Contact of two bodies: a spring and a dashpot along the normal, a spring and a dashpot across it, and friction.
//
//     F_n = max(F(u) + ½ ks'(u) ξ² + cn du/dt, 0)        |F_t| <= μ F_n,   F_t = ks ξ + cs dξ/dt while it sticks
//
// u is the overlap, ξ the stretch of the tangential spring, and ks' = dks/du. The spring turns with the pair, and
// slides where Coulomb's limit with the friction μ is reached. A law gives F(u) and ks (`linear_contact.hpp`,
// `hertz_mindlin.hpp`). The dashpots have the share β of the critical damping, with m the masses of both bodies:
//
//     cn = 2 β √(kn m̄)      cs = 2 β √(ks m̄)      kn = dF/du,   1/m̄ = 1/m_i + 1/m_j
//
// Energy: U = ∫ F du + ½ ks ξ². Forces are the gradient of U also where ks depends on the overlap. Springs that do
// not slide therefore store all work on them, and return to their places after any cycle of load
// (docs/decisions/0053-tangential-potential-and-rolling.md). Work on the tangential spring that is not stored is lost
// to friction. Losses follow from the trapezoidal rule, of second order in the time step. F_n depends on F_t = ks ξ
// by F_n = N + F_t² h, with h = ks' / 2 ks² and N the part without ξ. At the limit F_t = μ F_n therefore
//
//     F_t = 2 μ N / (1 + √(1 - 4 μ² N h))
//
// The stiffness of a spring may change from step to step, as between faces whose common area changes. The spring then
// keeps its force as it stiffens and its stretch as it softens, so that the change never increases its energy
// (Thornton, Cummins and Cleary, Powder Technology 233, 2013).
//
// Signs: the normal is from the first body to the second, velocities are of the second against the first, and the
// force acts on the second body. Repulsion only.
//
// Limits: overlaps much smaller than the radii, and a step in which the pair turns little. Sources: Cundall and
// Strack, Géotechnique 29 (1979) 47–65; Luding, Granular Matter 10 (2008) 235–246, for the turning of the spring.
#pragma once
#include "../select.hpp"

namespace bondem {

// Values of a contact law at one overlap.
template <class T> struct ContactSpring {
    T kn;  // dF/du [N/m]
    T force;  // F over kn u [-]
    T energy;  // ∫ F du over F u [-]
    T damping;  // β [-]
    T hardening;  // d ln kn / d ln u [-]
};
// Springs and dashpots of a contact.
template <class T> struct ContactStiffness {
    T kn, force;  // dF/du [N/m], and F over kn u [-]
    T ks, ks_before;  // now, and a step ago [N/m]
    T rise, rise_before;  // ½ dks/du, of laws that harden [N/m²]
    T cn, cs;  // [N·s/m]
};
// Geometry and velocity of a contact of two bodies.
template <class T> struct Meeting {
    Vector3<T> normal;
    Vector3<T> velocity;  // of the second body against the first at the contact, over the step [m/s]
};
// Memory of a contact.
template <class T> struct ContactMemory {
    Vector3<T> stretch;  // ξ [m]
    Vector3<T> viscous;  // force of the dashpots [N]
};
template <class T> struct ContactLoads {
    Vector3<T> force;  // on the second body [N]
    ContactMemory<T> memory;
    T damped, rubbed;  // energy lost to dashpots and to friction over the step [J]
};

// Overlaps now and a step ago [m].
template <class T> struct Overlaps {
    T now, before;
};

// Springs and dashpots of a contact whose normal stiffness was `before` a step ago [N/m]; `soft` is ks / kn.
template <class T, class Number>
BONDEM_INLINE ContactStiffness<T> contact_stiffness(const ContactSpring<T> &spring, T before, Number soft, T mass) {
    const T ks = soft * spring.kn;
    const T cn = 2.0 * spring.damping * root(spring.kn * mass), cs = 2.0 * spring.damping * root(ks * mass);
    return {spring.kn, spring.force, ks, soft * before, T{}, T{}, cn, cs};
}
// Springs and dashpots of a law whose stiffness may grow with the overlap.
template <class Law, class T, class Number>
BONDEM_INLINE ContactStiffness<T> contact_stiffness(const Law &, const ContactSpring<T> &spring, T before, Number soft, T mass,
                                                    const Overlaps<T> &overlap) {
    ContactStiffness<T> k = contact_stiffness(spring, before, soft, mass);
    if constexpr (Law::hardens) {
        const auto rise = [&](T ks, T u) { return select(u > T{}, 0.5 * spring.hardening * ks / u, T{}); };
        k.rise = rise(k.ks, overlap.now);
        k.rise_before = rise(k.ks_before, overlap.before);
    }
    return k;
}

// The largest F_t <= μ F_n where F_n = N + F_t² h, N >= 0. For an h so large that no F_t equals μ F_n, the F_t of
// the largest F_t / F_n.
template <class T, class Number> BONDEM_INLINE T sliding_limit(Number friction, T N, T h) {
    const T wide = 4.0 * N * h, square = T{} + friction * friction;
    const T bounded = select(square * wide > all<T>(1.0), 1.0 / wide, square);
    return 2.0 * root(bounded) * N / (1.0 + root(positive(1.0 - bounded * wide)));
}

// A tangential vector a step later: turned about the normal, and into the new plane at its old length.
template <class T> BONDEM_INLINE Vector3<T> turned_with(Vector3<T> s, Vector3<T> n, T angle) {
    const Vector3<T> in_plane = tangential(plus(s, angle, cross(n, s)), n);
    const T after = dot(in_plane, in_plane);
    return select(after > T{}, root(dot(s, s) / after), T{}) * in_plane;
}

// Force of a contact, its memory and its losses over a step of dt. `hardens` is true for laws whose ks depends on the
// overlap. Parameters of the law are one for all lanes, or one per lane.
//
// `last` is `now` a step ago, `twist` the rate at which the pair turns about the normal [rad/s]. Bodies that have
// just parted have an overlap of 0.
template <bool hardens, class T, class Number>
BONDEM_INLINE ContactLoads<T> contact_loads(const ContactStiffness<T> &k, Number friction, T overlap, const Meeting<T> &now,
                                            const Meeting<T> &last, T twist, const ContactMemory<T> &memory, double dt) {
    const T zero = {}, one = all<T>(1.0), half = all<T>(0.5 * dt);
    const Vector3<T> v = now.velocity, n = now.normal;
    T elastic = k.force * k.kn * overlap;
    const T pressed = elastic - k.cn * dot(v, n);
    T normal = select(overlap > zero, positive(pressed), zero);
    Vector3<T> across = {zero, zero, zero}, dashpot = across, stretch = memory.stretch;
    T rubbed = zero;
    if (any(friction > 0.0)) {
        const Vector3<T> t = tangential(v, n), s = memory.stretch;
        const T angle = dt * twist;
        const Vector3<T> before = turned_with(tangential(last.velocity, last.normal), n, angle);
        Vector3<T> stored = turned_with(s, n, angle);
        if constexpr (!hardens) stored = select(k.ks > k.ks_before, k.ks_before / k.ks, one) * stored;
        const Vector3<T> whole = plus(stored, half, before + t);
        T limit = friction * normal;
        if constexpr (hardens) limit = sliding_limit(friction, normal, select(overlap > zero, k.rise / (k.ks * k.ks), zero));
        const T pull = k.ks * length(whole);
        stretch = select(pull > limit, limit / pull, select(overlap > zero, one, zero)) * whole;
        T given = half * (k.ks_before * dot(s, last.velocity) + k.ks * dot(stretch, v));
        if constexpr (hardens) {
            const T raised = k.rise * dot(stretch, stretch);
            given = given - half * (k.rise_before * dot(s, s) * dot(last.velocity, last.normal) + raised * dot(v, n));
            elastic = elastic + raised;
            normal = select(overlap > zero, positive(pressed + raised), zero);
            limit = friction * normal;
        }
        rubbed = given - 0.5 * (k.ks * dot(stretch, stretch) - k.ks_before * dot(s, s));
        const Vector3<T> spring = k.ks * stretch, both = plus(spring, k.cs, t);
        // the dashpot alone never causes sliding
        dashpot = select(dot(both, both) > limit * limit, dashpot, both - spring);
        across = spring + dashpot;
    }
    const Vector3<T> force = normal * n - across, viscous = (normal - elastic) * n - dashpot;
    const T damped = -half * (dot(memory.viscous, last.velocity) + dot(viscous, v));
    return {force, {stretch, viscous}, damped, rubbed};
}

// Elastic energy of a contact, given the square of its stretch [J].
template <class T> BONDEM_INLINE T contact_energy(const ContactSpring<T> &spring, double soft, T overlap, T stretch_square) {
    return spring.energy * spring.force * spring.kn * overlap * overlap + 0.5 * soft * spring.kn * stretch_square;
}

}  // namespace bondem
