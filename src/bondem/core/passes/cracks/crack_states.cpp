// What becomes of cracks in a step: they soften, go to rest, wake, or part.
//
// A crack that is open and does not soften is a facet of less stiffness among all others, which is the same to rounding. It
// goes to rest at nine tenths of the traction at which it softens, and wakes at 0.98 of it, or where it closes. A broken
// crack whose faces no longer face each other parts: its cells touch like others from then on.
#include "crack_states.hpp"

#include "crack_lists.hpp"
#include "single_cracks.hpp"

namespace bondem {
namespace {

// By how much the integrity of a facet that softens falls in a step at most, and below what it is none.
constexpr double fastest = 0.1, nothing_left = 1e-9;
// Shares of the traction that softens at which a crack goes to rest and wakes, and of its force across it.
constexpr double asleep = 0.9, calm = 0.98, grazing = 0.1;

// Writes flags of the known places of a group.
void put_flags(const Array<Byte, 1> &flag, const Array<Index, 1> &flagged_portion, const CrackGroup &group, Index portion,
               Mask<Lanes> where, Byte value) {
    if (!any(where)) return;
    for (int n = 0; n < group.known; n++)
        if (where[n] != 0) flag(group.e + n) = value;
    flagged_portion(portion) = 1;
}

// ---- rest

struct RestingCrack {
    Vector3<Lanes> force, across;  // as if it were whole [N], and a vector along its normal
    Ends<Lanes> ends;
    Lanes area;
};
BONDEM_INLINE RestingCrack resting_crack(const CrackGroup &group, const Moving &all, const double *period,
                                         const CohesiveCracks &cracks) {
    const Row<Lanes> a = gather(all.pose.data, group.i), b = gather(all.pose.data, group.j);
    const Ends<Lanes> ends = ends_of(a, b, period);
    const CrackConstants of = constants_of(group, cracks);
    const Vector3<Lanes> gap = opened(ends, of.shape).gap;
    const Vector3<Lanes> one = turned_by(ends.i, of.shape.share_i), other = turned_by(ends.j, of.shape.share_j);
    const Vector3<Lanes> f = plus(plus(of.facet.k * gap, a.column[stress_column], one), b.column[stress_column], other);
    return {f, one + other, ends, of.area};
}

void watch_group(const CrackGroup &group, const Moving &all, const double *period,
                 const FacetStrengths &strengths, const StressesOfCells &stresses, const CohesiveCracks &cracks,
                 const CrackLists &lists, Index portion) {
    const Lanes zero = {}, endless = bondem::all<Lanes>(infinity);
    const RestingCrack now = resting_crack(group, all, period, cracks);
    const Lanes top = group.number(cracks.row, crack::row_width, crack::top), square = dot(now.force, now.force);
    const Mask<Lanes> open = dot(now.force, now.across) > grazing * root(square * dot(now.across, now.across));
    const Mask<Lanes> whole_way = top < endless;
    Mask<Lanes> wakes = opposite(open & (top > zero));
    if (any(whole_way)) {
        const CrackJudgement of = judgement_of(group, cracks);
        const Lanes bent = bending_traction(now.ends, of.bends, of.H), pull = of.area * bent;
        const Mask<Lanes> loaded = whole_way & opposite(wakes) & (root(square + pull * pull) >= calm * top);
        if (any(loaded)) {
            constexpr double near = 1.0 / calm;
            const Row<Lanes> row = group.state(cracks, 8);
            const Lanes s = row.column[crack::integrity - 8];
            const Lanes strength = group.number(cracks.row, crack::row_width, crack::strength);
            const FacetTraction<Lanes> load = {(near / of.area) * now.force, turned_by(now.ends.i, of.normal), near * bent};
            const Lanes left = integrity_left(s, load, principal(mean_stress(stresses, group.i, group.j)),
                                              strength_of(group, cracks, of, strength),
                                              CurveShape{strengths.kink, strengths.steep});
            wakes |= loaded & (left < s);
        }
    }
    put_flags(lists.waking, lists.woken, group, portion, wakes, crack::wakes);
}

// Adds what a crack that is not treated one by one does to V θ of its cells to their bases, or takes it off.
void hand_over(const SingleCrack &one, const CellDilatation &cells, const CellSlack &slack, const CohesiveCracks &cracks,
               const CrackLists &lists, Index c, double sign) {
    const double s = sign * cracks.integrity(one.facet);
    const CrackFaces<double> &at = one.now.faces;
    lists.base(cracks.i(c)) += s * dot(at.share_i, at.gap);
    lists.base(cracks.j(c)) += s * dot(at.share_j, at.gap);
    weigh_cracked(cells, slack, cracks, cracks.i(c));
    weigh_cracked(cells, slack, cracks, cracks.j(c));
}

// Puts half `number` of crack c on the list of its cell, where its order belongs.
void insert_half(const CrackLists &lists, Short p, Index number, Index c) {
    if (lists.head(p) == 0) lists.cell(lists.size(2)++) = p;
    Index before = 0, next = lists.head(p);
    while (next > 0 && lists.treated((next - 1) >> 1) > c) {
        before = next;
        next = lists.after(next);
    }
    lists.after(number) = int32_t(next);
    (before == 0 ? lists.head(p) : lists.after(before)) = int32_t(number);
}

// Treats a resting crack one by one: at the end of the list in this step, in order in the next.
void append(const SingleCrack &one, const CohesiveCracks &cracks, const CrackLists &lists, Index c) {
    const Index e = lists.size(0)++, pitch = lists.measured.shape[1];
    lists.treated(e) = c;
    lists.treated_i(e) = cracks.i(c);
    lists.treated_j(e) = cracks.j(c);
    lists.flag(e) = crack::unchanged;
    if (e % crack::of_portion == 0) lists.flagged(e / crack::of_portion) = 0;
    const CrackFaces<double> &at = one.now.faces;
    const Vector rows[7] = {at.gap, at.normal, at.share_i, at.share_j, at.arm_i, at.arm_j, at.normal_i};
    for (Index r = 0; r < 21; r++) lists.measured.data[r * pitch + e] = rows[r / 3][r % 3];
    const double s = cracks.row(c, crack::integrity);
    const FacetCompliance<double> of = one.stiffness;
    const Row<double> on_i = row_of(swelling_half(of.k, of.part, s, at.gap, at.share_i, at.normal));
    const Row<double> on_j = row_of(swelling_half(of.k, 1.0 - of.part, s, at.gap, at.share_j, at.normal));
    lists.half.row<Row<double>>(2 * e + 1) = on_i;
    lists.half.row<Row<double>>(2 * e + 2) = on_j;
    insert_half(lists, cracks.i(c), 2 * e + 1, c);
    insert_half(lists, cracks.j(c), 2 * e + 2, c);
}

void wake(const SingleCrack &one, const ElasticFacets &facets, const CohesiveCracks &cracks, const CrackLists &lists, Index c) {
    treat(facets, cracks, c, crack::active);
    append(one, cracks, lists, c);
    cracks.row(c, crack::before) = crack::fresh;
    const CrackFaces<double> &at = one.now.faces;
    const Quaternion<double> q = one.ends.i;
    put_vector(cracks, c, crack::slip,
               turned_by(Quaternion<double>{q.w, -q.x, -q.y, -q.z}, minus(at.gap, dot(at.gap, at.normal), at.normal)));
}

// ---- softening

struct SofteningGroup {
    const CrackGroup &group;
    Row<Lanes> first, second;  // the rows of the cracks
    CrackFaces<Lanes> at;  // but for levers and the normal of i
    OfCells<Lanes> stress;

