// One load or one prescribed velocity of an element at the time of a step, in its row of the table `Rows`.
#pragma once
#include "../motion/elements.hpp"
#include "timeline.hpp"

namespace bondem {

// Adds load e to the force of its row, turned with its element if the load follows that.
inline void add_load(Index e, double time, const Timeline &timeline, const RowLoads &loads, const Moving &all,
                     const Rows &rows) {
    const double amplitude = value_at(timeline, loads.schedule(e), time);
    const Index r = loads.row(e), element = loads.turns(e);
    const double *value = &loads.value(e, 0);
    if (element < 0) {
        for (Index c = 0; c < 6; c++) rows.force(r, c) += amplitude * value[c];
        return;
    }
    const Quaternion<double> q = orientation(gather(all.pose.data, Short(element)));
    for (Index c = 0; c < 6; c += 3) {
        const Vector a = rotate(q, Vector{value[c], value[c + 1], value[c + 2]});
        for (Index axis = 0; axis < 3; axis++) rows.force(r, c + axis) += amplitude * a[axis];
    }
}

// Sets the velocity of drive e now and over the step that begins; for a displacement both are its mean in this step.
inline void drive_at(Index e, const Clock &clock, const Timeline &timeline, const Drives &drives, const Rows &rows) {
    const double t = clock.time, dt = clock.dt;
    const Index s = drives.schedule(e), r = drives.row(e), c = drives.dof(e);
    if (drives.rate(e)) {
        rows.full(r, c) = value_at(timeline, s, t);
        rows.half(r, c) = value_at(timeline, s, t + 0.5 * dt);
    } else {
        rows.half(r, c) = (value_at(timeline, s, t + dt) - value_at(timeline, s, t)) / dt;
        rows.full(r, c) = rows.half(r, c);
    }
}

// Adds moments on regions as forces and torques of their elements.
void follow_couples(const Range &range, const Timeline &timeline, const CoupleTable &couples, const Moving &all,
                    const Rows &rows);

}  // namespace bondem
