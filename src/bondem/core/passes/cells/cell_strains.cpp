// Stress-free strains of cells that change in time: levers of facets and walls, and the work of the strains.
//
// A stress-free strain ε* makes the levers of a facet, from the centres of its cells i and j, 1 + ε* times as long.
// With the energy U, the force f on cell i, the levers b without ε*, and the rotations R of the cells,
//
//     ∂U/∂ε* = f · (R_j b_j - R_i b_i)
#include "cell_passes.hpp"

#include "../../registered.hpp"
#include "strained_cells.hpp"

namespace bondem {
namespace {

void stretch(const CellStrains &strains, const ElasticFacets &facets, const WallConstraints &walls) {
    for (Index k = 0; k < strains.still.size(); k++) stretch_facet(strains, facets, k);
    for (Index w = 0; w < strains.wall_still.size(); w++) stretch_wall(strains, walls, w);
}

}  // namespace

// Sets stress-free strains, and with them the levers of facets and walls, to the time of the clock.
void follow_cell_strains(const Range &range, const Timeline &timeline, const CellStrains &strains,
                         const ElasticFacets &facets, const WallConstraints &walls) {
    follow_factors(range.clock, timeline, strains);
    if (strains.due(strain_due::levers)) stretch(strains, facets, walls);
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
    double none = 0.0;
    take_work(all, strains, walls, none);
}
BONDEM_PASS(begin_strain_work, of_rows, "")

void add_strain_work(const Range &, const Moving &all, const CellStrains &strains, const WallConstraints &walls,
                     const Rows &rows) {
    if (!strains.due(strain_due::power)) return;
    take_work(all, strains, walls, rows.work(strains.place));
    strains.due(strain_due::power) = 0;
}
BONDEM_PASS(add_strain_work, of_rows, "")

}  // namespace bondem
