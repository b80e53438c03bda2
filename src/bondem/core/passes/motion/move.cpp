// Passes that move elements by the sums of the forces on them (`moving.hpp`), and clear these sums. The elements
// close a step and, unless the run pauses, open the next one.
#include "../../registered.hpp"
#include "moving.hpp"

namespace bondem {
namespace {

// Distance in elements at which rows are prefetched.
constexpr Index ahead = 32;

// The sum of loads in the row of an element, or of several, which is set to zero.
template <class Who> BONDEM_INLINE Wrench<typename Who::Number> taken(double *sums, const Who &who) {
    const Wrench<typename Who::Number> load(gather(sums, who.row));
    clear(sums, who.row);
    return load;
}

template <class Resisted>
BONDEM_INLINE void move_free(const Range &range, const Moving &all, const StepBlocks &blocks,
                             const Resisted &resistance) {
    const Index last = range.first_owner;
    for (Index e = range.first; e < last; e += lanes) {
        const Several later(range, least(e + ahead, last - 1), last);
        prefetch(all.pose.data, later.element);
        prefetch(all.motion.data, later.element);
        const Several several(range, e, last);
        move(several, range.clock, all, taken(blocks.sums.data, several), NoRow{}, resistance, -1);
    }
}

template <class Resisted>
inline void move_owners(const Range &range, const Moving &all, const StepBlocks &blocks, const Rows &rows,
                        const Resisted &resistance) {
    for (Index e = range.first_owner; e < range.last; e++) {
        const One one(range, e);
        const Index r = rows.of(one.element);
        move(one, range.clock, all, taken(blocks.sums.data, one), BoundaryRow(rows, r), resistance, r);
    }
}

}  // namespace

// Closes the step, and opens the next, for elements that own no row of the boundary.
void move_elements(const Range &range, const Moving &all, const StepBlocks &blocks) {
    move_free(range, all, blocks, NoRow{});
}
BONDEM_PASS(move_elements, elements_of_blocks, "changes acceleration motion pose sums")

// Closes the step, and opens the next, for damped elements that own no row of the boundary.
void move_resisted(const Range &range, const Moving &all, const StepBlocks &blocks, const Resistance &resistance) {
    move_free(range, all, blocks, resistance);
}
BONDEM_PASS(move_resisted, elements_of_blocks, "changes acceleration dashed loss motion pose sums")

// Closes the step, and opens the next, for elements that own rows of the boundary.
void move_rows(const Range &range, const Moving &all, const StepBlocks &blocks, const Rows &rows) {
    move_owners(range, all, blocks, rows, NoRow{});
}
BONDEM_PASS(move_rows, elements_of_blocks, "own force full half; changes acceleration motion pose sums; writes reaction")

// Closes the step, and opens the next, for damped elements that own rows of the boundary.
void move_resisted_rows(const Range &range, const Moving &all, const StepBlocks &blocks, const Rows &rows,
                        const Resistance &resistance) {
    move_owners(range, all, blocks, rows, resistance);
}
BONDEM_PASS(move_resisted_rows, elements_of_blocks, "own force full half; changes acceleration dashed loss motion pose sums; writes reaction")

// Opens a step after a pause for all elements, none of which owns a row of the boundary.
void open_elements(const Range &range, const Moving &all) {
    for (Index p = range.first; p < range.last; p++) open_one(p, range.clock, all, NoRow{});
}
BONDEM_PASS(open_elements, of_elements, "own acceleration; changes motion pose")

// Opens a step after a pause for all elements, some of which own rows of the boundary.
void open_elements_and_rows(const Range &range, const Moving &all, const Rows &rows) {
    for (Index p = range.first; p < range.last; p++) {
        const Index r = rows.of(p);
        if (r < 0)
            open_one(p, range.clock, all, NoRow{});
        else
            open_one(p, range.clock, all, BoundaryRow(rows, r));
    }
}
BONDEM_PASS(open_elements_and_rows, of_elements, "own acceleration half; changes motion pose")

// Opens a step for elements of a list that own no row of the boundary.
void reopen_elements(const Range &range, const Moving &all) {
    for (Index e = range.first; e < range.first_owner; e++) open_one(range.element[e], range.clock, all, NoRow{});
}
BONDEM_PASS(reopen_elements, elements_of_blocks, "own acceleration; changes motion pose")

// Opens a step for elements of a list that own rows of the boundary.
void reopen_rows(const Range &range, const Moving &all, const Rows &rows) {
    for (Index e = range.first_owner; e < range.last; e++) {
        const Short p = range.element[e];
        open_one(p, range.clock, all, BoundaryRow(rows, rows.of(p)));
    }
}
BONDEM_PASS(reopen_rows, elements_of_blocks, "own acceleration half; changes motion pose")

}  // namespace bondem