    Lanes s() const { return second.column[crack::integrity - 8]; }
    Mask<Lanes> is_fresh() const { return first.column[crack::before] == bondem::all<Lanes>(crack::fresh); }
};

// Whether a crack is open, and far from closing.
BONDEM_INLINE Mask<Lanes> is_open(const FacetCompliance<Lanes> &facet, const SofteningGroup &of, Vector3<Lanes> whole) {
    const CrackHalves<Lanes> half = crack_halves(facet, of.at, of.stress);
    const Lanes zero = {};
    return (half.i.press == zero) & (half.j.press == zero) &
           (dot(whole, of.at.normal) > 2.0 * grazing * root(dot(whole, whole)));
}

// Integrities that are left, and which of the cracks are calm.
struct Softened {
    Lanes left;
    Mask<Lanes> calm;
    Lanes top;  // force below which a crack does not soften [N]
};
BONDEM_INLINE Softened softened_group(const SofteningGroup &of, Vector3<Lanes> whole, const Ends<Lanes> &ends,
                                      const FacetStrengths &strengths, const StressesOfCells &stresses, const CohesiveCracks &cracks) {
    const CrackGroup &group = of.group;
    const CurveShape curve = {strengths.kink, strengths.steep};
    const CrackJudgement facet = judgement_of(group, cracks);
    const Lanes zero = {}, s = of.s(), strength = of.first.column[crack::strength];
    const CrackStrength<Lanes> by = strength_of(group, cracks, facet, strength);
    const Symmetric3<Lanes> mean = mean_stress(stresses, group.i, group.j);
    const FacetTraction<Lanes> load = {(1.0 / facet.area) * whole, of.at.normal, bending_traction(ends, facet.bends, facet.H)};
    const Lanes opens = select(by.on_plane | (strength == zero), load.bent, opened_at_most(load.bent, mean));
    const Lanes least_traction = unsoftened_below(s, by, curve);
    Softened found = {s, root(dot(load.t, load.t) + opens * opens) < asleep * least_traction, facet.area * least_traction};
    const Mask<Lanes> busy = opposite(found.calm) & opposite(of.is_fresh()) & (s > zero);
    if (!any(busy)) return found;
    const PrincipalStress<Lanes> directions = principal(mean);
    const Mask<Lanes> at_once = (strength == zero) | (facet.brittleness == bondem::all<Lanes>(infinity));
    const Lanes most_lost = select(at_once, facet.fastest, bondem::all<Lanes>(fastest));
    Lanes left = most(integrity_left(s, load, directions, by, curve), s - most_lost);
    left = select(left < nothing_left + zero, zero, left);
    found.left = select(busy, left, s);
    const Mask<Lanes> kept = busy & (found.left == s);
    if (any(kept)) {
        constexpr double near = 1.0 / asleep;
        const FacetTraction<Lanes> more = {bondem::all<Lanes>(near) * load.t, load.normal, near * load.bent};
        found.calm |= kept & (integrity_left(s, more, directions, by, curve) == s);
    }
    return found;
}

void soften_group(const CrackGroup &group, const Moving &all, const FacetStrengths &strengths,
                  const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists, Index portion) {
    const Row<Lanes> a = gather(all.pose.data, group.i), b = gather(all.pose.data, group.j);
    const Lanes zero = {};
    SofteningGroup of = {group, group.state(cracks, 0), group.state(cracks, 8), {},
                         {a.column[stress_column], b.column[stress_column]}};
    of.at = {measured_row(lists, group.e, 0), measured_row(lists, group.e, 1), measured_row(lists, group.e, 2),
             measured_row(lists, group.e, 3), {}, {}, {}};
    const FacetCompliance<Lanes> facet = {group.number(cracks.constant, crack::constant_width, 6),
                                          group.number(cracks.constant, crack::constant_width, 7)};
    const Vector3<Lanes> whole = whole_force(facet.k, of.at, of.stress);
    const Lanes s = of.s();
    const Mask<Lanes> fresh = of.is_fresh(), known = opposite(flagged(lists.flag.data + group.e) | fresh);
    Softened now = {s, s == zero, of.second.column[crack::top - 8]};
    const Mask<Lanes> softens = known & (s > zero);
    if (any(softens)) {
        const Ends<Lanes> ends = {{}, orientation(a), orientation(b)};
        const Softened found = softened_group(of, whole, ends, strengths, stresses, cracks);
        now = {select(softens, found.left, s), (softens & found.calm) | (now.calm & opposite(softens)),
               select(softens, found.top, now.top)};
        group.put(cracks.row, crack::row_width, crack::top, now.top);
    }
    const Mask<Lanes> fell = known & (now.left < s), rests = known & opposite(fell) & now.calm & is_open(facet, of, whole);
    group.put(cracks.row, crack::row_width, crack::before, s);
    if (any(fell)) {
        group.put(cracks.row, crack::row_width, crack::integrity, now.left);
        for (int n = 0; n < group.known; n++) {
            if (fell[n] == 0) continue;
            cracks.integrity(cracks.facet(group.crack[n])) = now.left[n];
            for (Index side = 1; side <= 2; side++) lists.half(2 * (group.e + n) + side, 6) = (1.0 - now.left[n]) / facet.k[n];
        }
    }
    put_flags(lists.flag, lists.flagged, group, portion, fell, crack::fell);
    put_flags(lists.flag, lists.flagged, group, portion, rests, crack::calmed);
}

// ---- parting

// How much the stress of a cell changes with V θ, with one of its halves open [Pa/m³].
double stiffness_without(const Moving &all, const CellDilatation &cells, const CrackLists &lists, Short p, Index without) {
    double softness = 0.0;
    for (Index h = lists.head(p); h > 0; h = lists.after(h)) {
        const Row<double> &of = lists.half.row<Row<double>>(h);
        const SwellingHalf<double> half = {of.column[0], of.column[1], of.column[2], of.column[3],
                                           of.column[4], of.column[5], of.column[6], of.column[7]};
        const bool closed = h != without && half.closed + all.pose(p, stress_column) * half.pressed < 0.0;
        softness += half.loose * (closed ? half.square - half.pressed * half.along : half.square);
    }
    return cells.weight(p) / (1.0 + cells.weight(p) * softness);
}

// Energy of a broken facet whose faces no longer bear on each other: of each half that of the force that presses, less what
// its cell takes up as its stress changes by it; and that of friction [J].
double energy_of_parting(const SingleCrack &one, const Moving &all, const CellDilatation &cells, const CohesiveCracks &cracks,
                         const CrackLists &lists, Index e) {
    const Index c = lists.treated(e);
    const double k = one.stiffness.k, w = one.stiffness.part;
    const CrackHalves<double> half = crack_halves(one.stiffness, one.now.faces, one.stress(all.pose, cracks, c));
    double lost = friction_energy(k, 0.0, row_vector(cracks, c, crack::rub));
    const auto add = [&](Short p, double part, double press, Index number) {
        if (!(press < 0.0)) return;
        const double more = press / k * lists.half(number, 3);
        lost += 0.5 * (part * press * press / k - more * more * stiffness_without(all, cells, lists, p, number));
    };
    add(cracks.i(c), w, half.i.press, 2 * e + 1);
    add(cracks.j(c), 1.0 - w, half.j.press, 2 * e + 2);
    return lost;
}

// A crack is no longer treated one by one.
void leave(const ElasticFacets &facets, const CohesiveCracks &cracks, const CrackLists &lists, Index e, int status) {
    const Index c = lists.treated(e);
    treat(facets, cracks, c, status);
    if (cracks.row(c, crack::integrity) == 0.0) cracks.row(c, crack::top) = infinity;
    put_vector(cracks, c, crack::rub, {});
    put_vector(cracks, c, crack::slip, {});
    for (Index d = 0; d < 4; d++) cracks.pull(c, d) = 0.0;
    clear_half(lists, 2 * e + 1);
    clear_half(lists, 2 * e + 2);
}

}  // namespace

void watch_resting_cracks(const Turn &turn, const Moving &all, const ElasticFacets &facets, const FacetStrengths &strengths,
                          const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists) {
    if (!(turn.clock.dt > 0.0)) return;
    const Index count = lists.size(1);
    over_places(turn, count, [&](Index first, Index last, Index portion) {
        lists.woken(portion) = 0;
        for (Index e = first; e < last; e++) lists.waking(e) = crack::unchanged;
        for (Index e = first; e < last; e += lanes)
            watch_group({lists.resting, lists.resting_i, lists.resting_j, e, count}, all, facets.period.data, strengths,
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
            const Index c = lists.resting(e);
            const SingleCrack one(all.pose, facets.period.data, cracks, c);
            if (cracks.row(c, crack::integrity) == 0.0 && turned_away(one.now, one.area)) {
                treat(facets, cracks, c, crack::parted);
                cracks.row(c, crack::top) = infinity;
                continue;
            }
            wake(one, facets, cracks, lists, c);
            hand_over(one, cells, slack, cracks, lists, c, -1.0);
            lists.stale(cracks.i(c)) = lists.stale(cracks.j(c)) = 1;
        }
    }
    if (lists.size(0) > before) fill_treated(cracks, lists);
}

void soften_cracks(const Turn &turn, const Moving &all, const FacetStrengths &strengths, const StressesOfCells &stresses,
                   const CohesiveCracks &cracks, const CrackLists &lists) {
    if (!(turn.clock.dt > 0.0)) return;
    const Index count = lists.size(0);
    over_places(turn, count, [&](Index first, Index last, Index portion) {
        for (Index e = first; e < last; e += lanes)
            soften_group({lists.treated, lists.treated_i, lists.treated_j, e, count}, all, strengths, stresses, cracks, lists,
                         portion);
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
            const Index c = lists.treated(e);
            lists.stale(cracks.i(c)) = lists.stale(cracks.j(c)) = 1;
            if (flag == crack::fell) {
                lists.flag(e) = crack::unchanged;
                continue;
            }
            const SingleCrack one(all.pose, facets.period.data, cracks, c);
            if (flag == crack::parts) {
                lists.lost(q, 1) += energy_of_parting(one, all, cells, cracks, lists, e);
                leave(facets, cracks, lists, e, crack::parted);
            } else {
                leave(facets, cracks, lists, e, crack::resting);
            }
            hand_over(one, cells, slack, cracks, lists, c, 1.0);
        }
    }
}

}  // namespace bondem
