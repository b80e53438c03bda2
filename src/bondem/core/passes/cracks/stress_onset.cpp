// Facets that begin to crack by a function of the stress, such as Drucker and Prager's cone.
//
// Facets in tension are candidates, by σ* (`laws/agreed_stress.hpp`) with what bending opens of them added to the traction
// that pulls. The function sees σ* times f_t over that of the facet. For those that fail it is evaluated once more, of the
// mean stress of their cells: the largest principal stress over this index is the strength of the direction in which the
// facet cracks.
//
// Facets of a cell without cracks are not evaluated while the cell stays below a criterion of the core at its stress over a
// share of the strength, and at that with a tension from all sides, a share of its size and what its facets bend. For the
// function of a user the size of these stresses alone decides.
#include "stress_onset.hpp"

#include "../../laws/agreed_stress.hpp"
#include "../../laws/criteria/cone.hpp"
#include "../../laws/criteria/mean_stress.hpp"
#include "../damage/stress_criteria.hpp"
#include "single_cracks.hpp"

namespace bondem {
namespace {

// How far σ* of a facet may be beyond the stresses of its cells, over their size.
constexpr double beyond = 0.2;
constexpr double root_two = 1.4142135623730951, root_three = 1.7320508075688772;
// Share of the bound that stresses have to reach; T_b in it is that of the last step.
constexpr double near_bound = 0.8;

Stress<double> stress_of(const StressesOfCells &stresses, Index p) {
    const double *s = &stresses.tensor(p, 0);
    return {s[0], s[1], s[2], s[3], s[4], s[5]};
}
Stress<double> with_tension(const Stress<double> &s, double more) {
    return {s.xx + more, s.yy + more, s.zz + more, s.xy, s.xz, s.yz};
}
// Tension from all sides that facets of a cell may have beyond its stress [Pa].
double more_tension(const StressesOfCells &stresses, Index p, const Stress<double> &s) {
    const double bent = root(positive(stresses.tensor(p, 6))) + least(trace(s) / 3.0, 0.0);
    return beyond * root(square_of(s)) + positive(bent);
}

template <class May>
void judge_cells(const Turn &turn, const StressesOfCells &stresses, const CrackOnset &cracks, May may_reach) {
    if (!(turn.clock.dt > 0.0)) return;
    for (Index p = turn.first; p < turn.last; p++) {
        const Stress<double> s = stress_of(stresses, p);
        cracks.judged(p) = cracks.cracked(p) != 0 || may_reach(s, more_tension(stresses, p, s));
    }
}
template <class Criterion>
void judge_cells_by(const Turn &turn, const StressesOfCells &stresses, const StressFunction &by, const StressOnset &onset,
                    const CrackOnset &cracks) {
    const double scale = onset.tension / onset.hot;
    const auto reaches = [&](const Stress<double> &s) {
        if (scale * root(square_of(s)) < onset.least) return false;
        return !(Criterion::index(scale * s, by.parameter.data) < 1.0);
    };
    judge_cells(turn, stresses, cracks,
                [&](const Stress<double> &s, double more) { return reaches(s) || reaches(with_tension(s, more)); });
}

// A facet in space.
struct JudgedFacet {
    Vector normal;
    Stress<double> mean;
    double opened;  // by bending, beyond the pressure of its cells [Pa]

