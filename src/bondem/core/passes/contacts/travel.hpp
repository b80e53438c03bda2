#pragma once
#include "../../steps.hpp"
#include "../../tables/contact_tables.hpp"

namespace bondem {

// Whether distances are measured anew in this step: an element has moved too far since, or may be anywhere.
inline bool measures_anew(const Turn &turn, const NearPairs &near, const Travel &travel) {
    return turn.clock.dt == 0.0 || !(travel.far(0) <= near.width);
}

}  // namespace bondem
