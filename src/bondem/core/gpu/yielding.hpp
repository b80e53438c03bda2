// Cells that yield on a device, and cracks under strains that change: a thread evaluates one cell, or brings one facet or
// wall up to date. The work of loads on free facets is in the rows of their cells.
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
// Number h of the elements that own rows, as cells with loads on free facets do.
inline void add_yielding_work_of_row(Index h, const DeviceSpan &span, const StepCut &cut, const FacetTractions &tractions,
                                     const StressesOfCells &stresses, const YieldingCells &cells, const Rows &rows) {
    if (!takes_time(span)) return;
    const Index p = cut.ready(cut.held(0) + h);
    double work = 0.0;
    for (Index l = 0; l < stresses.pressed.shape[0]; l++) work += tractions.factor(l) * yielding_work(stresses, cells, l, p);
    rows.work(rows.of(p)) += work;
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
// Keeps the levers without plastic strain where strains have set them anew.
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

BONDEM_INLINE void sum_crack_powers_of(Index b, const DeviceSpan &span, const Moving &all, const CellStrains &strains,
                                       const ElasticFacets &facets, const CohesiveCracks &cracks,
                                       const StrainPortions &portions) {
    const Index last = least((b + 1) * bonds_of_portion, span.m);
    double *const power = &portions.power(b, 0);
    for (Index g = 0; g < strains.schedule.size(); g++) power[g] = 0.0;
    for (Index k = b * bonds_of_portion; k < last; k++)
        if (is_treated(cracks, k)) add_power_of_crack(all, strains, facets, cracks, k, power);
}
inline void sum_portion_of_crack_powers(Index b, const DeviceSpan &span, const Moving &all, const CellStrains &strains,
                                        const ElasticFacets &facets, const CohesiveCracks &cracks,
                                        const StrainPortions &portions) {
    if (strains.due(strain_due::power)) sum_crack_powers_of(b, span, all, strains, facets, cracks, portions);
}
inline void begin_portion_of_crack_powers(Index b, const DeviceSpan &span, const Moving &all, const CellStrains &strains,
                                          const ElasticFacets &facets, const CohesiveCracks &cracks,
                                          const StrainPortions &portions) {
    if (clock_of(span).first) sum_crack_powers_of(b, span, all, strains, facets, cracks, portions);
}
// Adds up the portions of strain g.
inline void add_crack_powers(Index g, const CellStrains &strains, const StrainPortions &portions) {
    double sum = 0.0;
    for (Index b = 0; b < portions.power.size(); b++) sum += portions.power(b, g);
    strains.cracked(g) = sum;
}

}  // namespace bondem
