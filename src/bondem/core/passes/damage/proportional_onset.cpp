// Onset and softening of facets in a body whose loads are all proportional to a load factor.
//
// A facet of a material plane begins to crack by its own traction. Any other facet has to be in tension or shear, and
// σ1 of a stress σ* (`laws/agreed_stress.hpp`) has to reach its strength. The opening of such a facet along a
// principal direction of the mean stress σ of its cells also has to be enough for softening (`laws/softening.hpp`).
// σ1 is at most |σ| + √2 (|t - σ n| + T_b), with the traction t, the normal n, the rms T_b of tractions by bending,
// and |σ|² = σ:σ.
#include "../../laws/agreed_stress.hpp"
#include "../../laws/softening.hpp"
#include "../../registered.hpp"
#include "../../tables/stress_onset_tables.hpp"
#include "stress_criteria.hpp"

namespace bondem {
namespace {

struct FacetBetween {
    Vector normal;
    Symmetric3<double> mean;  // of both cells [Pa]
    double bending;  // T_b [Pa]

    double opened(const PrincipalStress<double> &of_mean) const { return positive(bending - largest_pressure(of_mean)); }
};
FacetBetween facet_at(const LoadedFacets &loaded, Index k) {
    const auto stress = [&](Index p) { return loaded.tensor.row<const Symmetric3<double>>(p); };
    return {loaded.normal.row<const Vector>(k), mean_of(stress(loaded.i(k)), stress(loaded.j(k))), loaded.bending(k)};
}

// Traction that opens a facet along a direction, with its strength and last opening there.
struct OpenedAlong {
    double traction;  // [Pa]
    Softening<double> by;
    Vector direction;

