// Resistance to rolling and twisting of spheres in contact: a spring of the relative rotation, with a limit.
//
//     M = -R̄ ks ρ      |ρ_t| <= μ_r F_n / ks      |ρ_n| <= μ_w F_n / ks      1/R̄ = 1/R_i + 1/R_j, at a wall R̄ = R
//
// M is the moment on the second body, F_n the normal force, and R a radius. ρ is R̄ times the rotation of the second
// body against the first that the spring stores. ρ_t is across the normal and ρ_n along it. μ_r and μ_w are
// coefficients. ks is the tangential stiffness of the contact, at a fixed overlap, because a constant stiffness has a
// potential. The spring stores ½ ks ρ²; other work is lost to friction.
//
// The moments on both bodies are opposite: angular momentum is conserved. Source: type C of Ai, Chen, Rotter and Ooi,
// Powder Technology 206 (2011) 269–282, without its dashpot.
#pragma once
#include "../../steps.hpp"
#include "../../tables/contact_tables.hpp"
#include "pairs.hpp"
#include "seen_from_wall.hpp"

namespace bondem {

// A contact that may roll.
struct RollingContact {
    double ks, arm;  // [N/m], R̄ [m]
    double pressed;  // F_n [N]
    Vector normal, last_normal;
    Vector spin, last_spin;  // of the second body against the first, now and a step ago [rad/s]
    double twist;  // rate at which the pair turns about the normal [rad/s]
};
struct RollingLoads {
    Vector moment;  // on the second body [N·m]
    Vector rolled;  // ρ [m]
    double rubbed;  // [J]
};

// Moments and losses of a rolling contact over a step of dt.
inline RollingLoads rolling_loads(const RollingContact &at, const ContactRow &law, const Vector &before, double dt) {
    const Vector n = at.normal, m = at.last_normal;
    const auto turned = [&](const Vector &v) {
        const double along = dot(v, m);
        return plus(turned_with(minus(v, along, m), n, dt * at.twist), along, n);
    };
    const Vector whole = plus(turned(before), 0.5 * dt * at.arm, turned(at.last_spin) + at.spin);
    const double along = dot(whole, n), most_along = law.twisting * at.pressed / at.ks;
    const Vector across = minus(whole, along, n);
    const double size = length(across), most_across = law.rolling * at.pressed / at.ks;
    const Vector rolled = plus((size > most_across ? most_across / size : 1.0) * across, within(along, -most_along, most_along), n);
    const double given = 0.5 * dt * at.arm * at.ks * (dot(before, at.last_spin) + dot(rolled, at.spin));
    return {(-at.arm * at.ks) * rolled, rolled, given - 0.5 * at.ks * (dot(rolled, rolled) - dot(before, before))};
}

// R̄ of pair k [m]; `rolling_stiffness` is the stiffness ks of its rolling spring [N/m].
inline double rolling_arm(const ContactConstants &c, const ContactPairs &pairs, Index k) {
    const double a = c.radius(pairs.first(k)), b = c.radius(pairs.second(k));
    return a * b / (a + b);
}
inline double rolling_stiffness(const ContactConstants &c, const ContactPairs &pairs, Index k) {
    const ContactRow &of = law_of(c, pairs, k);
    double ks = 0.0;
    with_law(c, of, [&](auto law) {
        const double deep = 2.0 * of.deep * rolling_arm(c, pairs, k);
        ks = of.soft * law.between(pairs.own(k), c.radius(pairs.first(k)), c.radius(pairs.second(k)), deep).kn;
    });
    return ks;
}
inline double rolling_stiffness_at_wall(const ContactConstants &c, const ContactRow &of, double radius) {
    double ks = 0.0;
    with_law(c, of, [&](auto law) { ks = of.soft * law.at_wall(radius, of.deep * radius).kn; });
    return ks;
}

// Computes the rolling resistance of pair k, which touches or has just parted; `force` acts on its later element.
inline void roll_pair(const Moving &all, const ContactConstants &c, const ContactPairs &pairs, const RolledPairs &of, Index k,
                      const Vector &force, double dt) {
    const Short p = pairs.first(k), q = pairs.second(k);
    const Motion<double> a(gather(all.motion.data, p)), b(gather(all.motion.data, q));
    const Vector d = branch_of(all.pose.data, pairs, k), before = minus(d, dt, b.v - a.v), n = (1.0 / length(d)) * d;
    const bool touches = pairs.touch(k) == touching;
    const RollingContact at = {rolling_stiffness(c, pairs, k), rolling_arm(c, pairs, k), touches ? dot(force, n) : 0.0, n,
                               (1.0 / length(before)) * before, b.w - a.w, b.w - a.w, 0.5 * dot(a.w + b.w, n)};
    const RollingLoads loads = rolling_loads(at, c.of(p, q), of.rolled.row<Vector>(k), dt);
    of.rolled.row<Vector>(k) = loads.rolled;
    for (Index x = 0; x < 3; x++) of.output(k, x) = loads.moment[x];
    of.output(k, 3) = loads.rubbed;
}
// Adds the moment of pair k to its later or its earlier element.
inline void add_rolling(const RolledPairs &of, Index k, bool later, double *row) {
    for (Index x = 0; x < 3; x++) row[4 + x] += later ? of.output(k, x) : -of.output(k, x);
    if (later) row[7] += of.output(k, 3);
}

// Finds moments of resistance to rolling of a portion of elements at walls.
void roll_at_walls(const Range &range, const Moving &all, const ContactConstants &c, const WallContacts &contacts,
                   const Walls &walls, const RolledWalls &of, const ContactSums &to);
// Adds the energy that springs of rolling store in the pairs of a portion [J].
void sum_rolling_energies(const Range &range, const ContactConstants &c, const ContactPairs &pairs, const RolledPairs &of,
                          const Ledger &ledger);
// Adds the energy that springs of rolling store at walls, of a portion of elements [J].
void sum_rolling_at_walls(const Range &range, const ContactConstants &c, const WallContacts &contacts, const RolledWalls &of,
                          const Ledger &ledger);

}  // namespace bondem
