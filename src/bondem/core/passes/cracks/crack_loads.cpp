// Passes for forces, torques, energies and dissipation of active cracks, their sums on cells, and events of breaking.
#include "crack_passes.hpp"

#include "../../ledger.hpp"
#include "../../registered.hpp"
#include "../cells/walls.hpp"
#include "../../tables/columns.hpp"
#include "loaded_cracks.hpp"

namespace bondem {

#if defined(BONDEM_LANES)

// Computes forces, torques and dissipation of the active cracks.
void load_cracks(const Range &range, const Moving &all, const ElasticFacets &facets, const FacetStrengths &strengths,
                 const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists) {
    const bool changes = range.clock.dt > 0.0;
    const Index count = lists.size(list_count::treated);
    over_places(range, count, [&](Index first, Index last, Index portion) {
        ExactSum lost = {};
        for_each_group_of(lists, first, last, count, [&](const CrackGroup &group) {
            load_each(group, all, facets.period.data, strengths, stresses, cracks, lists, portion, changes, lost);
        });
        exact_sum(lists.lost, 0).add_shared(lost);
    });
}
BONDEM_PASS(load_cracks, of_cracks, "own tensor; ends pose pose.stress; adds half")

#endif

// Adds up the dissipation of cracks, and logs cracks that have lost all integrity in this step.
void log_cracks(const Range &range, const Moving &all, const ElasticFacets &facets, const CohesiveCracks &cracks,
                const CrackLists &lists, const EventLog &log) {
    if (!(range.clock.dt > 0.0)) return;
    const Index count = lists.size(list_count::treated);
    log.released(0) += exact_sum(lists.lost, 0).take();
    log.written(log_count::before) = log.written(log_count::events);
    for (Index q = 0; q < portions(count, crack::of_portion); q++) {
        if (lists.flagged(q) != 2) continue;
        for (Index e = q * crack::of_portion; e < least(count, (q + 1) * crack::of_portion); e++) {
            if (lists.flag(e) != crack::fell) continue;
            log_crack(range.clock, all, facets, cracks, log, lists.treated(e));
        }
    }
}
BONDEM_PASS(log_cracks, of_events, "ends pose")

void add_crack_loads(const Range &range, const Moving &all, const CrackLists &lists, const StepBlocks &blocks) {
    for (Index at = range.first; at < range.last; at++) {
        const Short p = range.element[at];
        if (lists.head(p) == 0) continue;
        const double *const sum = &lists.sum(p, 0);
        all.loss(p, rubbed_loss) += sum[3];
        double *const to = &blocks.sums(range.row[at], 0);
        for (int d = 0; d < 3; d++) to[d] += sum[d], to[4 + d] += sum[4 + d];
    }
}
BONDEM_PASS(add_crack_loads, elements_of_blocks, "own sum; changes loss sums")

void sum_stressed_dilatation(const Range &range, const Moving &all, const CellDilatation &cells,
                             const Ledger &ledger) {
    add_up(ledger, history_column::normal, range.first, range.last, [&](Index p) {
        const double stress = all.pose(p, stress_column), weight = cells.weight(p);
        return weight != 0.0 ? 0.5 * stress * stress / weight : 0.0;
    });
}
BONDEM_PASS(sum_stressed_dilatation, of_elements, "")

void sum_heat(const Range &range, const StressesOfCells &stresses, const YieldingCells &cells,
              const Ledger &ledger) {
    add_up(ledger, history_column::plastic, range.first, range.last, [&](Index p) {
        const double *const row = &cells.plastic(p, 0), *const s = &stresses.tensor(p, 0), *const e = row + 10;
        if (row[9] == 0.0) return 0.0;
        const double work = s[0] * e[0] + s[1] * e[1] + s[2] * e[2] + 2.0 * (s[3] * e[3] + s[4] * e[4] + s[5] * e[5]);
        return row[16] + 0.5 * stresses.volume(p) * work;
    });
}
BONDEM_PASS(sum_heat, of_elements, "")

// Sums the energies of the active cracks [J].
void sum_crack_energies(const Range &, const Moving &all, const ElasticFacets &facets, const CohesiveCracks &cracks,
                        const Ledger &ledger) {
    ModeSums sum = {};
    for (Index c = 0; c < cracks.size(crack_number::cracks); c++) {
        const Index k = cracks.order(c);
        if (history_of(cracks, k).status == crack::active) add_energies_of_crack(all, facets, cracks, k, sum);
    }
    sum.add_to(ledger);
}
BONDEM_PASS(sum_crack_energies, of_cracks, "ends pose pose.stress")

// Writes the energy that facets have released beyond their fracture energy in this run [J].
void write_crushing_of_facets(const Range &range, const FacetStrengths &strengths, const CohesiveCracks &cracks,
                              const EventLog &log, const HistoryRows &history) {
    ExactSum sum = {};
    for (Index c = 0; c < cracks.size(crack_number::cracks); c++)
        sum.add(crushed_by_facet(strengths, cracks, cracks.order(c)));
    history.record(range.clock.record, history_column::crushing) = sum.value() - log.crushed(0);
}
BONDEM_PASS(write_crushing_of_facets, of_cracks, "")

}  // namespace bondem
