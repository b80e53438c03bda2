// Stresses of elements of the non-local law from the forces of bonds and contacts, eq (1) of `laws/non_local.hpp`.
//
// The stress of an element is stored in its own frame, where a rotation of the whole body does not change it. Bonds
// use the mean of both ends along fixed axes, where the stress is stored too. Dashpots of bonds add nothing.
#include "../../registered.hpp"
#include "../../tables/non_local_tables.hpp"
#include "own_stress.hpp"

namespace bondem {
namespace {

// A group of as many elements as there are lanes; the last element fills an incomplete group.
struct Elements {
    Short place[lanes];

    BONDEM_INLINE Elements(Index first, Index last) {
        for (int n = 0; n < lanes; n++) place[n] = Short(least(first + n, last - 1));
    }
};

void turn(Index first, Index last, const double *pose, const LaggedStresses &stresses) {
    for (Index e = first; e < last; e += lanes) turn_stress(Elements(e, last).place, pose, stresses);
}

}  // namespace

// Turns the stresses of a step ago with their elements.
void turn_stresses(const Range &portion, const Moving &all, const LaggedStresses &stresses) {
    turn(portion.first, portion.last, all.pose.data, stresses);
}
BONDEM_PASS(turn_stresses, of_elements, "own pose stress; writes space")

// Turns the stresses of all elements in given poses.
Index turn_all_stresses(Index, const Poses &all, const LaggedStresses &stresses) {
    turn(0, all.pose.size(), all.pose.data, stresses);
    return 0;
}
BONDEM_CALL(turn_all_stresses, "")

// Adds moments of bonds of other domains to the stresses of shared elements, and sets their rows to zero.
void collect_moments(const Range &range, const StepBlocks &blocks, const LaggedStresses &stresses) {
    const Index n = stresses.inverse.size();
    for (Index e = range.first; e < range.last; e++)
        for (Index q = n + blocks.part(e); q < n + blocks.part(e + 1); q++)
            for (Index c = 0; c < 6; c++) {
                stresses.moment(range.element[e], c) += stresses.moment(q, c);
                stresses.moment(q, c) = 0.0;
            }
}
BONDEM_PASS(collect_moments, parts_of_shared, "changes moment")

// Finds the stresses of a portion of elements, and bounds of their principal stresses; sets the moments to zero.
void find_stresses(const Range &range, const Moving &all, const LaggedStresses &stresses) {
    for (Index e = range.first; e < range.last; e += lanes)
        find_stress(Elements(e, range.last).place, all.pose.data, stresses);
}
BONDEM_PASS(find_stresses, of_elements, "own pose; changes moment; writes space stress")

// Finds the stresses of the elements of a block, and bounds of their principal stresses; sets the moments to zero.
void find_stresses_of_block(const Range &range, const Moving &all, const LaggedStresses &stresses) {
    for (Index e = range.first; e < range.last; e += lanes)
        find_stress(Several(range, e, range.last).element, all.pose.data, stresses);
}
BONDEM_PASS(find_stresses_of_block, elements_of_blocks, "own pose; changes moment; writes space stress")

}  // namespace bondem
