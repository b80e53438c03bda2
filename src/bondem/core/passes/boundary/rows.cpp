#include "rows.hpp"

#include "../motion/elements.hpp"
#include "timeline.hpp"

namespace bondem {

void clear_row_forces(const Turn &, const Rows &rows) {
    for (Index r = 0; r < rows.force.size(); r++)
        for (Index c = 0; c < 6; c++) rows.force(r, c) = 0.0;
}

void follow_loads(const Turn &turn, const Timeline &timeline, const RowLoads &loads, const Moving &all, const Rows &rows) {
    for (Index e = 0; e < loads.row.size(); e++) {
        const double amplitude = value_at(timeline, loads.schedule(e), turn.clock.time);
        const Index r = loads.row(e), element = loads.turns(e);
        const double *value = &loads.value(e, 0);
        if (element < 0) {
            for (Index c = 0; c < 6; c++) rows.force(r, c) += amplitude * value[c];
            continue;
        }
        const Quaternion<double> q = orientation(gather(all.pose.data, Short(element)));
        for (Index c = 0; c < 6; c += 3) {
            const Vector a = rotate(q, Vector{value[c], value[c + 1], value[c + 2]});
            for (Index axis = 0; axis < 3; axis++) rows.force(r, c + axis) += amplitude * a[axis];
        }
    }
}

void follow_drives(const Turn &turn, const Timeline &timeline, const Drives &drives, const Rows &rows) {
    const double t = turn.clock.time, dt = turn.clock.dt;
    for (Index e = 0; e < drives.row.size(); e++) {
        const Index s = drives.schedule(e), r = drives.row(e), c = drives.dof(e);
        if (drives.rate(e)) {
            rows.full(r, c) = value_at(timeline, s, t);
            rows.half(r, c) = value_at(timeline, s, t + 0.5 * dt);
        } else {
            rows.half(r, c) = (value_at(timeline, s, t + dt) - value_at(timeline, s, t)) / dt;
            rows.full(r, c) = rows.half(r, c);
        }
    }
}

}  // namespace bondem
