// Steps in which distances between elements are measured anew.
#pragma once
#include "../../steps.hpp"
#include "../../tables/contact_tables.hpp"

namespace bondem {

// True if distances are measured in this step: it has no duration, or an element has moved too far since the last
// time, or its place is not finite.
inline bool measures_anew(const Range &range, const NearPairs &near, const Travel &travel) {
    return range.clock.dt == 0.0 || !(travel.far(0) <= near.width);
}

}  // namespace bondem
