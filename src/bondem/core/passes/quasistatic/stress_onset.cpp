// Load factors at which whole facets begin to crack by the stress of their cells, if everything is proportional to
// the factor.
//
// With σ̄ the mean stress of the two cells, t the traction of the facet, n its normal, and Δ = t - σ̄ n,
//
//     σ* = σ̄ + Δ⊗n + n⊗Δ - (Δ · n) n⊗n
//
// is the mean stress made to agree with the traction. A facet begins where σ1(σ*) reaches its strength f, where it is
// in tension or shear, and where its opening along a principal direction of σ̄ is enough for softening
// (`laws/softening.hpp`). σ1(σ*) is at most |σ̄| + √2 |Δ| with bending added to Δ, so that facets far from their
// strength are skipped.
#include "../../laws/softening.hpp"
#include "../../registered.hpp"
#include "../../tables/quasistatic_tables.hpp"

namespace bondem {
namespace {

Symmetric3<double> mean_stress(const LoadedFacets &loaded, Index k) {
    return 0.5 * loaded.tensor.row<const Symmetric3<double>>(loaded.i(k)) +
           0.5 * loaded.tensor.row<const Symmetric3<double>>(loaded.j(k));
}
// Stress σ with its traction on n increased by the vector a.
Symmetric3<double> agreeing(const Symmetric3<double> &s, Vector n, Vector more) {
    const Vector a = plus(more, -0.5 * dot(more, n), n);
    return s + 2.0 * symmetric_product(a, n);
}

// The load factor at which a facet begins to soften along a principal direction of the mean stress, or inf.
double softens(const PrincipalStress<double> &mean, Vector n, Vector t, double bent, double strength) {
    double largest = 0.0, factor = infinity;
    for (const Vector &e : mean.direction) largest = most(largest, absolute(dot(n, e)));
    for (int d = 0; d < 3; d++) {
        const Vector e = mean.direction[d];
        const double slope = dot(n, e);
        const double both = pulled_along(t, e, slope, mean.stress[d]) + bent * absolute(slope) / largest;
        if (both > 0.0) factor = least(factor, strength * most(absolute(slope), least_slope) / both);
    }
    return factor;
}

// The load factor at which a facet begins, or inf where it is never reached.
double factor_of(const Symmetric3<double> &mean, Vector n, Vector t, Vector lacks, double bending, double strength) {
    const PrincipalStress<double> principal_mean = principal(mean);
    const double across = dot(t, n), bent = most(bending - largest_pressure(principal_mean), 0.0);
    const double pulled = bent > 0.0 ? bent + most(across, 0.0) : across;
    const double high = largest_of(principal(agreeing(mean, n, plus(lacks, pulled - across, n))));
    if (high <= 0.0) return infinity;
    double reached = strength / high;
    if (pulled <= 0.0) {  // σ1 of a compressive traction is f where t_s² = f (f - t_n)
        const double shear = dot(t, t) - across * across;
        if (shear <= 0.0) return infinity;
        reached = most(reached, strength * (root(pulled * pulled + 4.0 * shear) - pulled) / (2.0 * shear));
    }
    return most(reached, softens(principal_mean, n, t, bent, strength));
}

}  // namespace

// Finds the load factors at which whole facets of the material begin to crack and to soften.
Index find_stress_factors(Index, const LoadedFacets &loaded, const OnsetSearch &search) {
    double below = search.below;
    for (Index e = 0; e < search.whole.size(); e++) {
        const Index k = search.whole(e);
        const Vector n = loaded.normal.row<const Vector>(k), t = loaded.traction.row<const Vector>(k);
        const Symmetric3<double> mean = mean_stress(loaded, k);
        const Vector lacks = t - mean * n;
        const double f = loaded.strength(k), bending = loaded.bending(k);
        const double most_of_all = root(square_of(mean)) + root(2.0) * (length(lacks) + bending);
        const bool far = f >= search.spread * below * most_of_all;
        search.factor(e) = far ? infinity : factor_of(mean, n, t, lacks, bending, f);
        below = least(below, search.factor(e));
    }
    return 0;
}
BONDEM_CALL(find_stress_factors, "")

}  // namespace bondem
