// Cracks that soften, and those at rest that wake: one crack, or as many as there are lanes.
#pragma once
#include "crack_trials.hpp"

namespace bondem {

namespace crack {
// By how much the integrity of a facet that softens falls in a step at most, and below what it is none.
constexpr double fastest = 0.1, nothing_left = 1e-9;
// Shares of the traction that softens at which a crack goes to rest and wakes, and of its force across it.
constexpr double asleep = 0.9, calm = 0.98, grazing = 0.1;
}  // namespace crack

template <class Group, class T = typename Group::Number>
BONDEM_INLINE Symmetric3<T> mean_of_cells(const Group &group, const StressesOfCells &stresses) {
    return mean_stress(gather(stresses.tensor.data, group.i), gather(stresses.tensor.data, group.j));
}

// ---- rest

// Wakes those of the cracks that would soften under their loads; `valid` names the cracks of a group of trials.
template <class Group, class T = typename Group::Number>
BONDEM_INLINE void wake_tried(const Group &group, Mask<T> valid, const CrackTrial<T> &of, const FacetStrengths &strengths,
                              const StressesOfCells &stresses, const CrackLists &lists, Index portion) {
    const PrincipalStress<T> directions = principal(mean_of_cells(group, stresses));
    const T left = integrity_left(of.s, of.load, directions, of.by(), CurveShape{strengths.kink, strengths.steep});
    group.flag(lists.waking, lists.woken, portion, valid & (left < of.s), crack::wakes);
}
template <class Group, class Trials, class T = typename Group::Number>
BONDEM_INLINE void watch_each(const Group &group, const Moving &all, const double *period,
                              const FacetStrengths &strengths, const StressesOfCells &stresses,
                              const CohesiveCracks &cracks, const CrackLists &lists, Index portion, Trials &trials) {
    group.prefetch(cracks.shape);
    const T zero = {}, endless = bondem::all<T>(infinity);
    const Row<T> a = gather(all.pose.data, group.i), b = gather(all.pose.data, group.j);
    const Ends<T> ends = ends_of(a, b, period);
    const FacetShape<T> shape = group.shapes(cracks);
    const T k = group.number(cracks.shape, 6), top = group.number(cracks.shape, 7);
    const Vector3<T> one = turned_by(ends.i, shape.share_i), other = turned_by(ends.j, shape.share_j);
    const Vector3<T> gap = opened(ends, shape).gap, across = one + other;
    const Vector3<T> f = plus(plus(k * gap, a.column[stress_column], one), b.column[stress_column], other);
    const T square = dot(f, f);
    const Mask<T> open = dot(f, across) > crack::grazing * root(square * dot(across, across));
    const Mask<T> may_soften = top < endless, wakes = opposite(open & (top > zero));
    if (any(may_soften)) {
        group.prefetch(cracks.face);
        const CrackJudgement<T> of = judgement_of(group, cracks);
        const Row<T> face = group.lines(cracks.face);
        const T area = face.column[4], s = face.column[5];
        const T bent = bending_traction(ends, of.bends, of.H), pull = area * bent;
        const Mask<T> loaded = may_soften & opposite(wakes) & (root(square + pull * pull) >= crack::calm * top);
        if (any(loaded)) {
            constexpr double near = 1.0 / crack::calm;
            const Vector3<T> normal = {face.column[0], face.column[1], face.column[2]};
            const CrackTrial<T> trial = {s, {(near / area) * f, turned_by(ends.i, normal), near * bent},
                                         of.by.tension, of.by.plane, mask_number<T>(of.by.on_plane), of.fastest, zero};
            const Mask<T> softens = loaded & opposite(never_softens(trial, strengths));
            trials.add(group, softens, trial, [&](const auto &at, auto valid, const auto &tried) {
                wake_tried(at, valid, tried, strengths, stresses, lists, portion);
            });
        }
    }
    group.flag(lists.waking, lists.woken, portion, wakes, crack::wakes);
}

// ---- softening

// Softens those of the cracks that their loads make, and puts to rest those that are calm and open.
template <class Group, class T = typename Group::Number>
BONDEM_INLINE void soften_tried(const Group &group, Mask<T> valid, const CrackTrial<T> &of,
                                const FacetStrengths &strengths, const StressesOfCells &stresses,
                                const CohesiveCracks &cracks, const CrackLists &lists, Index portion) {
    const CurveShape curve = {strengths.kink, strengths.steep};
    const T zero = {}, s = of.s;
    const CrackStrength<T> by = of.by();
    const PrincipalStress<T> directions = principal(mean_of_cells(group, stresses));
    const Mask<T> at_once = (by.tension.strength == zero) | (by.tension.brittleness == bondem::all<T>(infinity));
    const T most_lost = select(at_once, of.fastest, bondem::all<T>(crack::fastest));
    T left = most(integrity_left(s, of.load, directions, by, curve), s - most_lost);
    left = select(left < crack::nothing_left + zero, zero, left);
    const Mask<T> fell = valid & (left < s), kept = valid & (left == s);
    if (any(fell)) {
        group.where(fell, [&](Index k, Index e, int n) {
            const double now = group.lane(left, n), loose = (1.0 - now) / face_of(cracks, k).k;
            face_of(cracks, k).integrity = cracks.integrity(k) = now;
            for (Index side = 1; side <= 2; side++) lists.half(2 * e + side, 6) = loose;
        });
        group.flag(lists.flag, lists.flagged, portion, fell, crack::fell);
    }
    if (any(kept)) {
        constexpr double near = 1.0 / crack::asleep;
        const FacetTraction<T> more = {bondem::all<T>(near) * of.load.t, of.load.normal, near * of.load.bent};
        const Mask<T> calm = kept & (integrity_left(s, more, directions, by, curve) == s);
        group.flag(lists.flag, lists.flagged, portion, calm & (of.open > zero), crack::calmed);
    }
}

template <class Group, class Trials, class T = typename Group::Number>
BONDEM_INLINE void soften_each(const Group &group, const Moving &all, const FacetStrengths &strengths,
                               const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists,
                               const double *period, Index portion, Trials &trials) {
    group.prefetch(cracks.state);
    const T zero = {};
    const CrackPlace<T> at = place_of(group, all.pose, period, cracks);
    const CrackFaces<T> &faces = at.now.faces;
    const T s = at.s, before = group.number(cracks.state, 6);
    const Mask<T> fresh = before == bondem::all<T>(crack::fresh);
    const Mask<T> known = opposite(group.flagged(lists.flag) | fresh), softens = known & (s > zero);
    const Vector3<T> whole = whole_force(at.facet.k, faces, at.stress);
    // open, and far from closing
    const CrackHalves<T> half = crack_halves(at.facet, faces, at.stress);
    const Mask<T> open = (half.i.press == zero) & (half.j.press == zero) &
                         (dot(whole, faces.normal) > 2.0 * crack::grazing * root(dot(whole, whole)));
    Mask<T> calm = known & (s == zero);
    if (any(softens)) {
        const CurveShape curve = {strengths.kink, strengths.steep};
        const CrackJudgement<T> of = judgement_of(group, cracks);
        const T bent = bending_traction(at.ends, of.bends, of.H), strength = of.by.tension.strength;
        const FacetTraction<T> load = {(1.0 / at.area) * whole, faces.normal, bent};
        const T opens = select(of.by.on_plane | (strength == zero), bent,
                               opened_at_most(bent, mean_of_cells(group, stresses)));
        const T least_traction = unsoftened_below(s, of.by, curve);
        group.put(cracks.shape, 7, select(softens, T(at.area * least_traction), group.number(cracks.shape, 7)));
        const CrackTrial<T> trial = {s, load, of.by.tension, of.by.plane, mask_number<T>(of.by.on_plane), of.fastest,
                                     mask_number<T>(open)};
        CrackTrial<T> more = trial;
        constexpr double near = 1.0 / crack::asleep;
        more.load = {bondem::all<T>(near) * load.t, load.normal, near * bent};
        const Mask<T> weak = (root(dot(load.t, load.t) + opens * opens) < crack::asleep * least_traction) |
                             never_softens(more, strengths);
        calm |= softens & weak;
        trials.add(group, softens & opposite(weak), trial, [&](const auto &tried, auto valid, const auto &loads) {
            soften_tried(tried, valid, loads, strengths, stresses, cracks, lists, portion);
        });
    }
    if (any(s != before)) group.put(cracks.state, 6, s);
    group.flag(lists.flag, lists.flagged, portion, calm & open, crack::calmed);
}

}  // namespace bondem
