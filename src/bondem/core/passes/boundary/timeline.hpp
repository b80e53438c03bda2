// Value and integral of a schedule, linear between its times and constant beyond. At a jump the later value counts.
#pragma once
#include "../../tables/step_tables.hpp"

namespace bondem {

inline double value_at(const Timeline &timeline, Index schedule, double t) {
    const Index first = timeline.start(schedule), last = timeline.start(schedule + 1);
    const auto &times = timeline.times, &values = timeline.values;
    if (t < times(first)) return values(first);
    Index k = first;
    while (k + 1 < last && times(k + 1) <= t) k++;
    if (k + 1 >= last) return values(last - 1);
    return values(k) + (values(k + 1) - values(k)) * ((t - times(k)) / (times(k + 1) - times(k)));
}

// The integral of a schedule from time 0 to t.
inline double integral_to(const Timeline &timeline, Index schedule, double t) {
    const Index first = timeline.start(schedule), last = timeline.start(schedule + 1);
    double total = 0.0, before = 0.0, value = value_at(timeline, schedule, 0.0);
    for (Index k = first; k < last; k++) {
        const double knot = timeline.times(k);
        if (!(0.0 < knot && knot < t)) continue;
        total += 0.5 * (knot - before) * (value + timeline.values(k));  // up to a jump the earlier value holds
        before = knot, value = timeline.values(k);
    }
    return total + 0.5 * (t - before) * (value + value_at(timeline, schedule, t));
}

}  // namespace bondem
