// Softening of active cracks, whose force is computed in each step. Also detection of resting cracks, which are
// treated as facets of reduced stiffness, that become active (`crack_states.cpp`).
#pragma once
#include "resting_cracks.hpp"

namespace bondem {

namespace crack {
// Largest loss of integrity of a facet in a step whose opening grows by a share `steady` at most, its increase with
// larger growth, and the integrity that counts as zero.
constexpr double fastest = 0.1, follows = 5.0, steady = 0.2, nothing_left = 1e-9;
// Shares of the softening traction: below `asleep` an active crack becomes resting, from `calm` on a resting crack
// becomes active. Least part across a resting crack that is open, as a share of its force.
constexpr double asleep = 0.9, calm = 0.98, grazing = 0.1;
// A facet that is open along its own normal too loses its grip on traction along the crack while its faces move from
// `apart` to `far_apart`, over the distance of its cells. A brittle facet, or one whose other directions have lost
// `rubble` of their integrity, does so while it opens from `lets_go` to `has_let_go` times its last opening.
constexpr double apart = 0.05, far_apart = 0.1, lets_go = 2.0, has_let_go = 4.0, rubble = 0.5;
}  // namespace crack

template <class Group, class T = typename Group::Number>
BONDEM_INLINE Symmetric3<T> mean_of_cells(const Group &group, const StressesOfCells &stresses) {
    return mean_stress(gather_sums(stresses.tensor.data, group.i, group.j));
}

// ---- rest

// Flags the resting cracks of a group that close or are about to soften.
template <class Group, class T = typename Group::Number>
BONDEM_INLINE void watch_each(const Group &group, const Moving &all, const double *period,
                              const FacetStrengths &strengths, const CohesiveCracks &cracks, const CrackLists &lists,
                              Index portion) {
    group.prefetch(cracks.shape, cracks.frame);
    const T zero = {}, endless = bondem::all<T>(infinity);
    const Row<T> a = gather(all.pose.data, group.i), b = gather(all.pose.data, group.j);
    const Ends<T> ends = ends_of(a, b, period);
    const FacetShape<T> shape = group.shapes(cracks);
    const T k = group.number(cracks.shape, 6), top = group.number(cracks.shape, 7);
    const Row<T> frame = group.lines(cracks.frame);
    const T *const q = frame.column;
    const Vector3<T> across = axes_of(ends.i, Quaternion<T>{q[0], q[1], q[2], q[3]}).e[0];
    const Vector3<T> one = turned_by(ends.i, shape.share_i), other = turned_by(ends.j, shape.share_j);
    const Vector3<T> gap = opened(ends, shape).gap, middle = one + other;
    const Vector3<T> f = plus(plus(k * gap, a.column[stress_column], one), b.column[stress_column], other);
    const T square = dot(f, f);
    const Mask<T> open = (dot(f, across) > crack::grazing * root(square)) &
                         (dot(f, middle) > crack::grazing * root(square * dot(middle, middle)));
    const Mask<T> may_soften = top < endless;
    Mask<T> wakes = opposite(open & (top > zero));
    if (any(may_soften)) {
        group.prefetch(cracks.face);
        const CrackJudgement<T> of = judgement_of(group, cracks);
        const T area = group.number(cracks.face, 4);
        const T bent = bending_traction(ends, of.bends, of.H), pull = area * bent;
        const Mask<T> loaded = may_soften & opposite(wakes) & (root(square + pull * pull) >= crack::calm * top);
        if (any(loaded)) {
            constexpr double near = 1.0 / crack::calm;
            const FacetTraction<T> load = {(near / area) * f, across, near * bent};
            const T left = integrity_left(q[4], load, of.by, CurveShape{strengths.kink, strengths.steep});
            wakes |= loaded & (left < q[4]);
        }
    }
    group.flag(lists.waking, lists.woken, portion, wakes, crack::wakes);
}

// ---- softening

// Largest loss of integrity in a step, from the roots of energies before and now, proportional to the opening.
template <class T> BONDEM_INLINE T largest_loss(T before, T now) {
    const T grows = 1.0 - positive(before) / most(now, all<T>(1e-150));
    return most(all<T>(crack::fastest), T(crack::follows * (grows - crack::steady)));
}
template <class T> BONDEM_INLINE T fallen(T s, T left, T loss) {
    const T now = most(left, T(s - loss)), zero = {};
    return select(now < all<T>(crack::nothing_left), zero, least(s, now));
}

// Result of softening: axes of cracks, which turn before any loss along them, and integrities.
template <class T> struct Softened {
    CrackAxes<T> at;
    CrackIntegrity<T> left;
};
// Turns directions 2 and 3 into the principal directions of the stress in their plane, where both are intact.
template <class T> BONDEM_INLINE void turn_in_plane(CrackAxes<T> &at, const Symmetric3<T> &s, Mask<T> turns) {
    if (!any(turns)) return;
    const Vector3<T> a = at.e[1], b = at.e[2], sa = s * a;
    const T ab = dot(b, sa), d = 0.5 * (dot(b, s * b) - dot(a, sa)), size = absolute(d) + root(d * d + ab * ab), zero = {};
    const T t = select(turns & (size > zero), T(select(d >= zero, ab, T(-ab)) / size), zero);
    const T c = 1.0 / root(t * t + 1.0), sine = t * c;
    at.e[1] = minus(c * a, sine, b);
    at.e[2] = plus(sine * a, c, b);
}
// Motion of the faces of a crack: their slip, as the traction of a whole facet [Pa], and their distance over that of
// their cells [-], a function because few cracks need it.
template <class T, class Apart> struct FacesMoved {
    Vector3<T> slip;
    Apart apart;
};
// Softens cracks of the material under the traction t of whole facets. Slip along a crack opens it as much as opening
// across, and along a softening direction as much as a pull along it. `losses()` returns the largest loss per step of
// each direction; most cracks soften in few steps, and need none.
template <class T, class Losses, class Apart>
BONDEM_INLINE Softened<T> soften_along(const CrackFaces<T> &faces, const FacetTraction<T> &load,
                                       const Symmetric3<T> &mean, Losses losses, const Softening<T> &facet,
                                       const FacesMoved<T, Apart> &moved, const CurveShape &curve, Mask<T> away) {
    const T zero = {}, one = all<T>(1.0);
    Softened<T> found = {faces.at, faces.left};
    T *const s = found.left.s;
    turn_in_plane(found.at, mean, (s[1] == one) & (s[2] == one));
    T slope[3], pulls[3], largest = {}, pressure = {};
    for (int d = 0; d < 3; d++) {
        Vector3<T> &e = found.at.e[d];
        const Vector3<T> on = mean * e;
        const T stress = dot(e, on), along = dot(load.normal, e);
        // onset of a direction excludes the shear of the stress in these axes, which pulls at facets beside its crack
        const Mask<T> whole = s[d] == one;
        const T pull = dot(load.t, e) - select(whole, T(dot(load.normal, on) - along * stress), zero);
        const Mask<T> flips = whole & (select(stress > zero, pull, along) < zero);
        e = select<T>(flips, -e, e);
        const T slid = d == 0 ? zero : select(whole, zero, dot(moved.slip, e));
        pulls[d] = positive(T(select(flips, -pull, pull) + slid));
        slope[d] = absolute(along);
        largest = most(largest, slope[d]);
        pressure = most(pressure, -stress);
    }
    const T bent = positive(T(load.bent - pressure)) / largest;
    T opened = {}, left[3];
    Mask<T> falls = zero > one;
    for (int d = 0; d < 3; d++) {
        T pull = pulls[d];
        if (d == 0) {
            const T lost = one - s[0];
            pull = select(lost > zero, root(pull * pull + dot(moved.slip, moved.slip) / (lost * lost)), pull);
        }
        const LoadAlong<T> along = load_along(pull, T(bent * slope[d]), slope[d]);
        if (d == 0) opened = along.traction * along.share * facet.brittleness;  // over the last opening
        left[d] = select(away, zero, left_along(s[d], along, facet, curve));
        falls |= left[d] < s[d];
    }
    const Mask<T> open = (dot(load.t, load.normal) > zero) | away, loose = (s[0] == zero) & open;
    if (!any(falls | loose)) return found;
    const T by_size = (moved.apart() - crack::apart) * (1.0 / (crack::far_apart - crack::apart));
    const T by_opening = (opened - crack::lets_go) * (1.0 / (crack::has_let_go - crack::lets_go));
    const Mask<T> at_once = facet.brittleness == all<T>(infinity);
    const Mask<T> broken_up = most(s[1], s[2]) <= all<T>(1.0 - crack::rubble);
    const T far = select(at_once | broken_up, by_opening, by_size);
    const T grip = select(away, zero, select(far > zero, positive(T(one - far)), one));
    if (!any(falls | (loose & (grip < found.left.grip)))) return found;
    const Vector3<T> most_lost = losses();
    const T loss[3] = {most_lost.x, most_lost.y, most_lost.z};
    for (int d = 0; d < 3; d++) s[d] = fallen(s[d], left[d], loss[d]);
    found.left.grip = select((s[0] == zero) & open, fallen(found.left.grip, grip, loss[0]), found.left.grip);
    return found;
}
// Writes axes of crack k that have turned; the direction that has lost most becomes the first.
inline void put_turned(const Moving &all, const ElasticFacets &facets, const CohesiveCracks &cracks,
                       const CrackLists &lists, Softened<double> found, Index k) {
    CrackPastRow &past = past_of(cracks, k);
    double *const s = found.left.s;
    for (int d = 1; d < 3; d++)
        if (s[d] < s[0]) {
            exchange(s[0], s[d]);
            exchange(found.at.e[0], found.at.e[d]);
            exchange(past.left[0], past.left[d]);
            exchange(past.root[0], past.root[d]);
        }
    put_axes(cracks, k, orientation(gather(all.pose.data, facets.i(k))), found.at);
    for (int d = 0; d < 3; d++) frame_of(cracks, k).left[d] = s[d];
    const SingleCrack one(all.pose, facets, cracks, k);
    put_halves_of(lists, k, one.stiffness, one.now);
}
// Stores axes and integrities of the cracks of a group after softening.
template <class Group, class T = typename Group::Number>
BONDEM_INLINE void put_softened(const Group &group, const Moving &all, const ElasticFacets &facets,
                                const CohesiveCracks &cracks, const CrackLists &lists, const FacetCompliance<T> &facet,
                                CrackFaces<T> now, const Softened<T> &found, Mask<T> falls) {
    const T one = bondem::all<T>(1.0);
    Mask<T> turned = (now.left.s[0] == one) & (found.left.s[0] < one);
    for (int d = 1; d < 3; d++)
        turned |= ((now.left.s[d] == one) & (found.left.s[d] < one)) | (found.left.s[d] < found.left.s[0]);
    for (int d = 0; d < 3; d++) {
        now.left.s[d] = select(falls, found.left.s[d], now.left.s[d]);
        group.put(cracks.frame, 4 + d, now.left.s[d]);
    }
    now.left.grip = select(falls, found.left.grip, now.left.grip);
    group.put(cracks.frame, 7, now.left.grip);
    const HalfRows<T> i = rows_of(swelling_half(facet.k, facet.part, now, now.share_i));
    const HalfRows<T> j = rows_of(swelling_half(facet.k, T(one - facet.part), now, now.share_j));
    const T least_left = now.left.least_left();
    group.where(falls, [&](Index k, Index, int n) {
        put_integrity(cracks, k, group.lane(least_left, n));
        double *const on_i = &lists.half(half_of(k, 0), 0), *const on_j = &lists.half(half_of(k, 1), 0);
        for (int c = 0; c < 8; c++) {
            on_i[c] = group.lane(i.first.column[c], n);
            on_i[8 + c] = group.lane(i.second.column[c], n);
            on_j[c] = group.lane(j.first.column[c], n);
            on_j[8 + c] = group.lane(j.second.column[c], n);
        }
        if (lane_of(turned, n))
            put_turned(all, facets, cracks, lists, {lane_of(group, found.at, n), lane_of(group, found.left, n)}, k);
    });
}

// Softens the active cracks of a group, and flags those that may go to rest.
template <class Group, class T = typename Group::Number>
BONDEM_INLINE void soften_each(const Group &group, const Moving &all, const ElasticFacets &facets,
                               const FacetStrengths &strengths,
                               const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists,
                               Index portion) {
    const T zero = {};
    const CurveShape curve = {strengths.kink, strengths.steep};
    const CrackPlace<T> at = place_of(group, all.pose, facets.period.data, cracks);
    const CrackFaces<T> &now = at.now;
    const Mask<T> fresh = at.state.column[6] > zero, treated = opposite(group.flagged(lists.flag));
    const Mask<T> separate = (now.left.s[0] == zero) & (now.left.grip == zero);
    const Vector3<T> whole = whole_force(at.facet.k, now, at.stress);
    Mask<T> calm = treated & opposite(fresh) & separate;
    const Mask<T> softens = treated & opposite(separate);
    if (any(softens)) {
        const CrackJudgement<T> of = judgement_of(group, cracks);
        const T bent = bending_traction(at.ends, of.bends, of.H), strength = of.by.tension.strength;
        const Mask<T> at_once = (strength == zero) | (of.by.tension.brittleness == bondem::all<T>(infinity));
        const FacetTraction<T> load = {(1.0 / at.area) * whole, now.normal, bent};
        Softened<T> found = {now.at, now.left};
        // cracks of the material, except brittle ones in the step of their onset
        const Mask<T> bulk = softens & opposite(at.isotropic) & opposite(fresh & at_once);
        if (any(bulk)) {
            const auto losses = [&]() {
                const Row<T> past = group.lines(cracks.past);
                const CrackIntegrity<T> before = {{past.column[0], past.column[1], past.column[2]}, past.column[3]};
                const CrackHalves<T> half = crack_halves(at.facet, now, at.stress);
                const CrackRoots<T> roots = crack_roots(at.facet, half, zero);
                const CrackRoots<T> was =
                    roots_before(at.facet, now, at.isotropic, half, group.pull(cracks), roots, before, past.column + 4);
                const Mask<T> brittle = of.by.tension.brittleness == bondem::all<T>(infinity);
                const auto loss = [&](T a, T b) { return select(brittle, of.fastest, largest_loss(a, b)); };
                const T pull = positive(was.along[0]), first = root(pull * pull + was.bent * was.bent);
                return Vector3<T>{loss(first, roots.along[0]), loss(was.along[1], roots.along[1]),
                                  loss(was.along[2], roots.along[2])};
            };
            const T *const c = at.state.column;
            const auto apart = [&]() { return dot(now.gap, now.across()) / length(now.arm_i - now.arm_j); };
            const FacesMoved<T, decltype(apart)> moved = {
                (at.facet.k / at.area) * turned_by(at.ends.i, Vector3<T>{c[0], c[1], c[2]}), apart};
            found = soften_along(now, load, mean_of_cells(group, stresses), losses, of.by.tension, moved, curve,
                                 turned_away(now, at.area, 1.0));
        }
        const Mask<T> plane = softens & at.isotropic & opposite(fresh);
        if (any(plane)) {
            const T s = now.left.s[0], least_traction = unsoftened_below(s, of.by);
            const FacetTraction<T> own = {load.t, now.across(), bent};
            const T loss = select(at_once, of.fastest, bondem::all<T>(crack::fastest));
            const T left = fallen(s, integrity_left(s, own, of.by, curve), loss);
            group.put(cracks.shape, 7, select(plane, T(at.area * least_traction), group.number(cracks.shape, 7)));
            constexpr double near = 1.0 / crack::asleep;
            const FacetTraction<T> more = {bondem::all<T>(near) * load.t, now.across(), near * bent};
            calm |= plane & ((root(dot(load.t, load.t) + bent * bent) < crack::asleep * least_traction) |
                             (integrity_left(s, more, of.by, curve) == s));
            found.left.s[0] = select(plane, left, found.left.s[0]);
            for (int d = 1; d < 3; d++) found.left.s[d] = select(plane, now.left.s[d], found.left.s[d]);
            for (int d = 0; d < 3; d++) found.at.e[d] = select<T>(plane, now.at.e[d], found.at.e[d]);
            found.left.grip = select(plane, left, found.left.grip);
        }
        const auto fell = [&](T before, T left) { return left < before; };
        Mask<T> falls = fell(now.left.grip, found.left.grip);
        for (int d = 0; d < 3; d++) falls |= fell(now.left.s[d], found.left.s[d]);
        falls &= bulk | plane;
        if (any(falls)) {
            put_softened(group, all, facets, cracks, lists, at.facet, now, found, falls);
            group.flag(lists.flag, lists.flagged, portion, falls, crack::fell);
        }
    }
    if (!any(calm)) return;
    // open, and far from closing, along the normals of the crack and of its facet
    const CrackHalves<T> half = crack_halves(at.facet, now, at.stress);
    const T far = 2.0 * crack::grazing * root(dot(whole, whole));
    const Mask<T> open = (half.i.press() == zero) & (half.j.press() == zero) & (dot(whole, now.across()) > far) &
                         (dot(whole, now.normal) > far) & (dot(now.gap, now.normal) > zero);
    group.flag(lists.flag, lists.flagged, portion, calm & open, crack::calmed);
}

}  // namespace bondem
