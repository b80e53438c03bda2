// Check whether a list of contacts is still valid. The list has all pairs with a gap of at most twice a given
// distance, its reach. No other pair therefore touches before an element or a wall has moved by the reach.
//
// Distances of listed pairs are measured only after some motion. The largest motion since the list was made is at
// most the sum of the largest motions before and after measuring. One pass over the elements thus decides whether the
// list is valid, and whether to measure again.
#include "contact_passes.hpp"

#include "../../registered.hpp"
#include "pairs.hpp"
#include "wall_shapes.hpp"

namespace bondem {
namespace {

double wall_travel(const Walls &walls, double reach) {
    double farthest = 0.0;
    for (Index w = 0; w < walls.body.size(); w++) farthest = most(farthest, travel_of_wall(walls, w, reach));
    return farthest;
}

}  // namespace

// Finds the largest motion of the elements of a portion since distances were measured.
void measure_travel(const Range &range, const Moving &all, const Travel &travel) {
    double farthest = 0.0;
    bool finite = true;
    for (Index p = range.first; p < range.last; p++) {
        const Vector moved = centre(all.pose.data, Short(p)) - travel.measured.row<const Vector>(p);
        const double square = dot(moved, moved);
        finite &= square < infinity;
        farthest = most(farthest, square);
    }
    travel.portion(range.block, 0) = finite ? farthest : infinity;
}
BONDEM_PASS(measure_travel, of_elements, "")

// Marks the list of contacts as out of date if it may miss a contact, or if a centre is not finite.
void check_travel(const Range &, const Travel &travel, const Walls &walls, const Ledger &ledger) {
    double farthest = 0.0;
    for (Index q = 0; q < travel.portion.size(); q++) farthest = most(farthest, travel.portion(q, 0));
    travel.far(0) = root(farthest);
    const bool valid = travel.far(0) + most(travel.far(1), 0.0) < travel.reach && wall_travel(walls, travel.reach) < travel.reach;
    ledger.found(guard_number::out_of_date) = !valid;
    if (travel.far(1) < 0.0) travel.far(0) = infinity;  // distances have not been measured yet
}
BONDEM_PASS(check_travel, single, "")

// Stores the largest motion since the list was made, in a step that measures distances.
void keep_measures(const Range &range, const NearPairs &near, const Travel &travel) {
    if (!measures_anew(range, near, travel)) return;
    double farthest = 0.0;
    for (Index q = 0; q < travel.portion.size(); q++) farthest = most(farthest, travel.portion(q, 1));
    travel.far(0) = 0.0;
    travel.far(1) = root(farthest);
}
BONDEM_PASS(keep_measures, single, "")

}  // namespace bondem
