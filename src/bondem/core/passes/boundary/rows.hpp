// Moments on regions (`couples.cpp`), on the CPU and on a device.
#pragma once
#include "../../steps.hpp"

namespace bondem {

// Adds moments on regions as forces and torques of their elements.
void follow_couples(const Range &range, const Timeline &timeline, const CoupleTable &couples, const Moving &all,
                    const Rows &rows);

}  // namespace bondem
