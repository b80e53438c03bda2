// The value of a schedule: piecewise linear in time, constant beyond its ends; of a jump, the later value.
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

}  // namespace bondem
