// Loads and prescribed velocities at the time of a step, for the rows of the table `Rows`: one row per element with
// boundary conditions.
#include "../../registered.hpp"
#include "following.hpp"

namespace bondem {

// Sets the forces of all rows to zero, before loads are added.
void clear_row_forces(const Range &, const Rows &rows) {
    for (Index r = 0; r < rows.force.size(); r++)
        for (Index c = 0; c < 6; c++) rows.force(r, c) = 0.0;
}
BONDEM_PASS(clear_row_forces, of_rows, "writes force")

// Adds forces and torques of loads to their rows, turned with the element if they follow it.
void follow_loads(const Range &range, const Timeline &timeline, const RowLoads &loads, const Moving &all, const Rows &rows) {
    for (Index e = 0; e < loads.row.size(); e++) add_load(e, range.clock.time, timeline, loads, all, rows);
}
BONDEM_PASS(follow_loads, of_rows, "changes force")

// Sets prescribed velocities at the time of the clock, and over the step that begins there.
void follow_drives(const Range &range, const Timeline &timeline, const Drives &drives, const Rows &rows) {
    for (Index e = 0; e < drives.row.size(); e++) drive_at(e, range.clock, timeline, drives, rows);
}
BONDEM_PASS(follow_drives, of_rows, "changes full half")

}  // namespace bondem
