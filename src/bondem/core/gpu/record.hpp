// Energy balance and gauges on a GPU. The thread of a range of elements, or of a part of the elements of a gauge,
// adds their values to exact sums. A single thread checks the energy, or writes the balance. The thread of a
// component of a gauge writes its value to the history.
#pragma once
#include "../passes/record/reading.hpp"
#include "../passes/record/record.hpp"
#include "ranges.hpp"

namespace bondem {

constexpr auto sum_portion_of_elements = portion_of_elements<sum_element_energies>;
constexpr auto judge_all_energy = once<judge_energy>;
constexpr auto write_whole_ledger = once<write_ledger>;

// Adds part k % each of the elements of gauge k / each to its sums. Gauges of walls have another pass.
inline void read_part_of_gauge(Index k, const Moving &all, const Rows &rows, const Gauges &gauges, const GaugeParts &to) {
    const Index g = k / to.each, part = k % to.each, first = gauges.start(g), count = gauges.start(g + 1) - first;
    if (gauges.quantity(g) >= gauge_quantity::of_walls) return;
    for (Index axis = 0; axis < 3; axis++) {
        gauge::Reading sum;
        for (Index e = first + count * part / to.each; e < first + count * (part + 1) / to.each; e++)
            sum.add(gauge::read(all, rows, gauges.quantity(g), gauges.element(e), axis));
        exact_sum(to.sums, 3 * g + axis).add_shared(sum.sum);
        to.largest(k, axis) = sum.largest;
    }
}
// Writes component k % 3 of gauge k / 3 to the present row of the history, and clears its sum.
inline void write_gauge(Index k, const DeviceSpan &span, const Gauges &gauges, const GaugeParts &from,
                        const HistoryRows &history) {
    const Index g = k / 3, axis = k % 3;
    if (gauges.quantity(g) >= gauge_quantity::of_walls) return;
    gauge::Reading whole = {exact_sum(from.sums, k)};
    for (Index part = g * from.each; part < (g + 1) * from.each; part++) whole.largest = most(whole.largest, from.largest(part, axis));
    history.record(clock_of(span).record, history_column::count + k) =
        whole.reduced(gauges.reduction(g), gauges.start(g + 1) - gauges.start(g));
    exact_sum(from.sums, k) = {};
}

}  // namespace bondem
