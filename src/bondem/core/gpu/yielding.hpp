// Yielding of cells on a GPU, and its effect on the vectors (levers) from the centre of a cell to facets, walls and
// cracks. Also the work of loads on free facets as cells yield, and of stress-free strains at cracks. Passes have one
// thread per cell, facet or wall.
#pragma once
#include "../passes/cracks/strained_cracks.hpp"
#include "../passes/cracks/yielding_cells.hpp"
#include "crack_onset.hpp"
#include "strains.hpp"

namespace bondem {

// ---- flow

inline void yield_cell(Index p, const DeviceSpan &span, const Moving &all, const StressesOfCells &stresses,
                       const YieldingCells &cells, const CrackOnset &onset) {
    if (!takes_time(span)) return;
    where_yields(stresses, cells, onset, p, [&](const YieldStrength<double> &by) {
        flow(all, stresses, cells, p, flow_under(tensor_of(stresses, p), by, cells.cone != 0));
    });
}
// Adds the work of loads on free facets of cell number h of those that own rows of the boundary.
inline void add_yielding_work_of_row(Index h, const DeviceSpan &span, const StepBlocks &blocks,
                                     const FacetTractions &tractions, const StressesOfCells &stresses,
                                     const YieldingCells &cells, const Rows &rows) {
    if (!takes_time(span)) return;
    add_yielding_work_of(tractions, stresses, cells, rows, blocks.ready(blocks.first_owner(0) + h));
}
constexpr auto sum_portion_of_heat = portion_of_elements<sum_heat>;

// ---- levers of facets, walls and cracks with the plastic deformation of their cells

inline void stretch_yielded_cell(Index p, const ElasticFacets &facets, const FacetsOfCells &of_cells,
                                 const YieldingCells &cells) {
    if (has_yielded(cells, p)) stretch_cell(facets, of_cells, cells, p);
}
inline void stretch_growing_cell(Index p, const DeviceSpan &span, const ElasticFacets &facets,
                                 const FacetsOfCells &of_cells, const YieldingCells &cells) {
    if (takes_time(span) && grows(cells, p)) stretch_cell(facets, of_cells, cells, p);
}
inline void stretch_wall_of_cell(Index g, const DeviceSpan &span, const WallConstraints &walls, const YieldingCells &cells) {
    if (takes_time(span)) stretch_yielding_wall(walls, cells, g);
}
inline void stretch_crack_of_cells(Index k, const DeviceSpan &span, const ElasticFacets &facets, const YieldingCells &cells,
                                   const CohesiveCracks &cracks) {
    if (takes_time(span) && cracks.listed(k) != 0) stretch_crack(facets, cells, cracks, k);
}
// Keeps the levers without plastic strain where strains have changed them.
inline void keep_base_levers(Index k, const CellStrains &strains, const ElasticFacets &facets, const YieldingCells &cells) {
    if (!strains.due(strain_due::levers)) return;
    for (Index d = 0; d < 3; d++) {
        cells.base_i(d, k) = facets.lever_i(d, k);
        cells.base_j(d, k) = facets.lever_j(d, k);
    }
}
inline void stretch_cell_anew(Index p, const CellStrains &strains, const ElasticFacets &facets,
                              const FacetsOfCells &of_cells, const YieldingCells &cells) {
    if (strains.due(strain_due::levers)) stretch_yielded_cell(p, facets, of_cells, cells);
}
inline void stretch_wall_anew(Index g, const CellStrains &strains, const WallConstraints &walls, const YieldingCells &cells) {
    if (strains.due(strain_due::levers)) stretch_from_present(walls, cells, g);
}

// ---- work of strains at cracks

inline void add_crack_power(Index k, const Moving &all, const CellStrains &strains, const ElasticFacets &facets,
                            const CohesiveCracks &cracks) {
    if (strains.due(strain_due::power) && is_treated(cracks, k)) add_power_of_crack(all, strains, facets, cracks, k);
}
inline void begin_crack_power(Index k, const DeviceSpan &span, const Moving &all, const CellStrains &strains,
                              const ElasticFacets &facets, const CohesiveCracks &cracks) {
    if (clock_of(span).first && is_treated(cracks, k)) add_power_of_crack(all, strains, facets, cracks, k);
}

}  // namespace bondem