    JudgedFacet(const Moving &all, const ElasticFacets &facets, const FacetForces &kept, const StressesOfCells &stresses,
                Index k) {
        const Ends<double> ends = ends_of(all.pose.data, facets, k);
        normal = present_normal(ends, normal_of(facets, k));
        mean = mean_of(stress_of(stresses, facets.i(k)), stress_of(stresses, facets.j(k)));
        const double bent = bending_traction(ends, kept.bends(k), FacetColumns(facets).stiffness(k, 1.0).H);
        opened = opened_at_most(bent, mean) > 0.0 ? positive(bent - largest_pressure(principal(mean))) : 0.0;
    }
};

// Whether the stresses of a facet are far below the criterion, by bounds that need no angle.
bool is_far_below(const StressesOfCells &stresses, const StressOnset &onset, Index i, Index j, Index k, Vector t) {
    const double size = 0.5 * (stresses.tensor(i, 7) + stresses.tensor(j, 7));
    const double bends = least(stresses.tensor(i, 6), stresses.tensor(j, 6));
    const double bound = (1.0 + root_two) * size + root_two * (length(t) + root(positive(bends)));
    return onset.scale(k) * bound < near_bound * onset.least;
}

}  // namespace

void judge_cells_by_mean_stress(const Turn &turn, const StressesOfCells &stresses, const StressFunction &by,
                                const StressOnset &onset, const CrackOnset &cracks) {
    judge_cells_by<MeanStress>(turn, stresses, by, onset, cracks);
}
void judge_cells_by_cone(const Turn &turn, const StressesOfCells &stresses, const StressFunction &by,
                         const StressOnset &onset, const CrackOnset &cracks) {
    judge_cells_by<Cone>(turn, stresses, by, onset, cracks);
}
void judge_cells_by_size(const Turn &turn, const StressesOfCells &stresses, const StressOnset &onset,
                         const CrackOnset &cracks) {
    const double scale = onset.tension / onset.hot;
    judge_cells(turn, stresses, cracks, [&](const Stress<double> &s, double more) {
        return scale * (root(square_of(s)) + root_three * more) >= onset.least;
    });
}

void find_stress_candidates(const Turn &turn, const Moving &all, const ElasticFacets &facets, const FacetForces &kept,
                            const StressesOfCells &stresses, const CrackOnset &cracks, const StressOnset &onset) {
    Index next = turn.first, marked = 0;
    if (turn.clock.dt > 0.0)
        for (Index k = turn.first; k < turn.last; k++) {
            const Index i = facets.i(k), j = facets.j(k);
            const Byte judged = most(cracks.judged(i), cracks.judged(j));
            if (judged == 0 || cracks.listed(k) != 0) continue;
            if (judged == 2) {
                cracks.marked(k) = 2;
                marked++;
                continue;
            }
            const double one = 1.0 / onset.area(k);
            const Vector t = {one * kept.force(0, k), one * kept.force(1, k), one * kept.force(2, k)};
            if (is_far_below(stresses, onset, i, j, k, t)) continue;
            const JudgedFacet facet(all, facets, kept, stresses, k);
            const double across = dot(t, facet.normal), bent = facet.opened;
            const double pulled = bent > 0.0 ? positive(across) + bent : across;
            if (pulled <= 0.0) continue;
            const Stress<double> s = agreed_stress(facet.mean, facet.normal, plus(t, pulled - across, facet.normal));
            if (onset.scale(k) * root(square_of(s)) < onset.least) continue;
            next = write_candidate(onset, next, k, onset.scale(k) * s);
        }
    onset.number(turn.block) = next - turn.first;
    cracks.found(turn.block) = marked;
}

void mark_failing_facets(const Turn &, const Moving &all, const ElasticFacets &facets, const FacetForces &kept,
                         const StressesOfCells &stresses, const CrackOnset &cracks, const StressOnset &onset) {
    Index next = 0;
    for (Index c = 0; c < onset.total(0); c++) {
        if (onset.found(c) < 1.0) continue;
        const Index k = onset.bond(c);
        cracks.marked(k) = 1;
        cracks.found(k / bonds_of_portion)++;
        const JudgedFacet facet(all, facets, kept, stresses, k);
        next = write_candidate(onset, next, k, onset.scale(k) * bent_stress(facet.mean, facet.normal, facet.opened));
    }
    for (Index q = 0; q < onset.number.size(); q++) onset.number(q) = 0;
    if (next > 0) onset.number(0) = next;  // one after the other, as from one portion
}

void find_strengths_along(const Turn &, const StressOnset &onset) {
    for (Index c = 0; c < onset.total(0); c++) {
        const double *const s = onset.stress.data + 9 * c;
        const double largest = largest_of(principal(Stress<double>{s[0], s[4], s[8], s[1], s[2], s[5]}));
        const Index k = onset.bond(c);
        const double index = onset.found(c);
        // far below the criterion the index says little
        onset.along(k) = index > 0.5 && largest > 0.0 ? largest / (onset.scale(k) * index) : onset.tension / onset.scale(k);
    }
}

}  // namespace bondem
