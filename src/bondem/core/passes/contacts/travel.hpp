#pragma once
#include "../../steps.hpp"
#include "../../tables/contact_tables.hpp"

namespace bondem {

// Whether distances are measured anew in this step: an element has moved too far since, or may be anywhere.
inline bool measures_anew(const Turn &turn, const NearPairs &near, const Travel &travel) {
    return turn.clock.dt == 0.0 || !(travel.far(0) <= near.width);
}

// Finds how far the elements of a portion are from where distances were measured.
void measure_travel(const Turn &turn, const Moving &all, const Travel &travel);
// Finds whether the list may miss a contact by now, also where a centre is not a number.
void check_travel(const Turn &turn, const Travel &travel, const Walls &walls, const Portions &portions);
// Takes over what was measured anew in a step.
void keep_measures(const Turn &turn, const NearPairs &near, const Travel &travel);

}  // namespace bondem
