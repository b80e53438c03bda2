// Stress-free strains of cells that change in time: levers that grow, and the work this does.
//
// A facet whose cells are larger by ε* without stress has levers 1 + ε* times as long, and with the force f of the gap
//
//     ∂U/∂ε* = f · (R_j b_j - R_i b_i)      b in the reference
//
// The work is the trapezoid of that over dε*. Steps in which nothing changes cost nothing; ∂U/∂ε* is also found one step
// before a change, because the trapezoid needs it.
#include "cell_strains.hpp"

#include "../boundary/timeline.hpp"
#include "walls.hpp"

namespace bondem {
namespace {

// Rows of the factors.
enum Factor : Index { now, came, before, after };

double growth(const CellStrains &strains, Index k) {
    double sum = strains.still(k);
    for (Index g = 0; g < strains.schedule.size(); g++) sum += strains.factor(now, g) * strains.part(g, k);
    return sum;
}
double wall_growth(const CellStrains &strains, Index w) {
    double sum = strains.wall_still(w);
    for (Index g = 0; g < strains.schedule.size(); g++) sum += strains.factor(now, g) * strains.wall_part(g, w);
    return sum;
}

void stretch(const CellStrains &strains, const ElasticFacets &facets, const WallConstraints &walls) {
    for (Index k = 0; k < strains.still.size(); k++) {
        const double grown = growth(strains, k);
        for (Index axis = 0; axis < 3; axis++) {
            facets.lever_i(axis, k) = int32_t(nearest(grown * strains.base_i(axis, k) / facets.pitch(axis)));
            facets.lever_j(axis, k) = int32_t(nearest(grown * strains.base_j(axis, k) / facets.pitch(axis)));
        }
    }
    for (Index w = 0; w < strains.wall_still.size(); w++) {
        const double grown = wall_growth(strains, w);
        for (Index axis = 0; axis < 3; axis++) walls.arm(w, axis) = grown * strains.wall_base(w, axis);
    }
}

// ∂U/∂factor of the facets first … last - 1, by the stresses in the poses.
void sum_powers(Index first, Index last, const double *pose, const CellStrains &strains, const ElasticFacets &facets,
                double *power) {
    const Index count = strains.schedule.size();
    const FacetColumns columns(facets);
    for (Index g = 0; g < count; g++) power[g] = 0.0;
    for (Index k = first; k < last; k++) {
        const double s = facets.integrity(k);
        if (s <= 0.0) continue;
        const Row<double> i = gather(pose, facets.i(k)), j = gather(pose, facets.j(k));
        const Ends<double> ends = ends_of(i, j, facets.period.data);
        const FacetShape<double> shape = columns.shape<double>(k);
        const OpenFacet<double> open = opened(ends, shape);
        const Vector f = facet_pull(ends, shape, s * facets.k(k), stresses_of(i, j, s));
        const double each = dot(f, open.arm_j - open.arm_i) / growth(strains, k);
        for (Index g = 0; g < count; g++) power[g] += each * strains.part(g, k);
    }
}

// Adds up the portions, and what walls add to them.
void sum_all_powers(const Moving &all, const CellStrains &strains, const WallConstraints &walls) {
    for (Index g = 0; g < strains.schedule.size(); g++) {
        double sum = 0.0;
        for (Index q = 0; q < strains.power.size(); q++) sum += strains.power(q, g);
        strains.factor(after, g) = sum;
    }
    for (Index w = 0; w < strains.wall_still.size(); w++) {
        const Quaternion<double> q = orientation(gather(all.pose.data, Short(walls.cell(w))));
        const Vector arm = turned_by(q, walls.arm.row<const Vector>(w));
        const Vector f = {walls.load(w, 0), walls.load(w, 1), walls.load(w, 2)};
        const double each = dot(f, arm) / wall_growth(strains, w);
        for (Index g = 0; g < strains.schedule.size(); g++) strains.factor(after, g) -= each * strains.wall_part(g, w);
    }
}

}  // namespace

void follow_cell_strains(const Turn &turn, const Timeline &timeline, const CellStrains &strains,
                         const ElasticFacets &facets, const WallConstraints &walls) {
    const Clock &clock = turn.clock;
    const auto &factor = strains.factor;
    bool changed = clock.first, needed = clock.first;
    for (Index g = 0; g < strains.schedule.size(); g++) {
        const double present = value_at(timeline, strains.schedule(g), clock.time), step = present - factor(now, g);
        factor(came, g) = clock.first ? 0.0 : step;
        factor(now, g) = present;
        changed |= step != 0.0;
        needed |= value_at(timeline, strains.schedule(g), clock.time + clock.dt) != present;
    }
    if (changed) stretch(strains, facets, walls);
    strains.due(0) = changed || needed;
}

void sum_strain_powers(const Turn &turn, const Moving &all, const CellStrains &strains, const ElasticFacets &facets) {
    if (strains.due(0)) sum_powers(turn.first, turn.last, all.pose.data, strains, facets, &strains.power(turn.block, 0));
}

void begin_strain_work(const Turn &turn, const Moving &all, const CellStrains &strains, const ElasticFacets &facets,
                       const WallConstraints &walls) {
    if (!turn.clock.first) return;
    for (Index q = 0; q < strains.power.size(); q++) {
        const Index first = q * bonds_of_portion, last = least(first + bonds_of_portion, strains.still.size());
        sum_powers(first, last, all.pose.data, strains, facets, &strains.power(q, 0));
    }
    sum_all_powers(all, strains, walls);
    for (Index g = 0; g < strains.schedule.size(); g++) strains.factor(before, g) = strains.factor(after, g);
}

void add_strain_work(const Turn &, const Moving &all, const CellStrains &strains, const WallConstraints &walls,
                     const Rows &rows) {
    if (!strains.due(0)) return;
    const auto &factor = strains.factor;
    sum_all_powers(all, strains, walls);
    for (Index g = 0; g < strains.schedule.size(); g++) {
        rows.work(strains.place) += 0.5 * (factor(before, g) + factor(after, g)) * factor(came, g);
        factor(before, g) = factor(after, g);
        factor(came, g) = 0.0;
    }
    strains.due(0) = 0;
}

}  // namespace bondem
