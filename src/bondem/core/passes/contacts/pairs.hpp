// Contacts of pairs of spheres: of one pair, or of as many as a vector register has lanes.
//
// The contact point divides the distance of the centres in the ratio of the radii, so that there is no net moment.
#pragma once
#include "../../laws/hertz_mindlin.hpp"
#include "../../laws/linear_contact.hpp"
#include "../../tables/contact_tables.hpp"
#include "../beams/bonds.hpp"

namespace bondem {

// Calls on(law) with the contact law of the model, whose parameters `of` are those of one contact or of lanes.
template <class Numbers, class On> BONDEM_INLINE void with_law(const ContactConstants &c, const Numbers &of, On on) {
    using Number = decltype(of.modulus);
    if (c.hertzian)
        on(HertzMindlinLaw<Number>{of.modulus, of.damping});
    else
        on(LinearLaw<Number>{of.modulus, of.damping});
}
inline const ContactRow &law_of(const ContactConstants &c, const ContactPairs &pairs, Index k) {
    return c.of(pairs.first(k), pairs.second(k));
}

// Two spheres and their motion.
template <class T> struct Spheres2 {
    T ra, rb;  // radii [m]
    T reach;  // distance at which they touch [m]
    Vector3<T> branch;  // from the first centre to the second [m]
    Vector3<T> velocity;  // of the second against the first [m/s]
    Vector3<T> spin, turning;  // r_a ω_a + r_b ω_b [m/s], ω_a + ω_b [rad/s]
    T mass;  // m̄ [kg]

    BONDEM_INLINE Spheres2(T ra, T rb, T reach, Vector3<T> branch, const Motion<T> &a, const Motion<T> &b)
        : ra(ra), rb(rb), reach(reach), branch(branch), velocity(b.v - a.v), spin(ra * a.w + rb * b.w),
          turning(a.w + b.w), mass(1.0 / (a.m + b.m)) {}
    // Distance of two spheres, and direction and velocity at their contact, for a given branch.
    BONDEM_INLINE Meeting<T> meeting(Vector3<T> d, T &distance) const {
        distance = length(d);
        const Vector3<T> n = d / distance;
        return {n, velocity - cross((distance / (ra + rb)) * spin, n)};
    }
};
template <class T> struct PairLoads {
    T overlap;  // [m]
    ContactLoads<T> contact;
    Vector3<T> torque;  // on either, over its radius [N]
};

template <class Law, class Numbers, class T>
BONDEM_INLINE PairLoads<T> pair_loads(const Law &law, const Numbers &of, const Spheres2<T> &pair, T own,
                                      const ContactMemory<T> &memory, double dt) {
    T distance, before;
    const Meeting<T> now = pair.meeting(pair.branch, distance);
    const Meeting<T> last = pair.meeting(minus(pair.branch, all<T>(dt), pair.velocity), before);
    const T overlap = positive(pair.reach - distance), last_overlap = positive(pair.reach - before);
    const ContactSpring<T> spring = law.between(own, pair.ra, pair.rb, overlap);
    const T kn_before = law.before(own, pair.ra, pair.rb, last_overlap, spring.kn);
    const ContactStiffness<T> k = contact_stiffness(law, spring, kn_before, of.soft, pair.mass, {overlap, last_overlap});
    const T twist = 0.5 * dot(pair.turning, now.normal);
    const ContactLoads<T> loads = contact_loads<Law::hardens>(k, of.friction, overlap, now, last, twist, memory, dt);
    return {overlap, loads, -(distance / (pair.ra + pair.rb)) * cross(now.normal, loads.force)};
}

// Branch of pair k over the nearest periodic image [m].
inline Vector branch_of(const double *pose, const ContactPairs &pairs, Index k) {
    return over_nearest_image(centre(pose, pairs.second(k)) - centre(pose, pairs.first(k)), pairs.period.data);
}
// Loads of pair k in its present position over a step of dt, with its memory of the previous step.
inline PairLoads<double> present_loads(const Moving &all, const ContactConstants &c, const ContactPairs &pairs, Index k,
                                       const ContactMemory<double> &memory, double dt = 0.0) {
    const Short a = pairs.first(k), b = pairs.second(k);
    const Motion<double> of_a(gather(all.motion.data, a)), of_b(gather(all.motion.data, b));
    const Vector d = branch_of(all.pose.data, pairs, k);
    const Spheres2<double> pair(c.radius(a), c.radius(b), pairs.reach(k), d, of_a, of_b);
    PairLoads<double> loads;
    const ContactRow &of = c.of(a, b);
    with_law(c, of, [&](auto law) { loads = pair_loads(law, of, pair, pairs.own(k), memory, dt); });
    return loads;
}
// Calls on(pair, element, is_later) for the elements of a range in the listed pairs of each portion, in the order of
// the pairs; `count(q)` is the number of pairs of portion q.
template <class Count, class On>
BONDEM_INLINE void over_listed_pairs(const Range &range, const ContactPairs &pairs, const Array<Short, 1> &list, Count count,
                                     On on) {
    const auto mine = [&](Short p) { return range.first <= p && p < range.last; };
    for (Index q = range.first / elements_of_portion; q * elements_of_portion < pairs.start.size() - 1; q++) {
        const Index begin = pairs.start(elements_of_portion * q), end = begin + count(q);
        for (Index e = begin; e < end; e++) {
            const Short k = list(e), a = pairs.first(k), b = pairs.second(k);
            if (mine(a)) on(k, a, false);
            if (mine(b)) on(k, b, true);
        }
    }
}
// Calls on(k, true if p is the later element) for the pairs of element p, first those of which it is the later one;
// `earlier` lists the others from start(p) on.
template <class Starts, class On>
BONDEM_INLINE void for_each_pair_of(const ContactPairs &pairs, const Starts &start,
                                    const Array<const Short, 1> &earlier, Index p, On on) {
    for (Index k = pairs.start(p); k < pairs.start(p + 1); k++) on(k, true);
    for (Index e = start(p); e < start(p + 1); e++) on(Index(earlier(e)), false);
}
// True if a bond joins pair k.
inline bool bonded(const ContactPairs &pairs, Index k) { return pairs.bond(k) >= 0 && pairs.joined(pairs.bond(k)) > 0.0; }

// Ends the contact of pair k, at the square of a distance of its centres [m²]. A pair with a smaller reach than at rest
// touches `late`, at that reach, until it is farther apart than at rest.
inline void leave(const ContactPairs &pairs, Index k, double square) {
    double &reach = pairs.reach(k);
    const double whole = pairs.whole(k);
    const bool apart = !(square < whole * whole);
    pairs.touch(k) = reach < whole && !apart ? late : separate;
    if (apart) reach = whole;
}

// Elastic energy of a pair that touches [J].
inline double pair_energy(const double *pose, const ContactConstants &c, const ContactPairs &pairs, Index k) {
    const double overlap = positive(pairs.reach(k) - length(branch_of(pose, pairs, k)));
    const Vector s = pairs.memory.row<const Vector>(k);
    const ContactRow &of = law_of(c, pairs, k);
    double energy = 0.0;
    with_law(c, of, [&](auto law) {
        const auto spring = law.between(pairs.own(k), c.radius(pairs.first(k)), c.radius(pairs.second(k)), overlap);
        energy = contact_energy(spring, of.soft, overlap, dot(s, s));
    });
    return energy;
}

}  // namespace bondem
