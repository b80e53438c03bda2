// Contact of two bodies: a spring and a dashpot along the normal, both again in the tangential plane, Coulomb friction.
//
//     F_n = max(F(u) + cn u', 0)        |F_t| <= μ F_n,   F_t = ks ξ + cs ξ' while it sticks
//
// u is the overlap and ξ the stretch of the tangential spring. The spring turns with the pair, and slides where Coulomb's
// limit is reached. F(u) and ks are those of a law (`linear_contact.hpp`, `hertz_mindlin.hpp`); the dashpots are shares β
// of the critical damping of the masses that meet,
//
//     cn = 2 β √(kn m̄)      cs = 2 β √(ks m̄)      kn = dF/du,   1/m̄ = 1/m_i + 1/m_j
//
// Energy: U = ∫ F du + ½ ks ξ². A tangential spring that becomes stiffer keeps its force, and one that becomes softer
// keeps its stretch, so that its energy never grows by the change (Thornton, Cummins and Cleary, Powder Technology 233,
// 2013). Work on the spring that it does not store is friction. Losses are the trapezoid of force over displacement, of
// second order as the step is.
//
// Signs: the normal is from the first body to the second, velocities are of the second against the first, and the force
// acts on the second body. Repulsion only.
//
// Limits: overlaps small beside the radii, and a step in which the pair turns little. Sources: Cundall and Strack,
// Géotechnique 29 (1979) 47–65; Luding, Granular Matter 10 (2008) 235–246, for the turning of the spring.
#pragma once
#include "../select.hpp"

namespace bondem {

// A law at one overlap.
template <class T> struct ContactSpring {
    T kn;  // dF/du [N/m]
    T force;  // F over kn u [-]
    T energy;  // ∫ F du over F u [-]
    T damping;  // β [-]
};
// Springs and dashpots of a contact.
template <class T> struct ContactStiffness {
    T kn, force;  // dF/du [N/m], and F over kn u [-]
    T ks, ks_before;  // now, and a step ago [N/m]
    T cn, cs;  // [N·s/m]
};
// Where two bodies touch.
template <class T> struct Meeting {
    Vector3<T> normal;
    Vector3<T> velocity;  // of the second body against the first at the contact, over the step [m/s]
};
// What a contact knows of its past.
template <class T> struct ContactMemory {
    Vector3<T> stretch;  // ξ [m]
    Vector3<T> viscous;  // force of the dashpots [N]
};
template <class T> struct ContactLoads {
    Vector3<T> force;  // on the second body [N]
    ContactMemory<T> memory;
    T damped, rubbed;  // energy lost to dashpots and to friction over the step [J]
};

// Springs and dashpots of a spring of stiffness `before` a step ago; `soft` is ks / kn.
template <class T>
BONDEM_INLINE ContactStiffness<T> contact_stiffness(const ContactSpring<T> &spring, T before, double soft, T mass) {
    const T ks = soft * spring.kn;
    const T cn = 2.0 * spring.damping * root(spring.kn * mass), cs = 2.0 * spring.damping * root(ks * mass);
    return {spring.kn, spring.force, ks, soft * before, cn, cs};
}

template <class T> BONDEM_INLINE Vector3<T> tangential(Vector3<T> v, Vector3<T> n) { return minus(v, dot(v, n), n); }

// A tangential vector a step later: turned about the normal, and into the new plane at its old length.
template <class T> BONDEM_INLINE Vector3<T> turned_with(Vector3<T> s, Vector3<T> n, T angle) {
    const Vector3<T> in_plane = tangential(plus(s, angle, cross(n, s)), n);
    const T after = dot(in_plane, in_plane);
    return select(after > T{}, root(dot(s, s) / after), T{}) * in_plane;
}

// Force of a contact, its memory and its losses over a step of dt.
//
// `last` is `now` a step ago, `twist` the rate at which the pair turns about the normal [rad/s]. An overlap of 0 is that
// of bodies that have just parted.
template <class T>
BONDEM_INLINE ContactLoads<T> contact_loads(const ContactStiffness<T> &k, double friction, T overlap, const Meeting<T> &now,
                                            const Meeting<T> &last, T twist, const ContactMemory<T> &memory, double dt) {
    const T zero = {}, one = all<T>(1.0), half = all<T>(0.5 * dt);
    const Vector3<T> v = now.velocity, n = now.normal;
    const T elastic = k.force * k.kn * overlap, pressed = elastic - k.cn * dot(v, n);
    const T normal = select(overlap > zero, positive(pressed), zero);
    Vector3<T> force = normal * n, viscous = (normal - elastic) * n, stretch = memory.stretch;
    T rubbed = zero;
    if (friction > 0.0) {
        const Vector3<T> t = tangential(v, n), s = memory.stretch;
        const T angle = dt * twist;
        const Vector3<T> came = turned_with(tangential(last.velocity, last.normal), n, angle);
        const T less = select(k.ks > k.ks_before, k.ks_before / k.ks, one);
        const Vector3<T> whole = plus(less * turned_with(s, n, angle), half, came + t);
        const T limit = friction * normal, pull = k.ks * length(whole);
        stretch = select(pull > limit, limit / pull, select(overlap > zero, one, zero)) * whole;
        const T given = half * (k.ks_before * dot(s, last.velocity) + k.ks * dot(stretch, v));
        rubbed = given - 0.5 * (k.ks * dot(stretch, stretch) - k.ks_before * dot(s, s));
        const Vector3<T> spring = k.ks * stretch, both = plus(spring, k.cs, t);
        // the dashpot never makes it slide
        const Vector3<T> none = {zero, zero, zero};
        const Vector3<T> dashpot = select(dot(both, both) > limit * limit, none, both - spring);
        viscous = viscous - dashpot;
        force = force - (spring + dashpot);
    }
    const T damped = -half * (dot(memory.viscous, last.velocity) + dot(viscous, v));
    return {force, {stretch, viscous}, damped, rubbed};
}

// Elastic energy of a contact, given the square of its stretch [J].
template <class T> BONDEM_INLINE T contact_energy(const ContactSpring<T> &spring, double soft, T overlap, T stretch_square) {
    return spring.energy * spring.force * spring.kn * overlap * overlap + 0.5 * soft * spring.kn * stretch_square;
}

}  // namespace bondem
