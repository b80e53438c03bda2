// Sums on a device: of portions, a thread each, then of groups of portions, then of these. The order depends on the number
// of elements, bonds and works only.
#pragma once
#include "../passes/record/reading.hpp"
#include "../passes/record/record.hpp"
#include "turns.hpp"

namespace bondem {

constexpr auto sum_portion_of_elements = portion_of_elements<sum_element_energies>;
inline void sum_portion_of_works(Index b, const Rows &rows, const WorkPortions &portions) {
    const Index last = least((b + 1) * works_of_portion, rows.work.size());
    double sum = 0.0, size = 0.0;
    for (Index r = b * works_of_portion; r < last; r++) {
        sum += rows.work(r);
        size += absolute(rows.work(r));
    }
    portions.works(b, 0) = sum;
    portions.works(b, 1) = size;
}

// Column k % 13 of group k / 13.
inline void fold_portions(Index k, const Portions &portions, const WorkPortions &works, const FoldedPortions &folded) {
    const Index group = k / device_sums, c = k % device_sums;
    const auto add_up = [&](const auto &from, Index column) {
        const Index last = least((group + 1) * portions_of_group, from.size());
        double sum = 0.0;
        for (Index q = group * portions_of_group; q < last; q++) sum += double(from(q, column));
        return sum;
    };
    folded.sums(group, c) = c < 4    ? add_up(portions.elements, c)
                            : c < 8  ? add_up(portions.bonds, c - 4)
                            : c < 11 ? add_up(portions.turned, c - 8)
                                     : add_up(works.works, c - 11);
}
// Column c of the present row of records.
inline void write_sum(Index c, const DeviceSpan &span, const FoldedPortions &folded, const HistoryRows &history) {
    double sum = 0.0;
    for (Index g = 0; g < folded.sums.size(); g++) sum += folded.sums(g, c);
    history.record(clock_of(span).record, c) = sum;
}

// Part k % each of the sum of gauge k / each.
inline void read_part_of_gauge(Index k, const Moving &all, const Rows &rows, const Gauges &gauges, const GaugeParts &to) {
    const Index g = k / to.each, part = k % to.each, first = gauges.start(g), count = gauges.start(g + 1) - first;
    const bool largest = gauges.reduction(g) == gauge_reduction::max_abs;
    if (gauges.quantity(g) >= gauge_quantity::of_walls) return;
    for (Index axis = 0; axis < 3; axis++) {
        double value = largest ? -infinity : 0.0;
        for (Index e = first + count * part / to.each; e < first + count * (part + 1) / to.each; e++) {
            const double x = gauge::read(all, rows, gauges.quantity(g), gauges.element(e), axis);
            value = largest ? most(value, absolute(x)) : value + x;
        }
        to.parts(k, axis) = value;
    }
}
// Component k % 3 of gauge k / 3, in the present row of records.
inline void write_gauge(Index k, const DeviceSpan &span, const Gauges &gauges, const GaugeParts &from,
                        const HistoryRows &history) {
    const Index g = k / 3, axis = k % 3, reduction = gauges.reduction(g);
    if (gauges.quantity(g) >= gauge_quantity::of_walls) return;
    double value = reduction == gauge_reduction::max_abs ? -infinity : 0.0;
    for (Index part = g * from.each; part < (g + 1) * from.each; part++) {
        const double x = from.parts(part, axis);
        value = reduction == gauge_reduction::max_abs ? most(value, x) : value + x;
    }
    const double count = double(gauges.start(g + 1) - gauges.start(g));
    history.record(clock_of(span).record, device_column::count + k) = reduction == gauge_reduction::mean ? value / count : value;
}

}  // namespace bondem
