// Cracks that soften, and those at rest that wake: one crack, or as many as there are lanes.
#pragma once
#include "crack_places.hpp"

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

template <class Group, class T = typename Group::Number>
BONDEM_INLINE void watch_each(const Group &group, const Moving &all, const double *period,
                              const FacetStrengths &strengths, const StressesOfCells &stresses,
                              const CohesiveCracks &cracks, const CrackLists &lists, Index portion) {
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
    const Mask<T> may_soften = top < endless;
    Mask<T> wakes = opposite(open & (top > zero));
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
            const FacetTraction<T> load = {(near / area) * f, turned_by(ends.i, normal), near * bent};
            const PrincipalStress<T> directions = principal(mean_of_cells(group, stresses));
            const T left = integrity_left(s, load, directions, of.by, CurveShape{strengths.kink, strengths.steep});
            wakes |= loaded & (left < s);
        }
    }
    group.flag(lists.waking, lists.woken, portion, wakes, crack::wakes);
}

// ---- softening

// Integrities that are left, and which of the cracks are calm.
template <class T> struct Softened {
    T left;
    Mask<T> calm;
    T top;  // force below which a crack does not soften [N]
};
template <class Group, class T = typename Group::Number>
BONDEM_INLINE Softened<T> softened_cracks(const Group &group, const CrackPlace<T> &at, Vector3<T> whole,
                                          Mask<T> softens, const FacetStrengths &strengths,
                                          const StressesOfCells &stresses, const CohesiveCracks &cracks) {
    const CurveShape curve = {strengths.kink, strengths.steep};
    const CrackJudgement<T> of = judgement_of(group, cracks);
    const T zero = {}, s = at.s, strength = of.by.tension.strength;
    const Symmetric3<T> mean = mean_of_cells(group, stresses);
    const T bent = bending_traction(at.ends, of.bends, of.H);
    const FacetTraction<T> load = {(1.0 / at.area) * whole, at.now.faces.normal, bent};
    const T opens = select(of.by.on_plane | (strength == zero), load.bent, opened_at_most(load.bent, mean));
    const T least_traction = unsoftened_below(s, of.by, curve);
    Softened<T> found = {s, root(dot(load.t, load.t) + opens * opens) < crack::asleep * least_traction,
                         at.area * least_traction};
    const Mask<T> busy = softens & opposite(found.calm);
    if (!any(busy)) return found;
    const PrincipalStress<T> directions = principal(mean);
    const Mask<T> at_once = (strength == zero) | (of.by.tension.brittleness == bondem::all<T>(infinity));
    const T most_lost = select(at_once, of.fastest, bondem::all<T>(crack::fastest));
    T left = most(integrity_left(s, load, directions, of.by, curve), s - most_lost);
    left = select(left < crack::nothing_left + zero, zero, left);
    found.left = select(busy, left, s);
    const Mask<T> kept = busy & (found.left == s);
    if (any(kept)) {
        constexpr double near = 1.0 / crack::asleep;
        const FacetTraction<T> more = {bondem::all<T>(near) * load.t, load.normal, near * load.bent};
        found.calm |= kept & (integrity_left(s, more, directions, of.by, curve) == s);
    }
    return found;
}

template <class Group, class T = typename Group::Number>
BONDEM_INLINE void soften_each(const Group &group, const Moving &all, const FacetStrengths &strengths,
                               const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists,
                               const double *period, Index portion) {
    group.prefetch(cracks.state);
    const T zero = {};
    const CrackPlace<T> at = place_of(group, all.pose, period, cracks);
    const CrackFaces<T> &faces = at.now.faces;
    const T s = at.s, before = group.number(cracks.state, 6);
    const Mask<T> fresh = before == bondem::all<T>(crack::fresh);
    const Mask<T> known = opposite(group.flagged(lists.flag) | fresh), softens = known & (s > zero);
    const Vector3<T> whole = whole_force(at.facet.k, faces, at.stress);
    T left = s;
    Mask<T> is_calm = s == zero;
    if (any(softens)) {
        const Softened<T> found = softened_cracks(group, at, whole, softens, strengths, stresses, cracks);
        left = select(softens, found.left, s);
        is_calm |= softens & found.calm;
        group.put(cracks.shape, 7, select(softens, found.top, group.number(cracks.shape, 7)));
    }
    if (any(s != before)) group.put(cracks.state, 6, s);
    const Mask<T> fell = known & (left < s), rests = known & opposite(fell) & is_calm;
    if (any(fell)) {
        group.put(cracks.face, 5, left);
        group.where(fell, [&](Index k, Index e, int n) {
            cracks.integrity(k) = group.lane(left, n);
            for (Index side = 1; side <= 2; side++)
                lists.half(2 * e + side, 6) = (1.0 - group.lane(left, n)) / group.lane(at.facet.k, n);
        });
        group.flag(lists.flag, lists.flagged, portion, fell, crack::fell);
    }
    if (any(rests)) {  // where they are open, and far from closing
        const CrackHalves<T> half = crack_halves(at.facet, faces, at.stress);
        const Mask<T> open = (half.i.press == zero) & (half.j.press == zero) &
                             (dot(whole, faces.normal) > 2.0 * crack::grazing * root(dot(whole, whole)));
        group.flag(lists.flag, lists.flagged, portion, rests & open, crack::calmed);
    }
}

}  // namespace bondem
