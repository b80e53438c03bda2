// What becomes of cracks in a step: they soften, go to rest, wake, or part.
//
// A crack that is open and does not soften is a facet of less stiffness among all others, which is the same to
// rounding. It goes to rest at nine tenths of the traction at which it softens, and wakes at 0.98 of it, or where it
// closes. A broken crack whose faces no longer face each other parts: its cells touch like others from then on.
#include "crack_states.hpp"

#include "crack_lists.hpp"
#include "single_cracks.hpp"

namespace bondem {
namespace {

// By how much the integrity of a facet that softens falls in a step at most, and below what it is none.
constexpr double fastest = 0.1, nothing_left = 1e-9;
// Shares of the traction that softens at which a crack goes to rest and wakes, and of its force across it.
constexpr double asleep = 0.9, calm = 0.98, grazing = 0.1;

// ---- rest

void watch_group(const CrackGroup &group, const Moving &all, const double *period, const FacetStrengths &strengths,
                 const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists,
                     Index portion) {
    group.prefetch(cracks.shape);
    const Lanes zero = {}, endless = bondem::all<Lanes>(infinity);
    const Row<Lanes> a = gather(all.pose.data, group.i), b = gather(all.pose.data, group.j);
    const Ends<Lanes> ends = ends_of(a, b, period);
    const FacetShape<Lanes> shape = shapes_of(group, cracks);
    const Lanes k = group.number(cracks.shape, 6), top = group.number(cracks.shape, 7);
    const Vector3<Lanes> one = turned_by(ends.i, shape.share_i), other = turned_by(ends.j, shape.share_j);
    const Vector3<Lanes> gap = opened(ends, shape).gap, across = one + other;
    const Vector3<Lanes> f = plus(plus(k * gap, a.column[stress_column], one), b.column[stress_column], other);
    const Lanes square = dot(f, f);
    const Mask<Lanes> open = dot(f, across) > grazing * root(square * dot(across, across));
    const Mask<Lanes> may_soften = top < endless;
    Mask<Lanes> wakes = opposite(open & (top > zero));
    if (any(may_soften)) {
        group.prefetch(cracks.face);
        const CrackJudgement of = judgement_of(group, cracks);
        const Row<Lanes> face = group.lines(cracks.face);
        const Lanes area = face.column[4], s = face.column[5];
        const Lanes bent = bending_traction(ends, of.bends, of.H), pull = area * bent;
        const Mask<Lanes> loaded = may_soften & opposite(wakes) & (root(square + pull * pull) >= calm * top);
        if (any(loaded)) {
            constexpr double near = 1.0 / calm;
            const Vector3<Lanes> normal = {face.column[0], face.column[1], face.column[2]};
            const FacetTraction<Lanes> load = {(near / area) * f, turned_by(ends.i, normal), near * bent};
            const PrincipalStress<Lanes> directions = principal(mean_stress(stresses, group.i, group.j));
            const Lanes left = integrity_left(s, load, directions, of.by, CurveShape{strengths.kink, strengths.steep});
            wakes |= loaded & (left < s);
        }
    }
    put_flags(lists.waking, lists.woken, group, portion, wakes, crack::wakes);
}

// Adds what the crack of facet k, which is not treated one by one, does to V θ of its cells to their bases, or takes
// it off.
void hand_over(const SingleCrack &one, const ElasticFacets &facets, const CellDilatation &cells,
               const CellSlack &slack,
               const CohesiveCracks &cracks, const CrackLists &lists, Index k, double sign) {
    const Short i = facets.i(k), j = facets.j(k);
    const double s = sign * cracks.integrity(k);
    const CrackFaces<double> &at = one.now.faces;
    lists.base(i) += s * dot(at.share_i, at.gap);
    lists.base(j) += s * dot(at.share_j, at.gap);
    weigh_cracked(cells, slack, cracks, i);
    weigh_cracked(cells, slack, cracks, j);
    lists.stale(i) = lists.stale(j) = 1;
}

// Puts half `number` of the crack of facet k on the list of its cell, where its order belongs.
void insert_half(const CrackLists &lists, Short p, Index number, Index k, const int32_t *lever) {
    if (lists.head(p) == 0) lists.cell(lists.size(2)++) = p;
    Index before = 0, next = lists.head(p);
    while (next > 0 && lists.treated((next - 1) >> 1) > k) {
        before = next;
        next = lists.node(next, 0);
    }
    put_node(lists, number, next, lever);
    (before == 0 ? lists.head(p) : lists.node(before, 0)) = int32_t(number);
}

// Treats a resting crack one by one: at the end of the list in this step, in order in the next.
void wake(const SingleCrack &one, const ElasticFacets &facets, const CohesiveCracks &cracks, const CrackLists &lists,
          Index k) {
    treat(facets, cracks, k, crack::active);
    const Index e = lists.size(0)++;
    lists.treated(e) = k;
    lists.treated_i(e) = facets.i(k);
    lists.treated_j(e) = facets.j(k);
    lists.flag(e) = crack::unchanged;
    if (e % crack::of_portion == 0) lists.flagged(e / crack::of_portion) = 0;
    const CrackFaces<double> &at = one.now.faces;
    const SwellingHalves<double> half = swelling_halves(one.stiffness, one.s, at);
    lists.half.row<Row<double>>(2 * e + 1) = row_of(half.i);
    lists.half.row<Row<double>>(2 * e + 2) = row_of(half.j);
    insert_half(lists, facets.i(k), 2 * e + 1, k, shape_of(cracks, k).lever_i);
    insert_half(lists, facets.j(k), 2 * e + 2, k, shape_of(cracks, k).lever_j);
    CrackStateRow &state = state_of(cracks, k);
    state.before = crack::fresh;
    const Vector slip = turned_by(inverse(one.ends.i), minus(at.gap, dot(at.gap, at.normal), at.normal));
    for (int d = 0; d < 3; d++) state.slip[d] = slip[d];
}

// ---- softening

// Integrities that are left, and which of the cracks are calm.
struct Softened {
    Lanes left;
    Mask<Lanes> calm;
    Lanes top;  // force below which a crack does not soften [N]
};
BONDEM_INLINE Softened softened_group(const CrackGroup &group, const CrackPlace &at, Vector3<Lanes> whole,
                                      Mask<Lanes> softens, const FacetStrengths &strengths,
                                      const StressesOfCells &stresses, const CohesiveCracks &cracks) {
    const CurveShape curve = {strengths.kink, strengths.steep};
    const CrackJudgement of = judgement_of(group, cracks);
    const Lanes zero = {}, s = at.s, strength = of.by.tension.strength;
    const Symmetric3<Lanes> mean = mean_stress(stresses, group.i, group.j);
    const Lanes bent = bending_traction(at.ends, of.bends, of.H);
    const FacetTraction<Lanes> load = {(1.0 / at.area) * whole, at.now.faces.normal, bent};
    const Lanes opens = select(of.by.on_plane | (strength == zero), load.bent, opened_at_most(load.bent, mean));
    const Lanes least_traction = unsoftened_below(s, of.by, curve);
    Softened found = {s, root(dot(load.t, load.t) + opens * opens) < asleep * least_traction,
                      at.area * least_traction};
    const Mask<Lanes> busy = softens & opposite(found.calm);
    if (!any(busy)) return found;
    const PrincipalStress<Lanes> directions = principal(mean);
    const Mask<Lanes> at_once = (strength == zero) | (of.by.tension.brittleness == bondem::all<Lanes>(infinity));
    const Lanes most_lost = select(at_once, of.fastest, bondem::all<Lanes>(fastest));
    Lanes left = most(integrity_left(s, load, directions, of.by, curve), s - most_lost);
    left = select(left < nothing_left + zero, zero, left);
    found.left = select(busy, left, s);
    const Mask<Lanes> kept = busy & (found.left == s);
    if (any(kept)) {
        constexpr double near = 1.0 / asleep;
        const FacetTraction<Lanes> more = {bondem::all<Lanes>(near) * load.t, load.normal, near * load.bent};
        found.calm |= kept & (integrity_left(s, more, directions, of.by, curve) == s);
    }
    return found;
}

void soften_group(const CrackGroup &group, const Moving &all, const FacetStrengths &strengths,
                  const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists,
                  const double *period, Index portion) {
    group.prefetch(cracks.state);
    const Lanes zero = {};
    const CrackPlace at = place_of(group, all.pose, period, cracks);
    const CrackFaces<Lanes> &faces = at.now.faces;
    const Lanes s = at.s, before = group.number(cracks.state, 6);
    const Mask<Lanes> fresh = before == bondem::all<Lanes>(crack::fresh);
    const Mask<Lanes> known = opposite(flagged(lists.flag.data + group.e) | fresh), softens = known & (s > zero);
    const Vector3<Lanes> whole = whole_force(at.facet.k, faces, at.stress);
    Lanes left = s;
    Mask<Lanes> is_calm = s == zero;
    if (any(softens)) {
        const Softened found = softened_group(group, at, whole, softens, strengths, stresses, cracks);
        left = select(softens, found.left, s);
        is_calm |= softens & found.calm;
        group.put(cracks.shape, 7, select(softens, found.top, group.number(cracks.shape, 7)));
    }
    if (any(s != before)) group.put(cracks.state, 6, s);
    const Mask<Lanes> fell = known & (left < s), rests = known & opposite(fell) & is_calm;
    if (any(fell)) {
        group.put(cracks.face, 5, left);
        for (int n = 0; n < group.known; n++) {
            if (fell[n] == 0) continue;
            cracks.integrity(group.crack[n]) = left[n];
            for (Index side = 1; side <= 2; side++)
                lists.half(2 * (group.e + n) + side, 6) = (1.0 - left[n]) / at.facet.k[n];
        }
        put_flags(lists.flag, lists.flagged, group, portion, fell, crack::fell);
    }
    if (any(rests)) {  // where they are open, and far from closing
        const CrackHalves<Lanes> half = crack_halves(at.facet, faces, at.stress);
        const Mask<Lanes> open = (half.i.press == zero) & (half.j.press == zero) &
                                 (dot(whole, faces.normal) > 2.0 * grazing * root(dot(whole, whole)));
        put_flags(lists.flag, lists.flagged, group, portion, rests & open, crack::calmed);
    }
}

// ---- parting

// How much the stress of a cell changes with V θ, with one of its halves open [Pa/m³].
double stiffness_without(const Moving &all, const CellDilatation &cells, const CrackLists &lists, Short p,
                         Index without) {
    double softness = 0.0;
    for (Index h = lists.head(p); h > 0; h = lists.node(h, 0)) {
        const Row<double> &of = lists.half.row<Row<double>>(h);
        const SwellingHalf<double> half = {of.column[0], of.column[1], of.column[2], of.column[3],
                                           of.column[4], of.column[5], of.column[6], of.column[7]};
        const bool closed = h != without && half.closed + all.pose(p, stress_column) * half.pressed < 0.0;
        softness += half.loose * (closed ? half.square - half.pressed * half.along : half.square);
    }
    return cells.weight(p) / (1.0 + cells.weight(p) * softness);
}

// Energy of a broken facet whose faces no longer press on each other: of each half that of the force that presses,
// less the elastic energy that its cell gains from the change of its stress; and that of friction [J].
double energy_of_parting(const SingleCrack &one, const Moving &all, const CellDilatation &cells,
                         const ElasticFacets &facets,
                         const CohesiveCracks &cracks, const CrackLists &lists, Index e) {
    const Index at = lists.treated(e);
    const double *const rub = state_of(cracks, at).rub;
    const double k = one.stiffness.k, w = one.stiffness.part;
    const CrackHalves<double> half = crack_halves(one.stiffness, one.now.faces, one.stress);
    double lost = friction_energy(k, 0.0, Vector{rub[0], rub[1], rub[2]});
    const auto add = [&](Short p, double part, double press, Index number) {
        if (!(press < 0.0)) return;
        const double more = press / k * lists.half(number, 3);
        lost += 0.5 * (part * press * press / k - more * more * stiffness_without(all, cells, lists, p, number));
    };
    add(facets.i(at), w, half.i.press, 2 * e + 1);
    add(facets.j(at), 1.0 - w, half.j.press, 2 * e + 2);
    return lost;
}

// A crack is no longer treated one by one.
void leave(const ElasticFacets &facets, const CohesiveCracks &cracks, const CrackLists &lists, Index e, int status) {
    const Index k = lists.treated(e);
    treat(facets, cracks, k, status);
    if (face_of(cracks, k).integrity == 0.0) shape_of(cracks, k).top = infinity;
    CrackStateRow &state = state_of(cracks, k);
    for (int d = 0; d < 3; d++) state.slip[d] = state.rub[d] = 0.0;
    for (Index d = 0; d < 4; d++) cracks.pull(k, d) = 0.0;
    clear_half(lists, 2 * e + 1);
    clear_half(lists, 2 * e + 2);
}

}  // namespace

void watch_resting_cracks(const Turn &turn, const Moving &all, const ElasticFacets &facets,
                          const FacetStrengths &strengths,
                          const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists) {
    if (!(turn.clock.dt > 0.0)) return;
    const Index count = lists.size(1);
    over_places(turn, count, [&](Index first, Index last, Index portion) {
        lists.woken(portion) = 0;
        for (Index e = first; e < last; e++) lists.waking(e) = crack::unchanged;
        for (Index e = first; e < last; e += lanes)
            watch_group({lists.resting, lists.resting_i, lists.resting_j, e, count}, all, facets.period.data,
                        strengths,
                        stresses, cracks, lists, portion);
    });
}

void wake_cracks(const Turn &turn, const Moving &all, const ElasticFacets &facets, const CellDilatation &cells,
                 const CellSlack &slack, const CohesiveCracks &cracks, const CrackLists &lists) {
    if (!(turn.clock.dt > 0.0)) return;
    const Index count = lists.size(1), before = lists.size(0);
    for (Index q = 0; q < portions(count, crack::of_portion); q++) {
        if (lists.woken(q) == 0) continue;
        for (Index e = q * crack::of_portion; e < least(count, (q + 1) * crack::of_portion); e++) {
            if (lists.waking(e) != crack::wakes) continue;
            const Index k = lists.resting(e);
            const SingleCrack one(all.pose, facets, cracks, k);
            if (one.s == 0.0 && turned_away(one.now, one.area)) {
                treat(facets, cracks, k, crack::parted);
                shape_of(cracks, k).top = infinity;
                lists.parted(lists.size(3)++) = k;
                continue;
            }
            wake(one, facets, cracks, lists, k);
            hand_over(one, facets, cells, slack, cracks, lists, k, -1.0);
        }
    }
    if (lists.size(0) > before) fill_treated(lists);
}

void soften_cracks(const Turn &turn, const Moving &all, const ElasticFacets &facets, const FacetStrengths &strengths,
                   const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists) {
    if (!(turn.clock.dt > 0.0)) return;
    over_treated(turn, lists, [](Index, Index, Index) {},
                 [&](const CrackGroup &group, Index portion) {
                     soften_group(group, all, strengths, stresses, cracks, lists, facets.period.data, portion);
                 });
}

void leave_cracks(const Turn &turn, const Moving &all, const ElasticFacets &facets, const CellDilatation &cells,
                  const CellSlack &slack, const CohesiveCracks &cracks, const CrackLists &lists) {
    if (!(turn.clock.dt > 0.0)) return;
    const Index count = lists.size(0);
    for (Index q = 0; q < portions(count, crack::of_portion); q++) {
        lists.lost(q, 1) = 0.0;
        if (lists.flagged(q) == 0) continue;
        for (Index e = q * crack::of_portion; e < least(count, (q + 1) * crack::of_portion); e++) {
            const Byte flag = lists.flag(e);
            if (flag == crack::unchanged) continue;
            const Index k = lists.treated(e);
            if (flag == crack::fell) {
                lists.stale(facets.i(k)) = lists.stale(facets.j(k)) = 1;
                lists.flag(e) = crack::unchanged;
                continue;
            }
            const SingleCrack one(all.pose, facets, cracks, k);
            if (flag == crack::parts) {
                lists.lost(q, 1) += energy_of_parting(one, all, cells, facets, cracks, lists, e);
                leave(facets, cracks, lists, e, crack::parted);
                lists.parted(lists.size(3)++) = k;
            } else {
                leave(facets, cracks, lists, e, crack::resting);
            }
            hand_over(one, facets, cells, slack, cracks, lists, k, 1.0);
        }
    }
}

}  // namespace bondem
