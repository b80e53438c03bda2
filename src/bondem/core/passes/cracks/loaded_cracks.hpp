// Forces, torques and dissipation of cracks, for one crack or for one crack per SIMD lane.
#pragma once
#include "../../ledger.hpp"
#include "../damage/pipeline.hpp"
#include "slides.hpp"

namespace bondem {

// Computes forces, torques and dissipation of the cracks of a group; adds the dissipation to a sum one by one, so
// that its bits do not depend on the number of lanes.
template <class Group, class T = typename Group::Number>
BONDEM_INLINE void load_each(const Group &group, const Moving &all, const double *period, const FacetStrengths &strengths,
                             const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists,
                             Index portion, bool changes, ExactSum &total) {
    group.prefetch(cracks.past, cracks.softening, cracks, lists);
    const T zero = {};
    const CrackPlace<T> at = place_of(group, all.pose, period, cracks);
    const Row<T> past = group.lines(cracks.past);
    const T *const state = at.state.column;
    const CrackIntegrity<T> &left = at.now.left, before = {{past.column[0], past.column[1], past.column[2]}, past.column[3]};
    const T s = left.least_left();
    const Vector3<T> slip = turned_by(at.ends.i, Vector3<T>{state[0], state[1], state[2]});
    const CrackHalves<T> half = crack_halves(at.facet, at.now, at.stress);
    CrackLoads<T> loads = crack_loads(at.facet, at.now, half, at.stress, slip, at.friction);
    const Mask<T> bound = (s > zero) | (before.least_left() > zero);
    FacetBending<T> bending = {};
    CrackSoftening<T> of = {};
    if (any(bound)) {
        of = group.softening(cracks);
        bending = facet_bending(at.ends, of.H);
        loads.on_i = plus(loads.on_i, s, bending.torque);
        loads.on_j = minus(loads.on_j, s, bending.torque);
    }
    const CrackRoots<T> roots = crack_roots(at.facet, half, select(bound, bending.energy, zero));
    const Mask<T> treated = opposite(group.flagged(lists.flag));
    const auto of_treated = [&](T x) { return select(treated, x, zero); };
    const Vector3<T> f = {of_treated(loads.force.x), of_treated(loads.force.y), of_treated(loads.force.z)}, none = {};
    const Vector3<T> rub = loads.friction.force, e = at.now.across();
    CrackLosses<T> lost = {zero, zero};
    T across = {};  // what pulls across the cracks of a cell that may slip
    if (changes) {
        const Vector3<T> stored = {state[3], state[4], state[5]};
        const Vector3<T> now = plus(loads.friction.slip, dot(slip, e), e);
        Mask<T> falls = left.grip < before.grip;
        for (int d = 0; d < 3; d++) falls |= left.s[d] < before.s[d];
        if (any(falls | at.now.rubs)) {
            const Vector3<T> increment = select<T>(at.now.rubs, now - slip, none);
            const Vector3<T> was_rub = select<T>(at.now.rubs, stored, none);
            const CrackRoots<T> was = roots_before(at.facet, at.now, at.isotropic, half, group.pull(cracks), roots,
                                                   before, past.column + 4);
            lost = crack_losses(at.facet.k, CrackStep<T>{before, left, was, roots, was_rub, rub, increment});
        }
        // work of the force on the slip of the faces of a crack of the material
        T slid = {}, rubbed = {};
        if (any(opposite(at.now.rubs) & ((stored.x != zero) | (stored.y != zero) | (stored.z != zero)))) {
            const Vector3<T> both = group.pull(cracks) + loads.force;
            slid = select(at.now.rubs, zero, T(0.5 * dot(both, turned_by(at.ends.i, stored))));
            const Mask<T> grinds = (slid != zero) & (at.friction > zero);
            if (any(grinds)) rubbed = friction_share(at, both, of, strengths) * slid;
        }
        lost = {of_treated(lost.cracked + (slid - rubbed)), of_treated(select(at.now.rubs, lost.rubbed, rubbed))};
        across = shear_each(group, at, loads.force, treated, of, strengths, stresses, lists);
        // the spring of friction of a crack that has lost its grip is at rest at the present place of the faces
        const Mask<T> lets_go = opposite(at.now.rubs) & (left.grip == zero);
        if (any(at.now.rubs | lets_go | (state[6] > zero) | opposite(treated))) {
            const Vector3<T> beside = plus(minus(at.now.gap, dot(at.now.gap, e), e), dot(slip, e), e);
            const Vector3<T> end = select<T>(lets_go, beside, now), back = turned_by(inverse(at.ends.i), end);
            const Vector3<T> own = select<T>(at.now.rubs | lets_go, back, Vector3<T>{state[0], state[1], state[2]});
            const T kind = select(lets_go, bondem::all<T>(double(crack::let_go)), state[7]);
            const Vector3<T> point = select<T>(treated, own, none), went = select<T>(at.now.rubs, rub, stored);
            const Vector3<T> drag = select<T>(treated & opposite(lets_go), went, none);
            group.put(cracks.state, {{point.x, point.y, point.z, drag.x, drag.y, drag.z, zero,
                                      kind}});
        }
        group.put(cracks.past, {{left.s[0], left.s[1], left.s[2], left.grip, roots.along[0], roots.along[1],
                                 roots.along[2], roots.bent}});
        if (any(lost.cracked != zero)) {
            const T spent = group.number(cracks.history, 1) + lost.cracked, one = bondem::all<T>(1.0);
            group.put(cracks.history, 1, spent);
            const T slips = select(may_slip(spent, group.number(strengths.absorbed)), one, zero);
            if (any(slips != at.slips)) group.put(cracks.face, 7, slips);
        }
        const Mask<T> breaks = treated & (s == zero) & (before.least_left() > zero);
        group.flag(lists.flag, lists.flagged, portion, breaks, crack::fell, 2);
    }
    group.put_pull(cracks, f);
    const Vector3<T> p = loads.on_i, q = loads.on_j;
    group.put_halves(lists,
                     {{f.x, f.y, f.z, lost.rubbed, of_treated(p.x), of_treated(p.y), of_treated(p.z), across}},
                     {{-f.x, -f.y, -f.z, zero, of_treated(q.x), of_treated(q.y), of_treated(q.z), across}});
    group.add(lost.cracked, total);
}

// Logs the loss of all integrity of the crack of facet k.
inline void log_crack(const Clock &clock, const Moving &all, const ElasticFacets &facets, const CohesiveCracks &cracks,
                      const EventLog &log, Index k) {
    const SingleCrack one(all.pose, facets, cracks, k);
    const CrackFaces<double> &at = one.now;
    const Vector centre = {all.pose(facets.i(k), 0), all.pose(facets.i(k), 1), all.pose(facets.i(k), 2)};
    const double gap = dot(at.gap, at.across());
    const CrackHistoryRow &history = history_of(cracks, k);
    log_event(clock, log, k, gap > 0.0 ? failure_mode::tension : failure_mode::shear,
              {history.spent, gap, centre + at.arm_i, double(clock.step) - history.onset_step});
}

// Adds the elastic energies of the crack of facet k: across it, along it, and of bending [J].
inline void add_energies_of_crack(const Moving &all, const ElasticFacets &facets, const CohesiveCracks &cracks, Index k,
                                  ModeSums &sum) {
    SingleCrack one(all.pose, facets, cracks, k);
    const double *const q = state_of(cracks, k).rub;
    // its forces are those of the slip before this step
    if (!one.now.rubs) one.now.strained = one.now.strained + turned_by(one.ends.i, Vector{q[0], q[1], q[2]});
    const float *const h = softening_of(cracks, k).H;
    const CrackHalves<double> half = crack_halves(one.stiffness, one.now, one.stress);
    const CrackEnergy<double> energy = crack_energy(one.stiffness, one.now, half, Vector{q[0], q[1], q[2]});
    sum.mode[0].add(energy.across);
    sum.mode[1].add(energy.along);
    const Symmetric3<double> H = {h[0], h[1], h[2], h[3], h[4], h[5]};
    sum.mode[2].add(one.now.left.least_left() * facet_bending(one.ends, H).energy);
}

}  // namespace bondem
