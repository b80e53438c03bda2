// Boundary conditions and body forces on a GPU. A thread updates one element with boundary conditions, one prescribed
// degree of freedom, or one group of elements with body forces. A single thread adds moments on regions.
#pragma once
#include "../passes/boundary/following.hpp"
#include "ranges.hpp"

namespace bondem {

inline void clear_row(Index r, const Rows &rows) {
    for (Index c = 0; c < 6; c++) rows.force(r, c) = 0.0;
}
inline void follow_loads_of_row(Index r, const DeviceSpan &span, const Timeline &timeline, const RowLoads &loads,
                                const RowOrder &order, const Moving &all, const Rows &rows) {
    for (Index e = order.start(r); e < order.start(r + 1); e++)
        add_load(order.load(e), clock_of(span).time, timeline, loads, all, rows);
}
// Runs on one thread, because several moments may act on one element.
constexpr auto follow_all_couples = once<follow_couples>;
inline void follow_drive(Index e, const DeviceSpan &span, const Timeline &timeline, const Drives &drives, const Rows &rows) {
    drive_at(e, clock_of(span), timeline, drives, rows);
}
inline void follow_body_group(Index g, const DeviceSpan &span, const Timeline &timeline, const BodyForces &body) {
    Vector sum = {0.0, 0.0, 0.0};
    for (Index b = 0; b < body.schedule.size(); b++) {
        const double factor = value_at(timeline, body.schedule(b), clock_of(span).time);
        for (Index d = 0; d < 3; d++) sum[d] += body.member(g, b) * factor * body.pull(b, d);
    }
    for (Index d = 0; d < 3; d++) body.present(g, d) = sum[d];
}

}  // namespace bondem
