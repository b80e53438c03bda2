// Damping of the motion of elements, and of the bonds between them.
//
// Local damping adds -γ |F| sign(v) to each component F of force and torque, with v the component of the velocity
// (Chen et al. 2022, eqs (11) and (12), which print F U / U in place of F). The added force opposes the motion, and
// vanishes in equilibrium.
//
// A bond has a dashpot parallel to each of its springs, against the relative motion of its ends at the contact point.
// The distances of this point from the centres add up to the present length, so that there is no net moment, and no
// force in rigid motion. Each dashpot follows from the stiffness of its own spring, by eqs (9) and (10) of Chen et
// al. (2022). Tension is positive. The force acts on j, and its opposite on i.
#pragma once
#include "beam.hpp"

namespace bondem {

template <class T> BONDEM_INLINE T locally_damped(T force, T velocity, double gamma) {
    return force - gamma * sign(velocity) * absolute(force);
}
template <class T> BONDEM_INLINE Vector3<T> locally_damped(Vector3<T> force, Vector3<T> velocity, double gamma) {
    return {locally_damped(force.x, velocity.x, gamma), locally_damped(force.y, velocity.y, gamma),
            locally_damped(force.z, velocity.z, gamma)};
}

// Velocities of two elements, on which the dashpots of their bond act.
template <class T> struct RelativeMotion {
    Vector3<T> velocity;  // of j minus that of i [m/s]
    Vector3<T> spin_i, spin_j;  // angular velocities [rad/s]
};
// Dashpots of a bond, normal, shear, bending and twisting.
template <class T> struct BeamDashpots {
    T cn, cs;  // [N·s/m]
    T cb, ct;  // [N·m·s]
};

// Force and torques of dashpots; `share` is the distance of the contact point from i over that of the centres [-].
template <class T>
BONDEM_INLINE BeamLoads<T> dashpot_loads(Vector3<T> branch, const RelativeMotion<T> &motion, T share,
                                         const BeamDashpots<T> &c) {
    const T l = length(branch), inverse = 1.0 / l, near = share * l, far = l - near;
    const Vector3<T> n = inverse * branch;
    // u = v - (near ω_i + far ω_j) × n, the slip at the contact point
    const Vector3<T> p = motion.spin_i, q = motion.spin_j;
    const Vector3<T> s = {near * p.x + far * q.x, near * p.y + far * q.y, near * p.z + far * q.z};
    const Vector3<T> u = motion.velocity - cross(s, n);
    const T along = (c.cn - c.cs) * dot(u, n);
    const Vector3<T> f = {-c.cs * u.x - along * n.x, -c.cs * u.y - along * n.y, -c.cs * u.z - along * n.z};
    const Vector3<T> w = q - p;
    const T twist = (c.ct - c.cb) * dot(w, n);
    const Vector3<T> m = {c.cb * w.x + twist * n.x, c.cb * w.y + twist * n.y, c.cb * w.z + twist * n.z};
    const Vector3<T> t = cross(n, f);
    return {f, minus(m, near, t), minus(-m, far, t)};
}

}  // namespace bondem
