// Stress-free strains of cells that change in time: levers of facets and walls, and the work of the strains.
//
// A stress-free strain ε* makes the levers of a facet 1 + ε* times as long. With the force f of the facet on cell i
// and the levers b of the reference without ε*,
//
//     ∂U/∂ε* = f · (R_j b_j - R_i b_i)
//
// The work is the trapezoid of ∂U/∂ε* over dε*. A step does nothing if no strain changes in it or in the next step.
// One step before a change ∂U/∂ε* is found, because the trapezoid needs it.
#include "cell_strains.hpp"

#include "../../registered.hpp"
#include "../boundary/timeline.hpp"
#include "strained_cells.hpp"

namespace bondem {
namespace {

using namespace strain_factor;

void stretch(const CellStrains &strains, const ElasticFacets &facets, const WallConstraints &walls) {
    for (Index k = 0; k < strains.still.size(); k++) stretch_facet(strains, facets, k);
    for (Index w = 0; w < strains.wall_still.size(); w++) stretch_wall(strains, walls, w);
}

}  // namespace

// Sets stress-free strains, and with them the levers of facets and walls, to the time of the clock.
void follow_cell_strains(const Range &range, const Timeline &timeline, const CellStrains &strains,
                         const ElasticFacets &facets, const WallConstraints &walls) {
    const bool changed = follow_factors(range.clock, timeline, strains);
    if (changed) stretch(strains, facets, walls);
    strains.due(strain_due::levers) = changed;
}
BONDEM_PASS(follow_cell_strains, of_rows, "writes arm")

void sum_strain_powers(const Range &range, const Moving &all, const CellStrains &strains,
                       const ElasticFacets &facets) {
    if (strains.due(strain_due::power))
        sum_powers(range.first, range.last, all.pose.data, strains, facets);
}
BONDEM_PASS(sum_strain_powers, of_bonds, "ends pose pose.stress")

// Finds ∂U/∂factor from the stresses in the poses, before the first step of a call.
void begin_strain_work(const Range &range, const Moving &all, const CellStrains &strains, const ElasticFacets &facets,
                       const WallConstraints &walls) {
    if (!range.clock.first) return;
    sum_powers(0, strains.still.size(), all.pose.data, strains, facets);
    take_powers(all, strains, walls);
    for (Index g = 0; g < strains.schedule.size(); g++) strains.factor(before, g) = strains.factor(after, g);
}
BONDEM_PASS(begin_strain_work, of_rows, "")

void add_strain_work(const Range &, const Moving &all, const CellStrains &strains, const WallConstraints &walls,
                     const Rows &rows) {
    if (!strains.due(strain_due::power)) return;
    const auto &factor = strains.factor;
    take_powers(all, strains, walls);
    for (Index g = 0; g < strains.schedule.size(); g++) {
        rows.work(strains.place) += 0.5 * (factor(before, g) + factor(after, g)) * factor(change, g);
        factor(before, g) = factor(after, g);
        factor(change, g) = 0.0;
    }
    strains.due(strain_due::power) = 0;
}
BONDEM_PASS(add_strain_work, of_rows, "")

}  // namespace bondem
