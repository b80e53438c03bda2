// Forces and torques of cracks, and what they dissipate: of one crack, or of as many as there are lanes.
#pragma once
#include "../damage/pipeline.hpp"
#include "single_cracks.hpp"

namespace bondem {

// Forces of the cracks of a group; adds the energy that they dissipate to a sum, one by one, so that its bits do not depend
// on the number of lanes.
template <class Group, class T = typename Group::Number>
BONDEM_INLINE void load_each(const Group &group, const Moving &all, const double *period, const CohesiveCracks &cracks,
                             const CrackLists &lists, Index portion, bool changes, double &total) {
    group.prefetch(cracks.state);
    group.prefetch(cracks.softening);
    group.prefetch_pull(cracks);
    const T zero = {};
    const CrackPlace<T> at = place_of(group, all.pose, period, cracks);
    Row<T> row = group.lines(cracks.state);
    T *const state = row.column;
    const T s = at.s, s_before = state[6];
    const Vector3<T> slip = turned_by(at.ends.i, Vector3<T>{state[0], state[1], state[2]});
    CrackLoads<T> loads = crack_loads(at.facet, at.now.faces, s, at.stress, slip, at.friction);
    T rate = loads.rate;
    const Mask<T> bound = (s > zero) | (s_before > zero);
    if (any(bound)) {
        T plane;
        const FacetBending<T> bending = facet_bending(at.ends, group.resistances(cracks, &plane));
        loads.on_i = plus(loads.on_i, s, bending.torque);
        loads.on_j = minus(loads.on_j, s, bending.torque);
        rate = select(bound, rate + bending.energy, rate);
    }
    const Mask<T> treated = opposite(group.flagged(lists.flag));
    const auto kept = [&](T x) { return select(treated, x, zero); };
    const Vector3<T> f = loads.force, rub = loads.friction.force, now = loads.friction.slip, came = now - slip;
    CrackLosses<T> lost = {zero, zero};
    if (changes) {
        const CrackStep<T> step = {s_before, s, state[7], rate, {state[3], state[4], state[5]}, rub, came};
        lost = crack_losses(at.facet.k, step);
        lost = {kept(lost.cracked), kept(lost.rubbed)};
        const Vector3<T> own = turned_by(inverse(at.ends.i), now);
        const Vector3<T> none = {};
        const Vector3<T> own_kept = select<T>(treated, own, none), rub_kept = select<T>(treated, rub, none);
        group.put(cracks.state, {{own_kept.x, own_kept.y, own_kept.z, rub_kept.x, rub_kept.y, rub_kept.z, s_before,
                                  rate}});
        if (any(lost.cracked != zero))
            group.put(cracks.history, 1, group.number(cracks.history, 1) + lost.cracked);
        const Mask<T> breaks = treated & (s == zero) & (s_before > zero);
        group.flag(lists.flag, lists.flagged, portion, breaks, crack::fell, 2);
    }
    group.where(treated, [&](Index k, Index, int n) {
        double *const pull = &cracks.pull(k, 0);
        pull[0] = group.lane(f.x, n), pull[1] = group.lane(f.y, n), pull[2] = group.lane(f.z, n);
    });
    const Vector3<T> p = loads.on_i, q = loads.on_j;
    group.put_halves(lists.output.data,
                     {{kept(f.x), kept(f.y), kept(f.z), lost.rubbed, kept(p.x), kept(p.y), kept(p.z), zero}},
                     {{kept(-f.x), kept(-f.y), kept(-f.z), zero, kept(q.x), kept(q.y), kept(q.z), zero}});
    group.add(lost.cracked, total);
}

// Writes down that nothing is left of the crack of facet k.
inline void log_crack(const Clock &clock, const Moving &all, const ElasticFacets &facets, const CohesiveCracks &cracks,
                      const EventLog &log, Index k) {
    const SingleCrack one(all.pose, facets, cracks, k);
    const CrackFaces<double> &at = one.now.faces;
    const Vector centre = {all.pose(facets.i(k), 0), all.pose(facets.i(k), 1), all.pose(facets.i(k), 2)};
    const double gap = dot(at.gap, at.normal);
    const CrackHistoryRow &history = history_of(cracks, k);
    log_event(clock, log, k, gap > 0.0 ? tension_mode : shear_mode,
              {history.spent, gap, centre + at.arm_i, double(clock.step) - history.onset_step});
}

// Adds the elastic energies of the crack of facet k: across it, along it, and of bending [J].
inline void add_energies_of_crack(const Moving &all, const ElasticFacets &facets, const CohesiveCracks &cracks, Index k,
                                  Vector &sum) {
    const SingleCrack one(all.pose, facets, cracks, k);
    const double *const q = state_of(cracks, k).rub;
    const float *const h = softening_of(cracks, k).H;
    const CrackHalves<double> half = crack_halves(one.stiffness, one.now.faces, one.stress);
    const CrackEnergy<double> energy = crack_energy(one.stiffness, one.now.faces, one.s, half, Vector{q[0], q[1], q[2]});
    sum.x += energy.across;
    sum.y += energy.along;
    sum.z += one.s * facet_bending(one.ends, Symmetric3<double>{h[0], h[1], h[2], h[3], h[4], h[5]}).energy;
}

}  // namespace bondem
