// Strains that change, on a device: one thread updates the factors, a thread stretches one facet or computes one
// portion, and one thread adds up the work (`passes/boundary/strains.cpp`, `passes/cells/cell_strains.cpp`).
#pragma once
#include "../passes/boundary/strained_beam.hpp"
#include "../passes/boundary/timeline.hpp"
#include "../passes/cells/cell_strains.hpp"
#include "../passes/cells/strained_cells.hpp"
#include "turns.hpp"

namespace bondem {

inline void follow_strain_factors(Index, const DeviceSpan &span, const Timeline &timeline, const Strain &strain,
                                  const StrainPortions &portions) {
    const Clock &clock = clock_of(span);
    const auto &factor = strain.factor;
    bool changed = clock.first, needed = clock.first;
    for (Index g = 0; g < strain.schedule.size(); g++) {
        factor(1, g) = value_at(timeline, strain.schedule(g), clock.time);
        changed |= factor(1, g) != factor(0, g);
        needed |= factor(1, g) != value_at(timeline, strain.schedule(g), clock.time + clock.dt);
    }
    portions.due(0) = changed;
    portions.due(1) = changed || needed;
}
inline void strain_portion(Index b, const Moving &all, const Strain &strain, const Beams &beams,
                           const StrainPortions &portions) {
    if (!portions.due(1)) return;
    const Index count = strain.schedule.size(), last = least((b + 1) * works_of_portion, strain.bond.size());
    for (Index g = 0; g < count; g++) portions.power(b, g) = 0.0;
    for (Index e = b * works_of_portion; e < last; e++) {
        if (portions.due(0)) stretch_beam(strain, beams, e);
        const double tension = tension_of(all, strain, beams, e);
        for (Index g = 0; g < count; g++) portions.power(b, g) -= tension * strain.length(e) * strain.part(g, e);
    }
}
inline void add_work_of_strains(Index, const DeviceSpan &span, const Strain &strain, const StrainPortions &portions,
                                const Rows &rows) {
    if (!portions.due(1)) return;
    const auto &factor = strain.factor;
    for (Index g = 0; g < strain.schedule.size(); g++) {
        double power = 0.0;
        for (Index b = 0; b < portions.power.size(); b++) power += portions.power(b, g);
        factor(3, g) = power;
        if (!clock_of(span).first)
            rows.work(strain.place) += 0.5 * (factor(2, g) + power) * (factor(1, g) - factor(0, g));
        factor(0, g) = factor(1, g);
        factor(2, g) = power;
    }
}

// ---- of cells

inline void follow_cell_factors(Index, const DeviceSpan &span, const Timeline &timeline, const CellStrains &strains) {
    strains.due(strain_due::levers) = follow_factors(clock_of(span), timeline, strains);
}
inline void stretch_facet_of_step(Index k, const CellStrains &strains, const ElasticFacets &facets) {
    if (strains.due(strain_due::levers)) stretch_facet(strains, facets, k);
}
inline void stretch_wall_of_step(Index w, const CellStrains &strains, const WallConstraints &walls) {
    if (strains.due(strain_due::levers)) stretch_wall(strains, walls, w);
}
constexpr auto sum_strain_portion = portion_of_bonds<sum_strain_powers>;
inline void begin_cell_strains(Index, const DeviceSpan &span, const Moving &all, const CellStrains &strains,
                               const WallConstraints &walls) {
    using namespace strain_factor;
    if (!clock_of(span).first) return;
    sum_all_powers(all, strains, walls);
    for (Index g = 0; g < strains.schedule.size(); g++) strains.factor(before, g) = strains.factor(after, g);
}
constexpr auto add_work_of_cell_strains = once<add_strain_work>;

}  // namespace bondem