    double factor(double s, const CurveShape &curve) const {
        const bool broken = s < 1.0 && by.brittleness == infinity;  // no integrity is left to lose
        return traction > 0.0 && !broken ? softens_at(s, by.strength, by.brittleness, curve) / traction : infinity;
    }
};
// Finds the openings along the principal directions of the mean stress, from σ3 to σ1, under a traction t; a facet of
// a plane has only the first. Returns the traction that slides a facet of a plane [Pa].
double open_along(const FacetBetween &facet, Vector t, const PrincipalStress<double> &mean, const FacetStrengths &strengths,
                  Index k, OpenedAlong *found) {
    const Softening<double> own = {strengths.strength(k), strengths.brittleness(k)};
    double largest = 0.0, bent = facet.opened(mean);
    for (const Vector &e : mean.direction) largest = most(largest, absolute(dot(facet.normal, e)));
    for (int d = 0; d < 3; d++) {
        const Vector e = mean.direction[d];
        const double slope = dot(facet.normal, e), size = absolute(slope);
        int place = 0;
        for (int o = 0; o < 3; o++) place += mean.stress[o] < mean.stress[d] || (mean.stress[o] == mean.stress[d] && o < d);
        const LoadAlong<double> load = load_along(pulled_along(t, e, slope, mean.stress[d]), bent * size / largest, size);
        found[place] = {load.traction, strength_along(own, load), e};
    }
    if (strengths.plane(k) == 0.0) return 0.0;
    const PlaneLoad<double> load = load_on_plane(t, facet.normal, facet.bending, own, strengths.friction(k), strengths.steep);
    found[0].traction = load.traction;
    found[0].by = {own.strength, load.brittleness};
    found[1].traction = found[2].traction = 0.0;
    return load.slides;
}

// Finds the opening along the one direction in which a facet softens, in the place of σ1.
void open_across(const FacetBetween &facet, Vector t, Vector across, const FacetStrengths &strengths, Index k,
                 OpenedAlong *found) {
    const double slope = absolute(dot(facet.normal, across)), bent = facet.opened(principal(facet.mean));
    const LoadAlong<double> load = load_along(positive(dot(t, across)), bent, slope);
    found[2] = {load.traction, strength_along({strengths.strength(k), strengths.brittleness(k)}, load), across};
    if (dot(t, across) <= 0.0) found[2].traction = 0.0;
    found[0] = found[1] = {0.0, found[2].by, across};
}

// Load factor at which σ1(σ*) of a facet in tension or shear reaches a strength, or inf.
double reaches(const FacetBetween &facet, Vector t, double bent, double strength) {
    const PulledTraction<double> pull = pulled_traction(t, facet.normal, bent);
    const double high = largest_of(principal(agreed_stress(facet.mean, facet.normal, pull.t)));
    if (high <= 0.0) return infinity;
    if (pull.along > 0.0) return strength / high;
    // σ1 of a compressive traction is f where t_s² = f (f - t_n)
    const double across = dot(t, facet.normal), shear = dot(t, t) - across * across;
    if (shear <= 0.0) return infinity;
    const double alone = strength * (root(pull.along * pull.along + 4.0 * shear) - pull.along) / (2.0 * shear);
    return most(strength / high, alone);
}
// Load factor at which facet k begins to crack, or inf.
double begins(const FacetBetween &facet, Vector t, const FacetStrengths &strengths, Index k) {
    const CurveShape curve = {strengths.kink, strengths.steep};
    const PrincipalStress<double> mean = principal(facet.mean);
    OpenedAlong along[3];
    const double slides = open_along(facet, t, mean, strengths, k, along);
    double softens = infinity;
    for (const OpenedAlong &one : along) softens = least(softens, one.factor(1.0, curve));
    if (strengths.plane(k) != 0.0) return least(softens, slides > 0.0 ? strengths.cohesion(k) / slides : infinity);
    return most(reaches(facet, t, facet.opened(mean), strengths.strength(k)), softens);
}

}  // namespace

// Finds the load factors at which whole facets begin to crack and to soften.
Index find_onset_factors(Index, const LoadedFacets &loaded, const FacetStrengths &strengths, const OnsetSearch &search) {
    double below = search.below;
    for (Index e = 0; e < search.whole.size(); e++) {
        const Index k = search.whole(e);
        const FacetBetween facet = facet_at(loaded, k);
        const Vector t = loaded.traction.row<const Vector>(k);
        const double lacks = root(2.0) * (length(t - facet.mean * facet.normal) + facet.bending);
        const double reach = search.spread * below * (root(square_of(facet.mean)) + lacks);
        const bool far = strengths.plane(k) == 0.0 && strengths.strength(k) >= reach;
        search.factor(e) = far ? infinity : begins(facet, t, strengths, k);
        below = least(below, search.factor(e));
    }
    return 0;
}
BONDEM_CALL(find_onset_factors, "")

// Finds the load factors at which facets lose integrity along each direction.
Index find_softening_factors(Index, const LoadedFacets &loaded, const FacetStrengths &strengths,
                             const SofteningSearch &search) {
    const CurveShape curve = {strengths.kink, strengths.steep};
    for (Index e = 0; e < search.facet.size(); e++) {
        const Index k = search.facet(e);
        const FacetBetween facet = facet_at(loaded, k);
        const Vector t = search.traction.row<const Vector>(e);
        const Vector across = search.across.row<const Vector>(e);
        const bool in_one = dot(across, across) > 0.0;
        OpenedAlong along[3];
        if (in_one)
            open_across(facet, t, across, strengths, k, along);
        else
            open_along(facet, t, principal(facet.mean), strengths, k, along);
        for (Index d = 0; d < 3; d++) {
            const OpenedAlong &one = along[d];
            search.factor(e, d) = one.factor(search.integrity(e), curve);
            const double line[3] = {one.traction, one.by.strength, 1.0 / one.by.brittleness};
            for (Index c = 0; c < 3; c++) search.line(e, d, c) = line[c], search.direction(e, d, c) = one.direction[c];
        }
        // the integrity is zero where the whole opening reaches the last one
        const double size = length(opening_part(t, facet.normal, dot(t, facet.normal))), end = 1.0 / strengths.brittleness(k);
        search.ended(e) = strengths.plane(k) == 0.0 && !in_one && size > 0.0 && end > 0.0 ? end / size : infinity;
    }
    return 0;
}
BONDEM_CALL(find_softening_factors, "")

// Finds σ* of facets, with the opening traction of bending added to their traction.
Index find_agreed_stresses(Index, const LoadedFacets &loaded, const StressCandidates &facets) {
    for (Index e = 0; e < facets.bond.size(); e++) {
        const Index k = facets.bond(e);
        const FacetBetween facet = facet_at(loaded, k);
        const Vector t = loaded.traction.row<const Vector>(k);
        const PulledTraction<double> pull = pulled_traction(t, facet.normal, facet.opened(principal(facet.mean)));
        write_candidate(facets, e, k, agreed_stress(facet.mean, facet.normal, pull.t));
    }
    return 0;
}
BONDEM_CALL(find_agreed_stresses, "")

// Cuts a softening curve into steps.
//
// A step ends where the traction exceeds the curve by the share `ripple`, or a little below the traction at onset if
// that is less. After the step the traction is below the curve by the same share. All steps together dissipate the
// energy under the curve.
Index cut_teeth(Index, const SofteningTeeth &teeth) {
    // a facet with the share `rest` of its strength at onset breaks next; the limit `below` of a softening facet is
    // less than the onset, so that it softens further before others begin, and above the last traction
    const double rest = 0.12, below = teeth.ripple > 1e-3 ? 0.999 : 1.0 - 0.5 * teeth.ripple;
    const CurveShape curve = {teeth.kink, teeth.steep};
    const double onset = teeth.onset, brittleness = 1.0 / teeth.last, band = teeth.ripple, now = most(teeth.now, onset);
    const auto bears = [&](double T) { return T * softened(1.0, T, onset, brittleness, curve); };
    Index count = 0;
    double T = now, carried = bears(T), left = (1.0 - band) * carried / T, taken = band / (1.0 - band) * left * T * T;
    for (; teeth.last > now && carried > rest * onset; count++) {
        const double before = T, s = left;
        T = least(softens_at(s / (1.0 + band), onset, brittleness, curve), below * onset / s);
        carried = bears(T);
        left = carried > rest * onset ? (1.0 - band) * carried / T : 0.0;
        if (left == 0.0) T = most(before, root(positive(absorbed_from(now, onset, teeth.last, curve) - taken) / s));
        taken += (s - left) * T * T;
        if (count >= teeth.limit.size()) continue;
        teeth.left(count) = s;
        teeth.limit(count) = T;
        teeth.beyond(count) = T / softens_at(s, onset, brittleness, curve);
    }
    teeth.number(0) = count + 1;
    return 0;
}
BONDEM_CALL(cut_teeth, "")

}  // namespace bondem
