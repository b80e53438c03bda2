// Energies of bodies with cracks on a device, portion by portion.
#pragma once
#include "crack_onset.hpp"
#include "record.hpp"

namespace bondem {

constexpr auto sum_stressed_portion = portion_of_elements<sum_stressed_dilatation>;
inline void sum_portion_of_cracks(Index b, const DeviceSpan &span, const Moving &all, const ElasticFacets &facets,
                                  const CohesiveCracks &cracks, const CrackPortions &found) {
    const Index last = least((b + 1) * bonds_of_portion, span.m);
    Vector sum = {};
    for (Index k = b * bonds_of_portion; k < last; k++)
        if (is_treated(cracks, k)) add_energies_of_crack(all, facets, cracks, k, sum);
    found.energy.row<Vector>(b) = sum;
}
inline void add_energies_of_cracks(Index, const WallEnergy &of_walls, const CrackEnergies &found,
                                   const CrackPortions &of_cracks, const Portions &portions) {
    Vector sum = {};
    for (Index b = 0; b < of_cracks.energy.size(); b++) sum = sum + of_cracks.energy.row<Vector>(b);
    for (Index q = 0; q < found.dilatation.size(); q++) sum.x += found.dilatation(q);
    for (Index q = 0; q < of_walls.energy.size(); q++) sum.x += of_walls.energy(q);
    if (portions.bonds.size() == 0) return;
    for (Index d = 0; d < 3; d++) portions.bonds(0, d) += sum[d];
}
inline void write_energy_of_yielding(Index, const DeviceSpan &span, const CrackEnergies &found,
                                     const HistoryRows &history) {
    double heat = 0.0;
    for (Index q = 0; q < found.heat.size(); q++) heat += found.heat(q);
    history.record(clock_of(span).record, device_column::plastic) = heat;
}
inline void sum_portion_of_crushing(Index b, const DeviceSpan &span, const FacetStrengths &strengths,
                                    const CohesiveCracks &cracks, const CrushingPortions &found) {
    const Index last = least((b + 1) * bonds_of_portion, span.m);
    double sum = 0.0;
    for (Index k = b * bonds_of_portion; k < last; k++)
        if (cracks.listed(k) != 0) sum += crushed_by_facet(strengths, cracks, k);
    found.energy(b) = sum;
}
inline void write_all_crushing_of_facets(Index, const DeviceSpan &span, const CrushingPortions &found, const EventLog &log,
                                         const HistoryRows &history) {
    double sum = 0.0;
    for (Index b = 0; b < found.energy.size(); b++) sum += found.energy(b);
    history.record(clock_of(span).record, device_column::crushing) = sum - log.crushed(0);
}

}  // namespace bondem
