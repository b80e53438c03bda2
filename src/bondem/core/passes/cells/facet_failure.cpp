// Facets that fail at once: they are free facets of both cells from then on, whose dilatation weighs less.
//
// With a facet its two cells change their stress, and with these the force of all their other facets. So the neighbours
// of both cells are postponed too, and the loads of all these facets are exchanged in the kept sums: taken off with the
// facets that fail, added without them. Facets are evaluated between the two passes over them, when stresses are known and
// no cell has moved; which of them are near to failure is found with the stresses of the step before.
#include "facet_failure.hpp"

#include "../../laws/criteria/elliptic.hpp"
#include "../../laws/criteria/linear_sum.hpp"
#include "../../laws/criteria/mohr_coulomb.hpp"
#include "../../laws/criteria/peripheral_stress.hpp"
#include "../damage/pipeline.hpp"
#include "walls.hpp"

namespace bondem {
namespace {

// What a cell is postponed for: a neighbour, or a facet of its own; and then whether it is listed.
enum : Byte { neighbour = 1, own = 2, listed = 3 };

Ends<double> ends_at(const double *pose, const ElasticFacets &facets, Index k) { return ends_of(pose, facets, k); }

FacetLoads<double> loads_of(const double *pose, const ElasticFacets &facets, Index k) {
    const FacetColumns columns(facets);
    const Row<double> i = gather(pose, facets.i(k)), j = gather(pose, facets.j(k));
    const double s = facets.integrity(k);
    return facet_loads(ends_of(i, j, facets.period.data), columns.shape<double>(k), columns.stiffness(k, s),
                       stresses_of(i, j, s));
}

// A criterion sees the normal and the shear force of a facet.
template <class Criterion>
Verdict<double> verdict_of(const double *pose, const ElasticFacets &facets, const Strengths &strengths, Index k) {
    const Vector f = loads_of(pose, facets, k).force, n = present_normal(ends_at(pose, facets, k), normal_of(facets, k));
    const double along = -dot(f, n), *const c = &strengths.coefficient(k, 0);
    const double across = length(plus(f, along, n));
    return Criterion::verdict(BondLoads<double>{along, across, 0.0, 0.0, 0.0, 0.0},
                              Coefficients<double>{c[0], c[1], c[2], c[3]});
}

// Calls on(k) for the facets of a cell: first those of which it is j.
template <class On> void for_each_facet_of(const FacetRelease &release, Index p, On on) {
    for (Index k = release.in_start(p); k < release.in_start(p + 1); k++) on(k);
    for (Index e = release.out_start(p); e < release.out_start(p + 1); e++) on(Index(release.out_bond(e)));
}
template <class On> void for_each_wall_of(const WallConstraints &walls, Index p, On on) {
    for (Index g = 0; g < walls.cell.size(); g++)
        if (walls.cell(g) == p) on(g);
}
Index other_cell(const ElasticFacets &facets, Index k, Index p) { return facets.i(k) != Short(p) ? facets.i(k) : facets.j(k); }

void hold_with_neighbours(const ElasticFacets &facets, const FacetRelease &release, const Postponed &postponed, Index p) {
    for_each_facet_of(release, p, [&](Index k) {
        const Index other = other_cell(facets, k, p);
        if (facets.integrity(k) > 0.0 && !is_held(postponed, other)) hold(postponed, other, neighbour);
    });
    hold(postponed, p, own);
}

template <class Criterion>
void judge_facets(const Turn &turn, const Moving &all, const ElasticFacets &facets, const FacetRelease &release,
                  const Strengths &strengths, const Candidates &candidates, const Postponed &postponed) {
    for (Index b = 0; b < candidates.count.size(); b++) {
        Turn block = turn;
        block.block = b;
        judge(
            block, candidates, [&](Index k) { return facets.integrity(k) > 0.0; },
            [&](Index k) { return verdict_of<Criterion>(all.pose.data, facets, strengths, k); },
            [&](Index k) {
                hold_with_neighbours(facets, release, postponed, facets.i(k));
                hold_with_neighbours(facets, release, postponed, facets.j(k));
            });
    }
}

template <class Criterion>
Index index_facets(const double *pose, const ElasticFacets &facets, const Strengths &strengths, const FailureIndices &found) {
    for (Index k = 0; k < strengths.station.size(); k++)
        found.index(k) = facets.integrity(k) > 0.0 ? verdict_of<Criterion>(pose, facets, strengths, k).index : 0.0;
    return 0;
}

// λ / V of a cell with the facets that it has left: those that failed open until they have no traction.
void weigh(const ElasticFacets &facets, const FacetRelease &release, Index p) {
    double inward = 0.0, outward = 0.0;
    for (Index k = release.in_start(p); k < release.in_start(p + 1); k++)
        inward += (1.0 - facets.integrity(k)) * release.slack_j(k);
    for (Index e = release.out_start(p); e < release.out_start(p + 1); e++)
        outward += (1.0 - facets.integrity(release.out_bond(e))) * release.slack_i(release.out_bond(e));
    release.weight(p) = release.whole(p) / (release.whole(p) * (inward + outward) + 1.0);
}

// Energy of dilatation of a cell [J]; its stress is brought up to date.
double dilate(const Moving &all, const ElasticFacets &facets, const WallConstraints &walls, const FacetRelease &release,
              Index p) {
    const FacetColumns columns(facets);
    double grown = release.given(p);
    for_each_wall_of(walls, p, [&](Index g) { grown += dilatation_of_hold(all.pose, all.rest, walls, g); });
    for_each_facet_of(release, p, [&](Index k) {
        const double s = facets.integrity(k);
        if (s <= 0.0) return;
        const OfCells<double> both = dilatation(ends_at(all.pose.data, facets, k), columns.shape<double>(k));
        grown += s * (facets.i(k) == Short(p) ? both.i : both.j);
    });
    all.pose(p, stress_column) = release.weight(p) * grown;
    return 0.5 * release.weight(p) * grown * grown;
}

// Takes the loads of all facets and walls of the changed cells, times a sign, off the kept sums.
void take_off_all(double sign, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                  const FacetRelease &release, const Postponed &postponed) {
    const auto row_of = [&](Index p) { return &postponed.kept(p, 0); };
    for (Index c = 0; c < release.changes(0); c++) {
        const Index p = release.changed(c);
        for_each_facet_of(release, p, [&](Index k) {
            const Index other = other_cell(facets, k, p);
            // a facet between two changed cells belongs to the one with the smaller number
            if (facets.integrity(k) <= 0.0 || (postponed.held(other) == listed && other < p)) return;
            const FacetLoads<double> loads = loads_of(all.pose.data, facets, k);
            take_off(row_of(facets.i(k)), -sign, loads.force, sign, loads.on_i);
            take_off(row_of(facets.j(k)), sign, loads.force, sign, loads.on_j);
        });
        for_each_wall_of(walls, p, [&](Index g) {
            const double *load = &walls.load(g, 0);
            take_off(row_of(p), sign, {load[0], load[1], load[2]}, sign, {load[3], load[4], load[5]});
        });
    }
}

Removal break_facet(const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                    const FacetRelease &release, Index k) {
    const FacetColumns columns(facets);
    const Index i = facets.i(k), j = facets.j(k);
    const Ends<double> ends = ends_at(all.pose.data, facets, k);
    const FacetShape<double> shape = columns.shape<double>(k);
    const OpenFacet<double> open = opened(ends, shape);
    const Vector normal = normal_of(facets, k);
    const FacetEnergy<double> parts = facet_energy(ends, shape, normal, columns.stiffness(k, 1.0));
    double energy = facets.integrity(k) * (parts.normal + parts.shear + parts.bending + parts.twisting);
    energy += dilate(all, facets, walls, release, i) + dilate(all, facets, walls, release, j);
    facets.integrity(k) = 0.0;
    weigh(facets, release, i);
    weigh(facets, release, j);
    energy -= dilate(all, facets, walls, release, i) + dilate(all, facets, walls, release, j);
    const Vector centre = {all.pose(i, 0), all.pose(i, 1), all.pose(i, 2)};
    return {energy, dot(open.gap, present_normal(ends, normal)), centre + open.arm_i};
}

}  // namespace

#define BONDEM_CRITERION(name, Criterion)                                                                             \
    void judge_facets_by_##name(const Turn &turn, const Moving &all, const ElasticFacets &facets,                     \
                                const FacetRelease &release, const Strengths &strengths, const Candidates &candidates, \
                                const Postponed &postponed) {                                                         \
        judge_facets<Criterion>(turn, all, facets, release, strengths, candidates, postponed);                        \
    }                                                                                                                 \
    Index index_facets_by_##name(Index, const Poses &all, const ElasticFacets &facets, const Strengths &strengths,    \
                                 const FailureIndices &found) {                                                       \
        return index_facets<Criterion>(all.pose.data, facets, strengths, found);                                      \
    }
