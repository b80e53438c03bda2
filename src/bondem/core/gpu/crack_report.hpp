// Energies of bodies with cracks on a GPU, also of crushing, added up by one thread per range of facets or cells.
#pragma once
#include "crack_onset.hpp"
#include "record.hpp"

namespace bondem {

constexpr auto sum_stressed_portion = portion_of_elements<sum_stressed_dilatation>;
inline void sum_portion_of_cracks(Index b, const DeviceSpan &span, const Moving &all, const ElasticFacets &facets,
                                  const CohesiveCracks &cracks, const Ledger &ledger) {
    const Range range = portion_of(span, b, span.m);
    ModeSums sum = {};
    for (Index k = range.first; k < range.last; k++)
        if (is_treated(cracks, k)) add_energies_of_crack(all, facets, cracks, k, sum);
    sum.add_to(ledger);
}
inline void sum_portion_of_crushing(Index b, const DeviceSpan &span, const FacetStrengths &strengths,
                                    const CohesiveCracks &cracks, const Ledger &ledger) {
    const Range range = portion_of(span, b, span.m);
    add_up(ledger, history_column::crushing, range.first, range.last,
           [&](Index k) { return cracks.listed(k) != 0 ? crushed_by_facet(strengths, cracks, k) : 0.0; });
}
inline void write_all_crushing_of_facets(Index, const DeviceSpan &span, const Ledger &ledger, const EventLog &log,
                                         const HistoryRows &history) {
    const double sum = sum_of(ledger, history_column::crushing).take();
    history.record(clock_of(span).record, history_column::crushing) = sum - log.crushed(0);
}

}  // namespace bondem
