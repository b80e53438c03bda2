// Stress-free strains that change in time, on a GPU (`passes/boundary/strains.cpp`, `passes/cells/cell_strains.cpp`).
// A single thread sets the factors of the strains by their schedules, and adds up their work. Other passes have one
// thread per beam, facet or wall, or per range of facets.
#pragma once
#include "../passes/boundary/strained_beam.hpp"
#include "../passes/cells/cell_passes.hpp"
#include "../passes/cells/strained_cells.hpp"
#include "ranges.hpp"

namespace bondem {

inline void follow_strain_factors(Index, const DeviceSpan &span, const Timeline &timeline, const Strain &strain) {
    follow_factors(clock_of(span), timeline, strain);
}
inline void stretch_strained_beam(Index e, const Moving &all, const Strain &strain, const Beams &beams) {
    if (!strain.due(strain_due::power)) return;
    stretch_and_add(all, strain, beams, e, [&](Index g, double power) { exact_sum(strain.power, g).add_shared(power); });
}
inline void add_work_of_strains(Index, const DeviceSpan &span, const Strain &strain, const Rows &rows) {
    if (strain.due(strain_due::power)) add_work_of(clock_of(span), strain, rows);
}

// ---- strains of cells

inline void follow_cell_factors(Index, const DeviceSpan &span, const Timeline &timeline, const CellStrains &strains) {
    follow_factors(clock_of(span), timeline, strains);
}
inline void stretch_facet_of_step(Index k, const CellStrains &strains, const ElasticFacets &facets) {
    if (strains.due(strain_due::levers)) stretch_facet(strains, facets, k);
}
inline void stretch_wall_of_step(Index w, const CellStrains &strains, const WallConstraints &walls) {
    if (strains.due(strain_due::levers)) stretch_wall(strains, walls, w);
}
constexpr auto sum_strain_portion = portion_of_bonds<sum_strain_powers>;
inline void begin_strain_portion(Index b, const DeviceSpan &span, const Moving &all, const CellStrains &strains,
                                 const ElasticFacets &facets) {
    if (!clock_of(span).first) return;
    sum_strain_powers(portion_of(span, b, span.m), all, strains, facets);
}
inline void begin_cell_strains(Index, const DeviceSpan &span, const Moving &all, const CellStrains &strains,
                               const WallConstraints &walls) {
    double none = 0.0;
    if (clock_of(span).first) take_work(all, strains, walls, none);
}
constexpr auto add_work_of_cell_strains = once<add_strain_work>;

}  // namespace bondem