BONDEM_CRITERION(peripheral_stress, PeripheralStress)
BONDEM_CRITERION(mohr_coulomb, MohrCoulomb)
BONDEM_CRITERION(linear_sum, LinearSum)
BONDEM_CRITERION(ellipse, Elliptic)
#undef BONDEM_CRITERION

void withdraw_facets(const Turn &, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                     const FacetRelease &release, const Candidates &candidates, const Postponed &postponed) {
    if (!any_fails(candidates)) return;
    Index &count = release.changes(0);
    count = 0;
    for_each_failing(candidates, [&](Index k, Index) {
        const Short ends[2] = {facets.i(k), facets.j(k)};
        for (const Short p : ends)
            if (postponed.held(p) == own) {
                postponed.held(p) = listed;
                release.changed(count++) = p;
            }
    });
    take_off_all(1.0, all, facets, walls, release, postponed);
}

void break_facets(const Turn &turn, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                  const FacetRelease &release, const Candidates &candidates, const EventLog &log) {
    remove(turn, candidates, log, [&](Index k) { return break_facet(all, facets, walls, release, k); });
}

void restore_facets(const Turn &, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                    const FacetRelease &release, const Candidates &candidates, const Postponed &postponed) {
    if (!any_fails(candidates)) return;
    for (Index c = 0; c < release.changes(0); c++)
        for_each_wall_of(walls, release.changed(c), [&](Index g) { load_hold(all.pose, all.rest, walls, g); });
    take_off_all(-1.0, all, facets, walls, release, postponed);
}

void renew_wall_rows(const Turn &, const WallConstraints &walls, const Rows &rows, const Candidates &candidates) {
    if (any_fails(candidates)) set_rows(walls, rows);
}

Index weigh_cells(Index, const ElasticFacets &facets, const FacetRelease &release) {
    for (Index p = 0; p < release.whole.size(); p++) weigh(facets, release, p);
    return 0;
}

}  // namespace bondem
