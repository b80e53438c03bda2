// Facets that begin to crack: they are pulled or sheared, and the largest principal stress of σ* reaches their
// strength.
//
// σ* is the mean stress σ of both cells made to agree with the traction t of the facet, with what bending opens of it
// (`laws/softening.hpp`) added to the traction that pulls:
//
//     σ* = σ + r⊗n + n⊗r - (r·n) n⊗n        r = t - σ n
//
// Most facets carry far less: σ1(σ*) is at most (1 + √2) |σ| + √2 (|t| + T_b).
#include "onset.hpp"

#include "../../laws/agreed_stress.hpp"
#include "single_cracks.hpp"

namespace bondem {
namespace {

constexpr double root_two = 1.4142135623730951;
// Share of the strength that the bound has to reach; T_b in it is that of the last step.
constexpr double near_strength = 0.8;

// Whether a facet of traction t begins, `bent` being what bending opens of it.
template <class T>
BONDEM_INLINE Mask<T> begins(Vector3<T> t, Vector3<T> n, const Symmetric3<T> &mean, T bent, T strength) {
    const T across = dot(t, n), zero = {}, pulled = positive(across) + bent;
    const Mask<T> opens = bent > zero;
    const Vector3<T> pull = select<T>(opens, plus(t, T(pulled - across), n), t);
    const T along = select(opens, pulled, across);
    // the traction of a pressed facet has a principal stress beyond the strength by itself
    const Mask<T> sheared = dot(pull, pull) - along * along >= strength * (strength - along);
    return ((along > zero) | sheared) & opposite(is_below(agreed_stress(mean, n, pull), strength));
}

BONDEM_INLINE Vector3<Lanes> traction_of(const FacetForces &kept, Index m, Index k, Lanes area) {
    const double *const f = kept.force.data + k;
    return (1.0 / area) * Vector3<Lanes>{load(f), load(f + m), load(f + 2 * m)};
}
BONDEM_INLINE Lanes of_cells(const StressesOfCells &stresses, const Short *i, const Short *j, Index column,
                             bool smaller) {
    Lanes all;
    for (int n = 0; n < lanes; n++) {
        const double a = stresses.tensor.data[8 * Index(i[n]) + column],
            b = stresses.tensor.data[8 * Index(j[n]) + column];
        all[n] = smaller ? least(a, b) : a + b;
    }
    return all;
}

}  // namespace

void mark_cracking_facets(const Turn &turn, const Moving &all, const ElasticFacets &facets, const FacetForces &kept,
                          const FacetStrengths &strengths, const StressesOfCells &stresses,
                          const CrackOnset &onset) {
    if (!(turn.clock.dt > 0.0)) return;
    const FacetColumns columns(facets);
    const Index m = columns.m;
    const Short *const at_i = facets.i.data, *const at_j = facets.j.data;
    const Byte *const judged = onset.judged.data;
    Index found = 0;
    const auto mark = [&](Index k, Byte how) {
        found += onset.marked(k) == 0;
        onset.marked(k) = how;
    };
    for_each_group(turn.first, turn.last, [&](Group group) {
        const Index k = group.first;
        Byte now[lanes];
        int judged_here = 0;
        for (int n = 0; n < lanes; n++) {
            now[n] = onset.listed(k + n) != 0 ? 0 : most(judged[at_i[k + n]], judged[at_j[k + n]]);
            judged_here += now[n] != 0;
        }
        if (judged_here == 0) return;
        const Lanes area = load(strengths.area.data + k), strength = load(strengths.strength.data + k);
        const Vector3<Lanes> t = traction_of(kept, m, k, area);
        const Short *const i = at_i + k, *const j = at_j + k;
        const Lanes size = of_cells(stresses, i, j, 7, false);
        const Lanes bends = of_cells(stresses, i, j, 6, true);
        const Lanes bound = (0.5 * (1.0 + root_two)) * size + root_two * (root(dot(t, t)) + root(positive(bends)));
        Mask<Lanes> begin = bound >= near_strength * strength;
        if (any(begin)) {
            const Ends<Lanes> ends = ends_of(gather(all.pose.data, i), gather(all.pose.data, j), columns.period);
            const double *const normal = facets.normal.data + k;
            const Vector3<Lanes> n = turned_by(ends.i, Vector3<Lanes>{load(normal), load(normal + m),
                                                                      load(normal + 2 * m)});
            const Symmetric3<Lanes> mean = mean_stress(stresses, i, j);
            const Symmetric3<Lanes> H = columns.stiffness<Lanes>(k, bondem::all<Lanes>(1.0)).H;
            const Lanes bent = bending_traction(ends, load(kept.bends.data + k), H), most_open = opened_at_most(bent, mean);
            // what opens is at most this; more of it never keeps a facet from cracking
            begin &= begins(t, n, mean, most_open, strength);
            if (any(begin)) {
                const Lanes open = select(most_open > Lanes{}, positive(bent - largest_pressure(principal(mean))),
                                          Lanes{});
                begin &= begins(t, n, mean, open, strength);
            }
        }
        for (int n = group.known; n < lanes; n++) {
            if (now[n] == 2)
                mark(k + n, 2);
            else if (now[n] == 1 && begin[n] != 0 && strengths.plane(k + n) == 0.0)
                mark(k + n, 1);
        }
    });
    onset.found(turn.block) = found;
}

void mark_cracking_planes(const Turn &turn, const Moving &all, const ElasticFacets &facets, const FacetForces &kept,
                          const FacetStrengths &strengths, const CrackOnset &onset) {
    if (!(turn.clock.dt > 0.0)) return;
    const FacetColumns columns(facets);
    Index found = 0;
    for (Index e = 0; e < strengths.planes.size(); e++) {
        const Index k = strengths.planes(e);
        if (onset.listed(k) != 0 || onset.marked(k) != 0) continue;
        const Ends<double> ends = ends_of(all.pose.data, facets, k);
        const double one = 1.0 / strengths.area(k);
        const Vector t = {one * kept.force(0, k), one * kept.force(1, k), one * kept.force(2, k)};
        const double bent = bending_traction(ends, kept.bends(k), columns.stiffness(k, 1.0).H);
        const Softening<double> facet = {strengths.strength(k), strengths.brittleness(k)};
        const PlaneStrength<double> plane = {strengths.cohesion(k), strengths.slip_brittleness(k),
                                             strengths.friction(k)};
        const CurveShape curve = {strengths.kink, strengths.steep};
        if (left_on_plane(1.0, t, present_normal(ends, normal_of(facets, k)), bent, facet, plane, curve) < 1.0) {
            onset.marked(k) = 1;
            found++;
        }
    }
    onset.found(onset.found.size() - 1) = found;
}

void begin_cracks(const Turn &turn, const ElasticFacets &facets, const FacetForces &kept,
                  const FacetStrengths &strengths,
                  const CrackOnset &onset, const CohesiveCracks &cracks) {
    if (!(turn.clock.dt > 0.0)) return;
    const Index portions = onset.found.size() - 1;
    const auto begin = [&](Index k) {
        cracks.order(cracks.size(0)++) = k;
        state_of(cracks, k) = {};
        state_of(cracks, k).before = crack::fresh;
        history_of(cracks, k) = {};
        softening_of(cracks, k).strength = onset.marked(k) == 1 ? strengths.strength(k) : 0.0;
        shape_of(cracks, k).top = 0.0;
        write_constants(facets, kept, strengths, cracks, k);
        for (Index d = 0; d < 3; d++) cracks.pull(k, d) = kept.force(d, k);
        treat(facets, cracks, k, crack::active);
        onset.cracked(facets.i(k)) = onset.cracked(facets.j(k)) = 1;
        onset.marked(k) = 0;
    };
    const bool on_planes = onset.found(portions) > 0;
    for (Index q = 0; q < portions; q++) {
        if (onset.found(q) == 0 && !on_planes) continue;
        const Index first = q * bonds_of_portion, last = least(first + bonds_of_portion, onset.marked.size());
        for (Index k = first; k < last; k++)
            if (onset.marked(k) != 0) begin(k);
        onset.found(q) = 0;
    }
    onset.found(portions) = 0;
}

}  // namespace bondem
