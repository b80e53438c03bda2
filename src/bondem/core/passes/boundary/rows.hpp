#pragma once
#include "../../steps.hpp"

namespace bondem {

// Leaves the forces of all rows at zero, for the loads that are added next.
void clear_row_forces(const Turn &turn, const Rows &rows);
// Adds forces and torques, those that turn with their elements turned.
void follow_loads(const Turn &turn, const Timeline &timeline, const RowLoads &loads, const Moving &all, const Rows &rows);
// Adds moments on regions as forces and torques of their elements.
void follow_couples(const Turn &turn, const Timeline &timeline, const CoupleTable &couples, const Moving &all,
                    const Rows &rows);
// Sets prescribed velocities at the time of the clock, and over the step that begins there.
void follow_drives(const Turn &turn, const Timeline &timeline, const Drives &drives, const Rows &rows);
// Sets rest lengths L (1 + ε*), and adds the work of the strains.
void follow_strains(const Turn &turn, const Timeline &timeline, const Strain &strain, const Moving &all,
                    const Beams &beams, const Rows &rows);

}  // namespace bondem
